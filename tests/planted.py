"""Errors planted into true tables, and the share of them that the audit finds."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text
from repro.tables.rows import Grade
from tests.true_tables.pipelines import Pipeline, statistics_of
from tests.true_tables.samples import Generator, Vector, named_rng

RUNS = 30
SEED = "planted errors"
SETS = (
    ("mean", "std"),
    ("best", "mean", "std"),
    ("mean", "median", "std"),
    ("best", "mean", "worst", "std"),
    ("best", "mean", "median", "worst", "std"),
)
WHOLE = ("mean", "std of whole numbers")
PLAIN = Pipeline(
    precision="double",
    sums="pairwise",
    spread="two passes",
    ddof=1,
    backwards=False,
    quantiles="linear",
    middle="mean of two",
    prints="scientific",
    digits=4,
    mixed=False,
    maximise=False,
)
Texts = Mapping[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """What a table prints of some runs, the number of runs that it tells, and another spread."""

    texts: Texts
    n: int
    other: str

    def number(self, name: str) -> float:
        """Return what a statistic says."""
        return float(self.texts[name])

    def new(self, **texts: str) -> "Row":
        """Return the row with other texts."""
        return Row(texts={**self.texts, **texts}, n=self.n, other=self.other)


def _spread_times(factor: float) -> Callable[[Row], Row]:
    return lambda row: row.new(std=f"{row.number('std') * factor:.3e}")


def _other_digit(row: Row) -> Row:
    text = row.texts["mean"]
    lead = text.lstrip("-")[0]
    return row.new(mean=text.replace(lead, str((int(lead) + 4) % 9 + 1), 1))


def _neighbours_exchanged(row: Row) -> Row:
    """Exchange the first two digits that differ."""
    text = row.texts["mean"]
    places = [i for i, mark in enumerate(text.partition("e")[0]) if mark.isdigit()]
    for i, j in pairwise(places):
        if text[i] != text[j]:
            marks = list(text)
            marks[i], marks[j] = marks[j], marks[i]
            return row.new(mean="".join(marks))
    return row


def _exchanged(one: str, other: str) -> Callable[[Row], Row]:
    def change(row: Row) -> Row:
        if not {one, other} <= row.texts.keys():
            return row
        return row.new(**{one: row.texts[other], other: row.texts[one]})

    return change


ERRORS: Mapping[str, Callable[[Row], Row]] = {
    "a digit of the mean": _other_digit,
    "two digits of the mean exchanged": _neighbours_exchanged,
    "mean and worst exchanged": _exchanged("mean", "worst"),
    "mean and std exchanged": _exchanged("mean", "std"),
    "best and median exchanged": _exchanged("best", "median"),
    "std × 10": _spread_times(10),
    "std × 100": _spread_times(100),
    "std / 10": _spread_times(0.1),
    "std / 100": _spread_times(0.01),
    "sign of the mean": lambda row: row.new(mean=f"{-row.number('mean'):.3e}"),
    "exponent of the mean lost": lambda row: row.new(mean=row.texts["mean"].partition("e")[0]),
    "variance for std": lambda row: row.new(std=f"{row.number('std') ** 2:.3e}"),
    "standard error for std": lambda row: row.new(std=f"{row.number('std') / row.n**0.5:.3e}"),
    "a tenth of the runs": lambda row: Row(texts=row.texts, n=row.n // 10, other=row.other),
    "std of another row": lambda row: row.new(std=row.other),
}


def power(kind: str, names: tuple[str, ...], errors: int, seed: str = SEED) -> tuple[float, float]:
    """Return the shares found under no condition, and found at all, of tables with one such error.

    Where the error cannot be made of these statistics, both are nan.
    """
    if not names_fit(kind, names):
        return float("nan"), float("nan")
    proved = found = planted = k = 0
    while planted < errors:
        rng = named_rng(seed, kind, *names, k)
        k += 1
        true = _true_row(rng, names)
        wrong = ERRORS[kind](true)
        if _values(wrong) == _values(true):
            continue  # of this row it changes nothing
        planted += 1
        rows = [row for table in _audited(wrong, names) for row in table.rows]
        proved += any(row.is_proof for row in rows)
        found += any(row.grade is Grade.IMPOSSIBLE for row in rows)
    return proved / errors, found / errors


def names_fit(kind: str, names: tuple[str, ...]) -> bool:
    """Say whether the error can be made of these statistics."""
    if kind == "exponent of the mean lost":
        return names != WHOLE
    needed = {
        "mean and worst exchanged": {"worst"},
        "best and median exchanged": {"best", "median"},
    }
    return needed.get(kind, set()) <= set(names)


def _values(row: Row) -> tuple[float, ...]:
    return (*map(float, row.texts.values()), row.n)


def _true_row(rng: Generator, names: tuple[str, ...]) -> Row:
    if names == WHOLE:
        return _row(rng.poisson(rng.uniform(1, 60), RUNS).astype(float), ("mean", "std"), 2, rng)
    runs = rng.lognormal(rng.uniform(-8, 8), rng.uniform(0.1, 3), RUNS)
    return _row(runs, names, None, rng)


def _row(runs: Vector, names: tuple[str, ...], decimals: int | None, rng: Generator) -> Row:
    values = statistics_of(runs, PLAIN, names)
    texts = {
        name: f"{value:.3e}" if decimals is None else f"{value:.{decimals}f}"
        for name, value in values.items()
    }
    return Row(texts=texts, n=len(runs), other=f"{rng.lognormal(0, 6):.3e}")


def _audited(row: Row, names: tuple[str, ...]) -> list[AuditedTable]:
    lines = [["F", *row.texts], ["F1", *row.texts.values()]]
    options = AuditOptions(runs=row.n, errors=True, maximise=False, integers=names == WHOLE)
    return audit_text("\n".join(",".join(line) for line in lines), options)
