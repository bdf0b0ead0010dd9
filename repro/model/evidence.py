"""What the runs of one paper say, arranged for judging."""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.functions import BenchmarkProblem
from repro.model.experiment import Experiment
from repro.optimisers.search import TellsQuantities

Vector = NDArray[np.float64]
Cell = tuple[str, str, str]
T = TypeVar("T")


@dataclass(frozen=True, slots=True, kw_only=True)
class Runs:
    """Every run of one algorithm on one problem.

    `costs` (repeats, runs), `points` (repeats, runs, n), of the first repeat alone where nothing
    but a cost is known of them, `histories` (repeats, runs, iterations), of the first repeat alone
    where no claim follows the searches themselves; `evaluations` and median `seconds` of one run.
    """

    costs: Vector
    points: Vector
    histories: Vector
    evaluations: int
    seconds: float = 0.0
    known: dict[str, Vector] = field(default_factory=dict, compare=False, repr=False)

    def measured(self, quantity: str, measure: Callable[[Vector], Vector]) -> Vector:
        """Return what `measure` makes of the points, made once for all that ask."""
        if quantity not in self.known:
            self.known[quantity] = measure(self.points)
        return self.known[quantity]


@dataclass(frozen=True, slots=True)
class Evidence:
    """Runs by (experiment, problem, algorithm); a cell that was not run whole is absent.

    `key` is the paper's; of two `experiments` with one name the first counts. What is measured is
    remembered, since many claims share it: with other runs of the cells `own`, all that does not
    rest on them by the evidence beneath, `base`.
    """

    key: str
    experiments: tuple[Experiment, ...]
    runs: Mapping[Cell, Runs]
    remembered: dict[object, Any] = field(default_factory=dict, compare=False, repr=False)
    base: "Evidence | None" = field(default=None, compare=False, repr=False)
    own: frozenset[Cell] = field(default=frozenset(), compare=False, repr=False)

    def experiment(self, name: str) -> Experiment:
        """Return the experiment of that name."""
        return next(e for e in self.experiments if e.name == name)

    def remember(self, what: object, find: Callable[[], T]) -> T:
        """Return what was found before under that name, else find it.

        What rests on no cell whose runs are others is remembered by the evidence beneath, too.
        """
        cells = getattr(what, "cells", None)
        if self.base and cells and self.own.isdisjoint(cells()):
            return self.base.remember(what, find)
        if what not in self.remembered:
            self.remembered[what] = find()
        found: T = self.remembered[what]
        return found

    def under(self, experiments: Iterable[Experiment], runs: Mapping[Cell, Runs]) -> "Evidence":
        """Return the evidence with other experiments and runs in the place of some.

        `runs` are those of every cell whose search, problem or protocol is another one.
        """
        return Evidence(
            self.key,
            (*experiments, *self.experiments),
            {**self.runs, **runs},
            base=self,
            own=frozenset(runs),
        )

    def deeper(self, runs: Mapping[Cell, Runs]) -> "Evidence":
        """Return the evidence with more repeats of cells that nothing remembered rests on."""
        return Evidence(self.key, self.experiments, {**self.runs, **runs}, self.remembered)

    def floor(self, cell: Cell) -> float:
        """Return what no cost of a cell lies below, as far as it is known."""
        of = (e.problems.get(cell[1]) for e in self.experiments if e.name == cell[0])
        problem = next(of, None)
        return problem.minimum if isinstance(problem, BenchmarkProblem) else -math.inf

    def ceiling(self, cell: Cell) -> float:
        """Return what no search of a cell ends above: the worst that one was after an iteration."""
        runs = self.runs[cell]
        if not runs.histories.size:
            return math.inf
        return float(max(runs.histories[..., 0].max(), runs.costs.max()))

    def values(self, cell: Cell, quantity: str = "cost") -> Vector:
        """Return a quantity of every run, shape (repeats, runs).

        It is "cost", "cost after k iterations", "cost after half of the iterations" (rounded down,
        of those that were run), or what the problem itself calls `quantity`.
        """
        runs = self.runs[cell]
        if quantity == "cost":
            return runs.costs
        if match := re.fullmatch(r"cost after (\d+ iterations?|half of the iterations)", quantity):
            last = runs.histories.shape[-1]
            count = match[1].split()[0]
            iteration = last // 2 if count == "half" else int(count)
            if not 1 <= iteration <= last:
                message = f"{'/'.join(cell)}: no {quantity!r}; it has iterations 1 to {last}"
                raise DeclarationError(message)
            return np.asarray(runs.histories[..., iteration - 1])
        problem = self.experiment(cell[0]).problems[cell[1]]
        if not isinstance(problem, TellsQuantities):
            message = f"{'/'.join(cell)}: no quantity {quantity!r}, only the cost"
            raise DeclarationError(message)
        return runs.measured(quantity, partial(problem.quantity, quantity))
