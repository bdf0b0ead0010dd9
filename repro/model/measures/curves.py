"""Measures of fitted curves: several problems taken together, places, effort, sensitivity.

One joint is one problem; an arm is several of them. What is said of an arm is measured run by
run: the first run of every joint makes the arm's first run, and so on, over the repeats that all
of its joints have.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from types import MappingProxyType
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import TABLES, Measure, Measured, place_among
from repro.model.measures.to_come import tables_to_come
from repro.robotics.path_fitting import PathFitting
from repro.robotics.polynomial_curves import values
from repro.statistics.named import is_of_extremes, statistic_named
from repro.statistics.tables import half_equal

Vector = NDArray[np.float64]
Combination = Literal["norm", "sum", "largest"]

_COMBINED: Mapping[Combination, Callable[[Vector], Vector]] = MappingProxyType(
    {
        "norm": lambda parts: np.asarray(np.linalg.norm(parts, axis=0)),
        "sum": lambda parts: np.asarray(parts.sum(axis=0)),
        "largest": lambda parts: np.asarray(parts.max(axis=0)),
    }
)


def lower_median(costs: Vector) -> Vector:
    """Return the least value that half of them do not exceed, which is one of them."""
    return np.asarray(np.quantile(costs, 0.5, axis=-1, method="lower"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Together:
    """A statistic, over the runs, of a quantity of several problems combined run by run."""

    experiment: str
    problems: tuple[str, ...]
    algorithm: str
    quantity: str
    combination: Combination
    statistic: str = "median"

    @property
    def follows(self) -> bool:
        """Whether it is about the cost on the way."""
        return self.quantity.startswith("cost after")

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return (
            f"{self.statistic} {self.combination} of {self.quantity} over {len(self.problems)} "
            f"problems of {self.experiment}, {self.algorithm}"
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return one cell per problem."""
        return tuple((self.experiment, problem, self.algorithm) for problem in self.problems)

    def measure(self, evidence: Evidence) -> Measured:
        """Return the statistic of the first repeat and of tables that may come next."""
        return evidence.remember(self, partial(self._measure, evidence))

    def _measure(self, evidence: Evidence) -> Measured:
        parts = [evidence.values(cell, self.quantity) for cell in self.cells()]
        combined = _COMBINED[self.combination](_of_common_repeats(parts))
        return _summarised(combined, self.statistic, evidence, self.experiment, self.algorithm)


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaceAmong:
    """Place of one measure among others, 1 for the lowest; ties share the lower place."""

    of: Measure
    others: tuple[Measure, ...]

    @property
    def follows(self) -> bool:
        """Whether any of them does."""
        return any(measure.follows for measure in (self.of, *self.others))

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"place of {self.of.words} among {'; '.join(m.words for m in self.others)}"

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of all of them."""
        return tuple(cell for measure in (self.of, *self.others) for cell in measure.cells())

    def measure(self, evidence: Evidence) -> Measured:
        """Return the place in the first repeat and in tables that may come next."""
        return place_among([part.measure(evidence) for part in (self.of, *self.others)], 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Effort:
    """Median evaluations until the norm of the costs of several problems falls to a target.

    The target is one that every algorithm of `among` reaches in half of its runs: the highest of
    their median final norms, over the first repeat for its value and over all repeats for how much
    it varies. A run that never reaches it counts as infinite; the median is the lower one, since
    of an even number of runs just half may reach it. The evaluations of a run are shared out
    equally among its iterations.
    """

    follows: ClassVar[bool] = True
    experiment: str
    problems: tuple[str, ...]
    algorithm: str
    among: tuple[str, ...]

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return (
            f"median evaluations of {self.algorithm} in {self.experiment} until the highest of the "
            f"median final norms of {', '.join(self.among)}"
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return one cell per algorithm and problem."""
        return tuple(cell for name in self.among for cell in self._of(name))

    def measure(self, evidence: Evidence) -> Measured:
        """Return the effort in the first repeat and in tables that may come next."""
        histories = {name: self._history(evidence, name) for name in self.among}
        first = {name: history[:1] for name, history in histories.items()}
        own, name = self.algorithm, self.experiment
        effort = self._effort(evidence, histories)
        measured = _summarised(effort, "lower median", evidence, name, own)
        return replace(
            measured,
            value=float(lower_median(self._effort(evidence, first).ravel())),
            repeats=min(map(len, histories.values())),
        )

    def _effort(self, evidence: Evidence, histories: Mapping[str, Vector]) -> Vector:
        """Return the evaluations of each run until the target of these repeats."""
        target = max(float(np.median(history[..., -1])) for history in histories.values())
        history = histories[self.algorithm]
        reached = history <= target
        iterations = np.where(reached.any(axis=-1), reached.argmax(axis=-1) + 1.0, np.inf)
        each = evidence.runs[self._of(self.algorithm)[0]].evaluations / history.shape[-1]
        return np.asarray(each * iterations)

    def _of(self, algorithm: str) -> tuple[Cell, ...]:
        return tuple((self.experiment, problem, algorithm) for problem in self.problems)

    def _history(self, evidence: Evidence, algorithm: str) -> Vector:
        """Return the norm after each iteration, shape (repeats, runs, iterations)."""
        parts = [evidence.runs[cell].histories for cell in self._of(algorithm)]
        return _COMBINED["norm"](_of_common_repeats(parts))


