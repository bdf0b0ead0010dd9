"""A search of one's own that is a function, and what becomes of it in a paper."""

import inspect
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.plain_costs import called
from repro.errors import DeclarationError, InputError
from repro.optimisers.libraries.budget import BudgetSpent, CountedCost, iterations_of
from repro.optimisers.search import Budget, Optimiser, Problem, Result, checked_bounds

Vector = NDArray[np.float64]
Search = Callable[[Callable[[Vector], float], Vector, int, np.random.Generator], Vector]
CALL = "f(cost, bounds, budget, rng) -> x"


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnSearch:
    """A callable f(cost, bounds, budget, rng) -> x as an optimiser.

    It may ask for the cost of `budget` points of shape (n,) inside `bounds`, shape (n, 2), and
    draws from `rng` alone. Where its source lets points leave the box, `leaves_box` says so, and
    such points are asked for as they are.
    """

    holds_interpreter: ClassVar[bool] = True
    search: Search
    leaves_box: bool = False

    def __post_init__(self) -> None:
        """Raise InputError for what cannot be called so."""
        refuse_what_is_no_search(self.search, called(self.search))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by at most N·T evaluations; see `Optimiser`.

        Raises InputError for a search that leaves the box undeclared, or returns no point.
        """
        steps = iterations_of(budget)
        bounds = checked_bounds(problem)
        counted = CountedCost(
            problem,
            population=budget["population"],
            iterations=steps,
            held=not self.leaves_box,
        )
        allowed = np.full_like(bounds, (-np.inf, np.inf)) if self.leaves_box else bounds
        _by_call(self.search, counted, bounds, allowed, budget["rng"])
        return filled(counted.result(), steps)


def as_optimiser(given: Any, place: str) -> Optimiser:  # noqa: ANN401 (whatever the user wrote)
    """Return an optimiser as it is, and a callable f(cost, bounds, budget, rng) as one.

    Raises DeclarationError, which begins with the place, for what is neither.
    """
    try:
        refuse_what_is_no_search(given, called(given))
    except InputError as fault:
        message = f"{place}: {fault}"
        raise DeclarationError(message) from None
    optimiser: Optimiser = given if has_protocol(given) else OwnSearch(search=given)
    return optimiser


def has_protocol(found: object) -> bool:
    """Return whether something is an object with `minimise`."""
    return not isinstance(found, type) and callable(getattr(found, "minimise", None))


def refuse_what_is_no_search(found: object, place: str) -> None:
    """Raise InputError, which names the place, for what is neither form of a search."""
    if isinstance(found, type):
        message = f"{place} is a class: name an object of it"
        raise InputError(message)
    if has_protocol(found):
        return
    if not callable(found):
        message = f"{place} is neither an object with minimise(problem, …) nor a callable {CALL}"
        raise InputError(message)
    try:
        inspect.signature(found).bind(*range(4))
    except TypeError:
        message = f"{place} cannot be called as {CALL}"
        raise InputError(message) from None
    except ValueError:  # a compiled callable that does not say how it is called
        return


def _by_call(
    search: Search,
    counted: CountedCost,
    bounds: Vector,
    allowed: Vector,
    rng: np.random.Generator,
) -> None:
    """Run a search until it ends or its budget does; what it asked for is in `counted`."""
    faults: list[Exception] = []

    def cost(x: Vector) -> float:
        try:
            point = checked_point(x, allowed, "it asked for the cost of")
            return counted(point[counted.free])
        except Exception as fault:
            faults.append(fault)  # told again at the end, should the search swallow it
            raise

    try:
        x = search(cost, bounds.copy(), counted.left, rng)
        counted(checked_point(x, allowed, "it returned")[counted.free])
    except BudgetSpent:
        pass
    if faults:
        raise faults[0]


def filled(result: Result, iterations: int) -> Result:
    """Return the result of a search that may have ended early, its history filled to the end."""
    rest = np.full(iterations - len(result.history), result.cost)
    return replace(result, history=np.concatenate([result.history, rest]))


def checked_point(x: object, bounds: Vector, what: str) -> Vector:
    """Return a point inside the bounds; InputError, which says `what` was done, for any other."""
    try:
        point = np.ascontiguousarray(x, dtype=np.float64)
    except (TypeError, ValueError):
        message = f"{what} {x!r:.60}, which is no point of shape ({len(bounds)},)"
        raise InputError(message) from None
    if x is None or point.shape != (len(bounds),):
        message = f"{what} {x!r:.60}, which is no point of shape ({len(bounds)},)"
        raise InputError(message)
    outside = np.flatnonzero(~((bounds[:, 0] <= point) & (point <= bounds[:, 1])))
    if len(outside):
        j = int(outside[0])
        message = f"{what} a point outside the box: x[{j}] is {point[j]}, not in {bounds[j]}"
        raise InputError(message)
    return point
