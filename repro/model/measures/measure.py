"""What can be measured for a claim: statistics of runs, ranks, reductions, computed values."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.evidence import Cell, Evidence
from repro.model.experiment import Experiment
from repro.model.measures.to_come import tables_to_come
from repro.statistics.named import is_count, is_of_extremes, statistic_named
from repro.statistics.places import Ties, place
from repro.statistics.summary import STATISTICS
from repro.statistics.tables import ANYWHERE, half_equal

Vector = NDArray[np.float64]
TABLES = 2000  # tables per statistic: its 2.5 % tail then holds 50 of them
ALL = "all statistics"


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """The value of the first repeat, the values of many tables that may come next, repeats used.

    Where several cells are used, the repeats are the fewest of any, and 0 where none is run.
    `thin` says that one repeat is too little to contradict anything: the value hangs on the best or
    the worst run, or on runs half of which are equal, so that others may be anywhere.
    """

    value: float
    draws: Vector
    repeats: int
    thin: bool = False


def fewest_repeats(*parts: Measured) -> int:
    """Return the fewest repeats that any part rests on; a part without runs has none to count."""
    return min((part.repeats for part in parts if part.repeats), default=0)


def place_among(all_of_them: Sequence[Measured], own: int, ties: Ties = "min") -> Measured:
    """Return the place of the one at position `own` among all, 1 for the lowest."""
    return Measured(
        value=float(place([np.asarray(part.value) for part in all_of_them], own, ties)),
        draws=place([part.draws for part in all_of_them], own, ties),
        repeats=fewest_repeats(*all_of_them),
        thin=any(part.thin for part in all_of_them),
    )


class Measure(Protocol):
    """Something that evidence gives a value to, in SI units."""

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of runs that are needed: (experiment, problem, algorithm)."""

    def measure(self, evidence: Evidence) -> Measured:
        """Return what the runs give."""

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""

    @property
    def follows(self) -> bool:
        """Whether it looks at the course of the searches and not only at their ends."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Statistic:
    """A statistic, over the runs of one table, of the cost or another quantity.

    `statistic` is a word of `repro.statistics.named`: "best", "mean", "median", "q1", and so on.
    """

    experiment: str
    problem: str
    algorithm: str
    statistic: str
    quantity: str = "cost"

    @property
    def cell(self) -> Cell:
        """Where the runs are."""
        return self.experiment, self.problem, self.algorithm

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        of = f"{self.quantity} of {self.algorithm} on {self.problem}"
        return f"{self.statistic}, {of}" if is_count(self.statistic) else f"{self.statistic} {of}"

    def cells(self) -> tuple[Cell, ...]:
        """Return the one cell that is needed."""
        return (self.cell,)

    @property
    def follows(self) -> bool:
        """Whether it is about the cost on the way."""
        return self.quantity.startswith("cost after")

    def measure(self, evidence: Evidence) -> Measured:
        """Return the statistic of the first repeat and of tables that may come next."""
        if self.statistic not in STATISTICS:
            return evidence.remember(self, partial(_statistic, evidence, self))
        of_all = evidence.remember(
            replace(self, statistic=ALL), partial(_statistics, evidence, self.cell, self.quantity)
        )
        return of_all.get(self.statistic) or _statistic(evidence, self)


def _statistics(evidence: Evidence, cell: Cell, quantity: str) -> Mapping[str, Measured]:
    """Return every usual statistic of the same tables, which are made once for all of them."""
    values, tables = _tables(evidence, cell, quantity)
    return {
        name: _measured(name, statistic, values, tables)
        for name, statistic in STATISTICS.items()
        if name != "std" or values.shape[-1] > 1
    }


def _statistic(evidence: Evidence, of: Statistic) -> Measured:
    """Return a statistic that few tables print; InputError where one run has none."""
    function = statistic_named(of.statistic)
    return _measured(of.statistic, function, *_tables(evidence, of.cell, of.quantity))


def _tables(evidence: Evidence, cell: Cell, quantity: str) -> tuple[Vector, Vector]:
    """Return what was found, and the same tables that may come next whenever they are asked for."""
    values = evidence.values(cell, quantity)
    # named without the quantity: the same tables for all of a cell's numbers
    ends = (evidence.floor(cell), evidence.ceiling(cell)) if quantity == "cost" else ANYWHERE
    return values, tables_to_come(values, evidence.key, *cell, tables=TABLES, ends=ends)


def _measured(
    name: str, statistic: Callable[[Vector], Vector], values: Vector, tables: Vector
) -> Measured:
    return Measured(
        value=float(statistic(values[0])),
        draws=statistic(tables),
        repeats=len(values),
        thin=is_of_extremes(name, values.shape[-1]) or half_equal(values),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Rank:
    """Place of one algorithm's statistic among others, 1 for the lowest.

    `ties` says how equal ones share their places: by default the lower one is for all.
    """

    of: Statistic
    among: tuple[str, ...]
    ties: Ties = "min"

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        shared = "" if self.ties == "min" else f", ties {self.ties}"
        return f"rank of {self.of.words} among {', '.join(self.among)}{shared}"

    @property
    def follows(self) -> bool:
        """Whether the statistic does."""
        return self.of.follows

    def cells(self) -> tuple[Cell, ...]:
        """Return one cell per algorithm."""
        return tuple((*self.of.cell[:2], name) for name in self.among)

    def measure(self, evidence: Evidence) -> Measured:
        """Return the rank in the first repeat and in tables that may come next."""
        names = tuple(dict.fromkeys((*self.among, self.of.algorithm)))
        found = [replace(self.of, algorithm=name).measure(evidence) for name in names]
        return place_among(found, names.index(self.of.algorithm), self.ties)


@dataclass(frozen=True, slots=True, kw_only=True)
class Computed:
    """A value that follows from printed inputs without a run."""

    follows: ClassVar[bool] = False
    how: str
    value: Callable[[], float]

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return self.how

    def cells(self) -> tuple[Cell, ...]:
        """Return nothing: no run is needed."""
        return ()

    def measure(self, evidence: Evidence) -> Measured:  # noqa: ARG002 (the protocol's argument)
        """Return the value, which does not vary."""
        value = self.value()
        return Measured(value=value, draws=np.array([value]), repeats=0)


def computed(how: str, value: Callable[..., float], *arguments: object) -> Computed:
    """Return the value of a function, told by `how` it is found, that needs no run."""
    return Computed(how=how, value=partial(value, *arguments))


def runs_of(
    experiment: Experiment, algorithm: str, statistic: str = "mean", *, problem: str = ""
) -> Callable[[str], Statistic]:
    """Return what gives a statistic of a quantity; `problem` may be left out where there is one."""
    if not problem:
        (problem,) = experiment.problems

    def of(quantity: str) -> Statistic:
        return Statistic(
            experiment=experiment.name,
            problem=problem,
            algorithm=algorithm,
            statistic=statistic,
            quantity=quantity,
        )

    return of


@dataclass(frozen=True, slots=True, kw_only=True)
class Difference:
    """By how much `after` is lower than `before`, in their unit."""

    before: Measure
    after: Measure

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"difference from {self.before.words} to {self.after.words}"

    @property
    def follows(self) -> bool:
        """Whether either side does."""
        return self.before.follows or self.after.follows

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of both sides."""
        return self.before.cells() + self.after.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the difference in the first repeat and in tables that may come next."""
        before, after = self.before.measure(evidence), self.after.measure(evidence)
        return Measured(
            value=before.value - after.value,
            draws=before.draws - after.draws,
            repeats=fewest_repeats(before, after),
            thin=before.thin or after.thin,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Reduction:
    """By how many percent `after` is lower than `before`."""

    before: Measure
    after: Measure

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"reduction in percent from {self.before.words} to {self.after.words}"

    @property
    def follows(self) -> bool:
        """Whether either side does."""
        return self.before.follows or self.after.follows

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of both sides."""
        return self.before.cells() + self.after.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the reduction in the first repeat and in tables that may come next."""
        before, after = self.before.measure(evidence), self.after.measure(evidence)
        if before.value == 0.0:
            message = f"{self.words}: nothing is lower than 0 by a percentage"
            raise DeclarationError(message)
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = after.draws / before.draws
        return Measured(
            value=100.0 * (1.0 - after.value / before.value),
            draws=100.0 * (1.0 - np.where(np.isnan(shares), 1.0, shares)),
            repeats=fewest_repeats(before, after),
            thin=before.thin or after.thin,
        )
