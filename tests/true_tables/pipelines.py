"""From runs to what is printed of them: precision, order and way of summing, digits."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_DOWN, ROUND_HALF_UP, Context, Decimal
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from repro.tables.arithmetic import CONDITIONS
from repro.tables.order import ONE_DEFINITION
from repro.tables.senses import LEAST_IS_BEST
from tests.true_tables.samples import Generator, Vector

PRECISIONS = ("single", "double", "runs in single")
SUMS = ("in turn", "pairwise", "exact")
SPREADS = ("two passes", "mean of squares", "sum of squares", "updated")
PRINTS = (
    *("scientific", "fixed", "significant", "general", "four digits of R", "cut off", "fixed cut"),
    *("rounded twice",),
)
QUANTILES: tuple[Any, ...] = (
    *("inverted_cdf", "averaged_inverted_cdf", "closest_observation", "interpolated_inverted_cdf"),
    *("hazen", "weibull", "linear", "median_unbiased", "normal_unbiased", "lower", "higher"),
    *("midpoint", "nearest"),
)
MIDDLES = ("mean of two", "lower", "upper")
GREATEST_FIXED = 1e15


@dataclass(frozen=True, slots=True, kw_only=True)
class Pipeline:
    """How a table was made of its runs."""

    precision: str
    sums: str
    spread: str
    ddof: int
    backwards: bool
    quantiles: Any
    middle: str
    prints: str
    digits: int
    mixed: bool  # every number with digits of its own
    maximise: bool

    @property
    def broken(self) -> frozenset[str]:
        """Conditions of audit rows that it does not meet, each by its words in CONDITIONS."""
        found = []
        if self.precision != "double":
            found.append("doubles")
        if self.spread in {"mean of squares", "sum of squares"}:
            found.append("two_pass")
        if self.prints in {"four digits of R", "significant"}:
            found.append("whole")
        sense = (LEAST_IS_BEST,) if self.maximise else ()
        return frozenset((*(CONDITIONS[name] for name in found), *sense, ONE_DEFINITION))

    @property
    def words(self) -> str:
        """The pipeline in a line."""
        parts = (
            *(f"{self.precision}, {self.sums}, {self.spread}, n-{self.ddof}", self.quantiles),
            *(self.middle, f"{self.prints} {self.digits}"),
            *(word for word in ("backwards", "mixed", "maximise") if getattr(self, word)),
        )
        return ", ".join(map(str, parts))


def drawn_pipeline(rng: Generator, *, maximise: bool = False) -> Pipeline:
    """Return one of all the combinations, each choice on its own."""

    def one(choices: tuple[Any, ...]) -> Any:  # noqa: ANN401 (of whatever kind they are)
        return choices[int(rng.integers(len(choices)))]

    return Pipeline(
        precision=one(PRECISIONS),
        sums=one(SUMS),
        spread=one(SPREADS),
        ddof=one((0, 1)),
        backwards=one((False, True)),
        quantiles=one(QUANTILES),
        middle=one(MIDDLES),
        prints=one(PRINTS),
        digits=int(rng.integers(2, 10)),
        mixed=rng.random() < 0.2,
        maximise=maximise,
    )


def statistics_of(runs: Vector, pipeline: Pipeline, names: tuple[str, ...]) -> dict[str, float]:
    """Return the finite statistics of some names that a program computes of the runs it keeps."""
    kept: NDArray[Any] = runs.astype(np.float64 if pipeline.precision == "double" else np.float32)
    kept = kept[:: -1 if pipeline.backwards else 1]
    if pipeline.precision == "runs in single":
        kept = kept.astype(np.float64)
    with np.errstate(all="ignore"):
        mean = kept.dtype.type(_sum(kept, pipeline.sums) / kept.dtype.type(len(kept)))
        found = {"lowest": kept.min(), "mean": mean, "highest": kept.max()}
        if not {"std", "variance", "sem"}.isdisjoint(names):
            found |= _spreads(kept, mean, pipeline)
        if "median" in names:
            found["median"] = _median(np.sort(kept), pipeline.middle)
        if not {"q1", "q3", "iqr"}.isdisjoint(names):
            ends = np.percentile(kept, [25, 75], method=pipeline.quantiles)
            found |= {"q1": ends[0], "q3": ends[1], "iqr": ends[1] - ends[0]}
    found["best"], found["worst"] = (
        (found["highest"], found["lowest"])
        if pipeline.maximise
        else (found["lowest"], found["highest"])
    )
    return {name: float(found[name]) for name in names if math.isfinite(found[name])}


def _sum(values: NDArray[Any], how: str) -> Any:  # noqa: ANN401 (a float or a double)
    if how == "in turn":
        return np.cumsum(values, dtype=values.dtype)[-1]
    if how == "pairwise":
        return np.ascontiguousarray(values).sum(dtype=values.dtype)
    return values.dtype.type(math.fsum(values.tolist())) if np.isfinite(values).all() else math.inf


def _spreads(kept: NDArray[Any], mean: Any, pipeline: Pipeline) -> dict[str, Any]:  # noqa: ANN401
    kind = kept.dtype.type
    n, degrees = kind(len(kept)), kind(len(kept) - pipeline.ddof)
    if pipeline.spread == "two passes":
        squares = _sum((kept - mean) ** 2, pipeline.sums)
    elif pipeline.spread == "mean of squares":
        squares = (_sum(kept * kept, pipeline.sums) / n - mean * mean) * n
    elif pipeline.spread == "sum of squares":
        total = _sum(kept, pipeline.sums)
        squares = _sum(kept * kept, pipeline.sums) - total * total / n
    else:
        squares = _updated(kept)
    variance = kind(max(kind(squares), kind(0)) / degrees)
    std = np.sqrt(variance)
    return {"variance": variance, "std": std, "sem": std / np.sqrt(n)}


def _updated(kept: NDArray[Any]) -> Any:  # noqa: ANN401
    """Return the sum of squares by Welford's way: Technometrics 4 (1962) 419-420."""
    kind = kept.dtype.type
    if kind is np.float64:  # Python's own floats are the same doubles, and faster
        mean, squares = 0.0, 0.0
        for k, value in enumerate(kept.tolist(), 1):
            apart = value - mean
            mean += apart / k
            squares += apart * (value - mean)
        return squares
    mean_, squares_ = kind(0), kind(0)
    for k, value in enumerate(kept, 1):
        apart = value - mean_
        mean_ = mean_ + apart / kind(k)
        squares_ = squares_ + apart * (value - mean_)
    return squares_


