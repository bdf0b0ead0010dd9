"""What the runs of one paper say, arranged for judging."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model import Experiment, Paper

Vector = NDArray[np.float64]
Cell = tuple[str, str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Runs:
    """Every run of one algorithm on one problem.

    `costs` (repeats, runs), `points` (repeats, runs, n), `histories` (repeats, runs, iterations),
    `evaluations` of one run.
    """

    costs: Vector
    points: Vector
    histories: Vector
    evaluations: int

    def repeats(self, which: slice) -> "Runs":
        """Return some of the repeats."""
        return Runs(
            costs=self.costs[which],
            points=self.points[which],
            histories=self.histories[which],
            evaluations=self.evaluations,
        )


@dataclass(frozen=True, slots=True)
class Evidence:
    """Runs by (experiment, problem, algorithm); a cell that was not run whole is absent."""

    paper: Paper
    runs: Mapping[Cell, Runs]

    def experiment(self, name: str) -> Experiment:
        """Return the experiment of that name."""
        return next(e for e in self.paper.experiments if e.name == name)

    def halves(self, cells: tuple[Cell, ...]) -> tuple["Evidence", "Evidence"]:
        """Return the odd and the even repeats of some cells; each needs two repeats or more."""
        odd, even = (
            Evidence(self.paper, {cell: self.runs[cell].repeats(which) for cell in cells})
            for which in (slice(0, None, 2), slice(1, None, 2))
        )
        return odd, even

    def values(self, cell: Cell, quantity: str = "cost") -> Vector:
        """Return a quantity of every run, shape (repeats, runs).

        It is "cost", "cost after k iterations", or what the problem itself calls `quantity`.
        """
        runs = self.runs[cell]
        if quantity == "cost":
            return runs.costs
        if match := re.fullmatch(r"cost after (\d+) iterations", quantity):
            iteration, last = int(match[1]), runs.histories.shape[-1]
            if not 1 <= iteration <= last:
                message = f"{'/'.join(cell)}: no {quantity!r}; it has iterations 1 to {last}"
                raise DeclarationError(message)
            return np.asarray(runs.histories[..., iteration - 1])
        problem = self.experiment(cell[0]).problems[cell[1]]
        if not hasattr(problem, "quantity"):
            message = f"{'/'.join(cell)}: no quantity {quantity!r}, only the cost"
            raise DeclarationError(message)
        measured: Vector = problem.quantity(quantity, runs.points)
        return measured
