"""A library's search under our protocol: evaluations counted, stopped where the budget ends."""

import warnings
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, version
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.plain_costs import callable_cost
from repro.optimisers.search import (
    Budget,
    Problem,
    Result,
    _iterations,
    checked_bounds,
    every_agent_once,
)

Vector = NDArray[np.float64]
WORST = 1e150  # told for a cost that is not finite: worse than all others, and its square is finite


class BudgetSpent(BaseException):
    """The budget ends here; no `except Exception` of a library swallows it."""


class CountedCost:
    """The cost of a problem as a library calls it, with the best so far and its history.

    A coordinate whose bounds are equal is not searched: `bounds`, shape (free, 2), and the points
    that are asked for, shape (free,), leave it out. A point outside its bounds counts as the
    nearest one inside, unless the search is not `held`.
    """

    def __init__(
        self, problem: Problem, *, population: int, iterations: int, held: bool = True
    ) -> None:
        """Prepare for `population` times `iterations` evaluations; InputError for bad bounds."""
        box = checked_bounds(problem)
        self.free = box[:, 0] < box[:, 1]
        self._held = None if self.free.all() else box[:, 0]
        self.bounds = box[self.free]
        self._lower, self._upper = np.ascontiguousarray(self.bounds.T)
        if not held:
            self._lower, self._upper = np.full_like(self.bounds.T, [[-np.inf], [np.inf]])
        self._cost = callable_cost(problem.kernel)
        self._data = np.ascontiguousarray(problem.data, dtype=np.float64)
        self._population = population
        self._budget = population * iterations
        self._spent = 0
        self._best = box[:, 0]
        self._best_cost = np.inf
        self._history: list[float] = []

    @property
    def left(self) -> int:
        """How many more points may be asked for."""
        return self._budget - self._spent

    def __call__(self, x: Vector) -> float:
        """Return the cost of a point, `WORST` for one that is not finite; BudgetSpent at the end.

        What is left of the budget is counted before the cost is asked for.
        """
        return self._asked(np.minimum(np.maximum(x, self._lower), self._upper))

    def of_each(self, points: Vector) -> Vector:
        """Return the costs of points, shape (free, n) to (n,), asked for one after the other."""
        inside = np.ascontiguousarray(np.clip(points.T, self._lower, self._upper))
        return np.array([self._asked(point) for point in inside])

    def _asked(self, point: Vector) -> float:
        if self._spent == self._budget:
            raise BudgetSpent
        if self._held is not None:
            whole = self._held.copy()
            whole[self.free] = point
            point = whole
        value = float(self._cost(point, self._data))
        self._spent += 1
        if value < self._best_cost:
            self._best, self._best_cost = point.copy(), value
        if self._spent % self._population == 0:
            self._history.append(self._best_cost)
        if -WORST < value < WORST:
            return value
        return -WORST if value < 0.0 else WORST

    def result(self) -> Result:
        """Return what was found."""
        return Result(
            x=self._best.copy(),
            cost=self._best_cost,
            history=np.array(self._history),
            evaluations=self._spent,
        )


Strategy = Callable[[CountedCost, np.random.Generator], object]


def until_spent(strategy: Strategy, problem: Problem, **budget: Unpack[Budget]) -> Result:
    """Run a strategy, and anew whenever it ends, until the budget is spent; see `Optimiser`.

    The strategy is silenced: what a library warns of is how it meets a hostile cost. Linear algebra
    keeps to one thread, because another number of threads gives other bits; a strategy must have
    imported its library before.
    """
    from threadpoolctl import threadpool_limits  # noqa: PLC0415 (only these searches need it)

    cost = CountedCost(problem, population=budget["population"], iterations=iterations_of(budget))
    with threadpool_limits(1), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            while True:
                if len(cost.bounds):
                    strategy(cost, budget["rng"])
                else:
                    cost(np.empty(0))
        except BudgetSpent:
            return cost.result()


def iterations_of(budget: Budget) -> int:
    """Return the whole iterations that a budget pays for, where each agent is evaluated once."""
    return _iterations(
        every_agent_once(budget["population"]),
        iterations=budget.get("iterations"),
        evaluations=budget.get("evaluations"),
    )


def release(package: str) -> str:
    """Return the version of an installed package, "none" where it is missing."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "none"
