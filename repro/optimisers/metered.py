"""A cost that counts by itself how often it is asked, whatever asks it, and ends at the budget."""

import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from repro.determinism.plain_costs import PlainCost, callable_cost
from repro.errors import InputError
from repro.optimisers.libraries.budget import WORST, BudgetSpent
from repro.optimisers.own_search import checked_point
from repro.optimisers.search import Problem, Result, checked_bounds, noise_of

Vector = NDArray[np.float64]
ELSEWHERE = "it asked for the cost in another process, where it cannot be counted"
BESIDE = 1e-9  # share of the width by which rounding may put a point outside


class Meter:
    """Counts the evaluations of one run under a lock, and keeps its best point and history.

    The budget is `population` times `iterations`; who asks for more gets BudgetSpent. What was
    asked wrongly stands in `faults`, should the search swallow it.
    """

    def __init__(self, problem: Problem, *, population: int, iterations: int) -> None:
        """Count nothing yet; InputError for bad bounds."""
        self.bounds = checked_bounds(problem)
        self.budget = population * iterations
        self.spent = 0
        self.overrun = False
        self.faults: list[Exception] = []
        self._cost = callable_cost(problem.kernel)
        self._data = np.ascontiguousarray(problem.data, dtype=np.float64)
        self._population = population
        self._lock = threading.RLock()
        self._process = os.getpid()
        self._asked: set[int] = set()
        self._best = self.bounds[:, 0]
        self._best_cost = np.inf
        self._history: list[float] = []

    def __reduce__(self) -> NoReturn:
        """Raise InputError: a copy in another process would count by itself."""
        raise InputError(ELSEWHERE)

    def as_function(self) -> Callable[..., float | Vector]:
        """Return the cost as a function of a point (n,), or of a whole population (m, n)."""

        def cost(x: Vector) -> float | Vector:
            try:
                points = np.asarray(x, dtype=np.float64)
                if points.ndim == 2 and points.shape[1] == len(self.bounds):
                    return np.array([_finite(self.ask(self._inside(each))) for each in points])
                return _finite(self.ask(self._inside(x)))
            except Exception as fault:
                self.faults.append(fault)  # told again at the end, should the search swallow it
                raise

        return cost

    def as_kernel(self) -> PlainCost:
        """Return the cost as a kernel of (point, data), which asks with the data of the run."""

        def kernel(x: Vector, data: Vector) -> float:  # noqa: ARG001 (the form of a kernel)
            return self.ask(np.ascontiguousarray(x, dtype=np.float64))

        return PlainCost.of(kernel)

    def ask(self, point: Vector) -> float:
        """Return the cost of a point and count it; BudgetSpent where none is left.

        Raises InputError in another process, whose evaluations could not be counted.
        """
        if os.getpid() != self._process:
            raise InputError(ELSEWHERE)
        with self._lock:
            if self.spent >= self.budget:
                self.overrun = True
                raise BudgetSpent
            self.spent += 1
            value = float(self._cost(point, self._data))
            self._asked.add(hash((point + 0.0).tobytes()))
            if value < self._best_cost:
                self._best, self._best_cost = point.copy(), value
            if self.spent % self._population == 0:
                self._history.append(self._best_cost)
            return value

    def judge(self, x: object) -> None:
        """Count the point that a search returned, unless it was asked for before."""
        point = self._inside(x, "it returned")
        if hash((point + 0.0).tobytes()) not in self._asked and self.spent < self.budget:
            self.ask(point)

    def _inside(self, x: object, what: str = "it asked for the cost of") -> Vector:
        """Return a point, on the edge of the box where rounding alone put it beside."""
        try:
            point = np.array(x, dtype=np.float64)
        except (TypeError, ValueError):
            return checked_point(x, self.bounds, what)
        if point.shape == (len(self.bounds),):
            low, high = self.bounds.T
            held = np.clip(point, low, high)
            if (np.abs(point - held) <= BESIDE * (high - low)).all():
                return held
        return checked_point(x, self.bounds, what)

    def result(self) -> Result:
        """Return what was found."""
        return Result(
            x=self._best.copy(),
            cost=self._best_cost,
            history=np.array(self._history),
            evaluations=self.spent,
        )


class MeteredProblem:
    """A problem as an object with `minimise` sees it: its cost is counted whoever asks for it."""

    def __init__(self, problem: Problem, meter: Meter) -> None:
        """Show no more of the problem than its bounds and what asks the meter."""
        self.bounds = problem.bounds
        self.data = problem.data
        self.identity = problem.identity
        self.noise = noise_of(problem)
        self.kernel = meter.as_kernel()
        self.cost = meter.as_function()


def _finite(value: float) -> float:
    """Return a cost as libraries bear it."""
    if -WORST < value < WORST:
        return value
    return -WORST if value < 0.0 else WORST


@contextmanager
def stopping_threads() -> Iterator[None]:
    """Let threads that ask for more than the budget end without a word, within the block."""
    before = threading.excepthook

    def hook(raised: threading.ExceptHookArgs) -> None:
        if not issubclass(raised.exc_type, BudgetSpent):
            before(raised)

    threading.excepthook = hook
    try:
        yield
    finally:
        threading.excepthook = before