def _median(ordered: NDArray[Any], middle: str) -> Any:  # noqa: ANN401
    low, high = ordered[(len(ordered) - 1) // 2], ordered[len(ordered) // 2]
    if middle == "mean of two":
        return (low + high) / ordered.dtype.type(2)
    return low if middle == "lower" else high


def texts_of(values: Mapping[str, float], pipeline: Pipeline, rng: Generator) -> dict[str, str]:
    """Return the statistics as they are printed."""
    digits = [
        int(rng.integers(2, 10)) if pipeline.mixed else pipeline.digits for _ in range(len(values))
    ]
    return {
        name: printed(value, pipeline.prints, kept)
        for (name, value), kept in zip(values.items(), digits, strict=True)
    }


def printed(value: float, how: str, digits: int) -> str:
    """Return a number as a table prints it, with so many digits or decimals."""
    if how in {"fixed", "fixed cut"} and abs(value) < GREATEST_FIXED:
        if how == "fixed":
            return f"{value:.{digits}f}"
        step = Decimal(1).scaleb(-digits)
        return f"{Decimal(value).quantize(step, ROUND_DOWN, Context(prec=40)):f}"
    if how == "general":
        return f"{value:.{digits}g}"
    if how == "four digits of R":
        return f"{float(f'{value:.3e}'):.15g}"
    if how == "significant":  # without powers of ten as far as they go
        return f"{float(f'{value:.{digits - 1}e}'):.15g}"
    if how == "rounded twice":
        value = float(f"{value:.{digits}e}")
    rounding: Literal["ROUND_DOWN", "ROUND_HALF_UP"] = (
        ROUND_DOWN if how == "cut off" else ROUND_HALF_UP
    )
    number = Context(prec=digits, rounding=rounding).create_decimal(Decimal(value))
    return f"{number:.{digits - 1}e}"
