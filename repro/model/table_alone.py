"""A printed table that no run stands behind: what a paper tells of it, for the audit alone."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from fractions import Fraction
from typing import Any, Literal

from repro.functions import BenchmarkProblem
from repro.model.known_words import known_words, shown_value
from repro.tables.audit_options import option_faults
from repro.tables.published import PublishedTable
from repro.tables.read_blocks import names_of
from repro.tables.read_published import read_published

Numbers = float | int | str | Fraction


@dataclass(frozen=True, slots=True, kw_only=True)
class TableAlone:
    """A table that is audited by what it prints and by what is told here, and never re-run.

    What is told goes by the names of the options of `repro audit FILE`, and what is left out is
    guessed as there: `runs` behind each statistic, `maximise`, the `minimum` of every value or by
    problem, in the printed unit, the `function` of each problem, whether values are `errors` (none
    below 0) or `integers`, the `precision` of the runs, the digits that are `significant`, what a
    `spread` is, which `test` made p-values, how `sided` and at which `alpha`, and how ranks share
    `ties`.
    """

    table: PublishedTable
    runs: int | None = None
    maximise: bool | None = None
    minimum: Numbers | Mapping[str, Numbers] | None = None
    function: Mapping[str, BenchmarkProblem] = field(default_factory=dict)
    errors: bool = False
    integers: bool = False
    precision: Literal["single", "double"] | None = None
    significant: int | None = None
    spread: Literal["std", "variance", "sem"] | None = None
    test: Literal["ranksum", "signedrank"] | None = None
    sided: Literal[1, 2] | None = None
    alpha: float | None = None
    ties: Literal["average", "min", "max", "dense", "ordinal"] | None = None

    @property
    def told(self) -> dict[str, Any]:
        """What is told by name, but for least values and functions."""
        named = ("table", "minimum", "function")
        names = [each.name for each in fields(self) if each.name not in named]
        return {name: getattr(self, name) for name in names}

    @property
    def minima(self) -> Mapping[str, Numbers]:
        """The least values by problem; one for all of them by the name ""."""
        if isinstance(self.minimum, Mapping):
            return self.minimum
        return {} if self.minimum is None else {"": self.minimum}


def least_value(told: Numbers) -> Fraction:
    """Return the number that was written; a float is the decimal that Python shows of it."""
    return Fraction(str(told))


def alone_faults(alone: TableAlone) -> Iterator[str]:
    """Yield what cannot be told of a table, a line each, with what can."""
    if not isinstance(alone.table, PublishedTable):
        yield f"audited: {shown_value(alone.table)} is no PublishedTable"
        return
    label = alone.table.label
    yield from (f"{label}, {fault}" for fault in option_faults(alone.told))
    entries = read_published(alone.table).entries
    if not entries:
        yield f"{label}: it has no numbers to audit"
        return
    problems = dict.fromkeys(entry.problem or entry.algorithm for entry in entries)
    known = {name for problem in problems for name in names_of(problem)}
    if not isinstance(alone.function, Mapping):
        yield f"{label}, function is {shown_value(alone.function)}; give one by problem"
        return
    for kind, by_problem in (("minimum", alone.minima), ("function", alone.function)):
        for name, value in by_problem.items():
            place = f"{label}, {kind} of {name!r}"
            if name not in known:
                yield f"{place}: the table has no such problem; {known_words(name, problems)}"
            yield from _value_faults(place, kind, value)


def _value_faults(place: str, kind: str, value: object) -> Iterator[str]:
    if kind == "minimum" and not _is_number(value):
        yield f"{place} is {shown_value(value)}, not a number"
    if kind == "function" and not isinstance(value, BenchmarkProblem):
        given = shown_value(value)
        yield f"{place} is {given}; give a problem such as FUNCTIONS['sphere'].problem(30)"


def _is_number(value: object) -> bool:
    if isinstance(value, bool) or not isinstance(value, (float, int, str, Fraction)):
        return False
    try:
        least_value(value)
    except (ValueError, ZeroDivisionError):
        return False
    return True