@dataclass(frozen=True, slots=True, kw_only=True)
class Sensitivity:
    """By how much the curves of two experiments differ, over how much their problems differ.

    The second experiment has the same problems but for a shift of `shift` rad in the start. For
    each run it is the greatest difference between the curves that the run finds, over all
    problems and instants, divided by the shift; 1 means that a change is passed on as it is.
    """

    follows: ClassVar[bool] = False
    experiment: str
    shifted: str
    problems: tuple[str, ...]
    algorithm: str
    shift: float

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return (
            f"median over the runs of {self.algorithm} of the greatest difference between the "
            f"curves of {self.experiment} and {self.shifted}, over the shift of {self.shift:g} rad"
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return one cell per experiment and problem."""
        return tuple(product((self.experiment, self.shifted), self.problems, (self.algorithm,)))

    def measure(self, evidence: Evidence) -> Measured:
        """Return the sensitivity in the first repeat and in tables that may come next."""
        problems = evidence.experiment(self.experiment).problems
        changes = []
        for name in self.problems:
            pair = [
                evidence.runs[experiment, name, self.algorithm].points
                for experiment in (self.experiment, self.shifted)
            ]
            both = min(map(len, pair))  # under another reading one of them has fewer repeats
            before, after = (points[:both] for points in pair)
            apart = np.abs(values(after - before, problems[name].times))
            changes.append(apart.max(axis=-1) / self.shift)
        combined = _COMBINED["largest"](_of_common_repeats(changes))
        return _summarised(combined, "median", evidence, self.experiment, self.algorithm)


def planned(
    problems: tuple[PathFitting, ...], quantity: str, combination: Combination
) -> Callable[[], float]:
    """Return what gives a quantity of the desired paths themselves, combined over the problems."""

    def value() -> float:
        parts = [problem.quantity(quantity, problem.coefficients) for problem in problems]
        return float(_COMBINED[combination](np.array(parts)))

    return value


def _of_common_repeats(parts: Sequence[Vector]) -> Vector:
    """Return as one array what parts of shape (repeats, ...) have of the repeats common to all."""
    repeats = min(map(len, parts))  # a failed or missing run takes its repeat from one part alone
    return np.array([part[:repeats] for part in parts])


def _summarised(
    table: Vector, statistic: str, evidence: Evidence, experiment: str, algorithm: str
) -> Measured:
    """Return the statistic of a table (repeats, runs) and of tables that may come next."""
    to_come = tables_to_come(table, evidence.key, experiment, algorithm, tables=TABLES)
    summary = lower_median if statistic == "lower median" else statistic_named(statistic)
    return Measured(
        value=float(summary(table[0])),
        draws=summary(to_come),
        repeats=len(table),
        thin=is_of_extremes(statistic, table.shape[-1]) or half_equal(table),
    )
