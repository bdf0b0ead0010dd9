"""Statistics by the words that a claim uses for them: "median", "q1 by weibull", "success rate"."""

import math
import re
from collections.abc import Callable
from functools import partial
from typing import cast

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError
from repro.statistics.quantiles import (
    METHODS,
    QuantileMethod,
    interquartile_range,
    median,
    quantile,
    successes,
)
from repro.statistics.summary import STATISTICS, standard_deviation

Vector = NDArray[np.float64]
Function = Callable[[Vector], Vector]
KNOWN = (
    *STATISTICS,
    *("median", "variance", "standard error", "iqr", "q1", "q3", "q05 and the like"),
    *("success rate at 1e-8", "success share at 1e-8", "successes at 1e-8"),
)
"""What may be asked for; quantiles also as "q1 by weibull", with any of numpy's nine names."""
_QUANTILE = re.compile(
    r"(?P<name>iqr|q(?P<digits>[123]|\d\d(?:\.\d+)?|[1-9]\.\d+))(?: by (?P<method>\w+))?"
)
_SUCCESS = re.compile(r"(?P<kind>successes|success rate|success share) at (?P<threshold>\S+)")
_QUARTERS = ("1", "2", "3")
_SPREADS = ("std", "variance", "standard error", "iqr")


def statistic_named(word: str) -> Function:
    """Return the statistic of that name; InputError, with what there is, for an unknown one.

    "q1" and "q3" are the quartiles, "q05" what 5 % of the runs do not exceed; "q05 by hazen"
    takes another of the nine definitions than numpy's "linear". "success rate at 1e-8" is the
    share of runs that end there or below, in %, "success share at 1e-8" the same out of 1,
    "successes at 1e-8" their number.
    """
    if word in STATISTICS:
        return STATISTICS[word]
    plain: dict[str, Function] = {
        "median": median,
        "variance": _variance,
        "standard error": _standard_error,
    }
    found = plain.get(word) or _quantile(word) or _success(word)
    if found is None:
        message = f"no statistic {word!r}; there are {', '.join(KNOWN)}"
        raise InputError(message)
    return found


def is_known(word: str) -> bool:
    """Say whether there is a statistic of that name."""
    try:
        statistic_named(word)
    except InputError:
        return False
    return True


def is_spread(word: str) -> bool:
    """Say whether the statistic is 0 where all runs are equal, whatever they are."""
    return word.partition(" by ")[0] in _SPREADS


def is_count(word: str) -> bool:
    """Say whether the statistic counts runs, so that it is no cost."""
    return _SUCCESS.fullmatch(word) is not None


def is_of_extremes(word: str, runs: int) -> bool:
    """Say whether, of so many runs, the statistic hangs on the least or the greatest one."""
    if word in ("best", "worst"):
        return True
    match = _QUANTILE.fullmatch(word)
    if match is None or match["digits"] is None:
        return False
    share = _share(match["digits"])
    return min(share, 1.0 - share) * (runs - 1) < 1.0


def _variance(costs: Vector) -> Vector:
    """Return the square of the sample standard deviation."""
    with np.errstate(over="ignore", under="ignore"):
        return np.asarray(standard_deviation(costs) ** 2)


def _standard_error(costs: Vector) -> Vector:
    """Return the sample standard deviation over the root of the number of runs."""
    return np.asarray(standard_deviation(costs) / math.sqrt(costs.shape[-1]))


def _quantile(word: str) -> Function | None:
    match = _QUANTILE.fullmatch(word)
    if match is None:
        return None
    method = match["method"] or "linear"
    if method not in METHODS:
        message = f"statistic {word!r}: no definition {method!r}; there are {', '.join(METHODS)}"
        raise InputError(message)
    chosen = cast("QuantileMethod", method)
    if match["digits"] is None:
        return partial(interquartile_range, method=chosen)
    return partial(quantile, share=_share(match["digits"]), method=chosen)


def _share(digits: str) -> float:
    """Return 0.25 for "1", a quartile, and 0.05 for "05", which counts percent."""
    return int(digits) / 4 if digits in _QUARTERS else float(digits) / 100


def _success(word: str) -> Function | None:
    match = _SUCCESS.fullmatch(word)
    if match is None:
        return None
    try:
        threshold = float(match["threshold"])
    except ValueError:
        threshold = math.nan
    if not math.isfinite(threshold):
        message = f"statistic {word!r}: the threshold {match['threshold']!r} is no finite number"
        raise InputError(message)
    return partial(_SUCCESSES[match["kind"]], threshold=threshold)


def _success_share(costs: Vector, threshold: float) -> Vector:
    return np.asarray(successes(costs, threshold) / costs.shape[-1])


def _success_rate(costs: Vector, threshold: float) -> Vector:
    return np.asarray(100.0 * successes(costs, threshold) / costs.shape[-1])


_SUCCESSES: dict[str, Callable[..., Vector]] = {
    "successes": successes,
    "success share": _success_share,
    "success rate": _success_rate,
}
