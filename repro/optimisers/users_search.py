"""A user's own search, found by name and held to the rules of the others."""

import importlib
import inspect
import math
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.source_digests import source_digest
from repro.errors import InputError
from repro.optimisers.libraries.budget import BudgetSpent, CountedCost
from repro.optimisers.search import Budget, Problem, Result, noise_of, value, without_noise

Vector = NDArray[np.float64]
Search = Callable[[Callable[[Vector], float], Vector, int, np.random.Generator], Vector]
ROUNDING = 1e-9  # share by which a cost may differ that was summed in another order
CALL = "f(cost, bounds, budget, rng) -> x"


@dataclass(frozen=True, slots=True, kw_only=True)
class Entrant:
    """A search named by its place, "module:object"; `source` is the digest of its source code.

    It is an object with our protocol, or a callable f(cost, bounds, budget, rng) -> x, which may
    ask for the cost of `budget` points of shape (n,) inside `bounds`, shape (n, 2).
    """

    holds_interpreter: ClassVar[bool] = True
    place: str
    source: str

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by at most N·T evaluations.

        Raises InputError for a search that leaves the box, overspends or returns no point.
        """
        found = load(self.place)
        try:
            if callable(getattr(found, "minimise", None)):
                return _by_protocol(found, problem, budget)
            return _by_call(found, problem, budget)
        except SystemExit:
            message = "it tried to end the program"
            raise InputError(message) from None


def entrant(place: str) -> Entrant:
    """Return the search at a place; InputError where there is none."""
    found = load(place)
    modules = {place.partition(":")[0], getattr(type(found), "__module__", "builtins")}
    return Entrant(place=place, source=source_digest(*sorted(modules - {"builtins"})))


def load(place: str) -> Any:  # noqa: ANN401 (whatever the user wrote)
    """Return the object at "module:object", the current folder first among the places.

    Raises InputError for what cannot be imported or is no search.
    """
    module, colon, name = place.partition(":")
    if not (module and colon and name):
        message = f"{place!r} is not MODULE:OBJECT, as in searches:anneal"
        raise InputError(message)
    found = _imported(module)
    for part in name.split("."):
        if not hasattr(found, part):
            known = ", ".join(word for word in dir(found) if not word.startswith("_"))
            message = f"{module!r} has no {name!r}; it has: {known or 'nothing'}"
            raise InputError(message)
        found = getattr(found, part)
    _refuse_what_is_no_search(found, place)
    return found


def _imported(module: str) -> Any:  # noqa: ANN401
    here = os.getcwd()  # noqa: PTH109 (sys.path holds texts)
    if here not in sys.path:
        sys.path.insert(0, here)
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        missing = f"no module {error.name!r} in this folder or among the installed ones"
        message = missing if error.name == module else f"{module!r} cannot be imported: {missing}"
        raise InputError(message) from None
    except (Exception, SystemExit) as error:  # noqa: BLE001 (the user's module may do anything)
        message = f"{module!r} cannot be imported: {type(error).__name__}: {error}"
        raise InputError(message) from None


def _refuse_what_is_no_search(found: object, place: str) -> None:
    if isinstance(found, type):
        message = f"{place} is a class: name an object of it"
        raise InputError(message)
    if callable(getattr(found, "minimise", None)):
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


def _by_call(search: Search, problem: Problem, budget: Budget) -> Result:
    population, iterations = budget["population"], budget["iterations"]
    bounds = np.array(problem.bounds, dtype=np.float64)
    counted = CountedCost(problem, population=population, iterations=iterations)
    faults: list[InputError] = []

    def cost(x: Vector) -> float:
        try:
            point = _checked_point(x, bounds, "it asked for the cost of")
        except InputError as fault:
            faults.append(fault)  # told again at the end, should the search swallow it
            raise
        return counted(point[counted.free])

    try:
        x = search(cost, bounds.copy(), population * iterations, budget["rng"])
        counted(_checked_point(x, bounds, "it returned")[counted.free])
    except BudgetSpent:
        pass
    if faults:
        raise faults[0]
    return _whole(counted.result(), iterations)


def _whole(result: Result, iterations: int) -> Result:
    """Return the result of a search that may have ended early, its history filled to the end."""
    rest = np.full(iterations - len(result.history), result.cost)
    return replace(result, history=np.concatenate([result.history, rest]))


def _checked_point(x: object, bounds: Vector, what: str) -> Vector:
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


def _by_protocol(search: Any, problem: Problem, budget: Budget) -> Result:  # noqa: ANN401
    population, iterations = budget["population"], budget["iterations"]
    allowed = population * iterations
    result = search.minimise(problem, population=population, evaluations=allowed, rng=budget["rng"])
    try:
        cost, evaluations = float(result.cost), int(result.evaluations)
        history = np.array(result.history, dtype=np.float64)
        x = result.x
    except (AttributeError, TypeError, ValueError):
        message = f"it returned {result!r:.60}, which has no x, cost, history and evaluations"
        raise InputError(message) from None
    point = _checked_point(x, np.array(problem.bounds), "it returned")
    if not 0 < evaluations <= allowed:
        message = f"it spent {evaluations} evaluations, and {allowed} were allowed"
        raise InputError(message)
    true = _nearest_cost(problem, point, cost)
    if not math.isclose(cost, true, rel_tol=ROUNDING, abs_tol=ROUNDING):
        message = f"it says that its best point costs {cost}; it costs {true}"
        raise InputError(message)
    if history.ndim != 1 or not 0 < len(history) <= iterations or np.any(np.diff(history) > 0.0):
        message = f"its history is not the best cost so far of up to {iterations} iterations"
        raise InputError(message)
    found = Result(x=point, cost=true, history=history, evaluations=evaluations)
    return _whole(found, iterations)


def _nearest_cost(problem: Problem, point: Vector, said: float) -> float:
    """Return the cost of a point; with noise, the one nearest to what is said that it may have."""
    data = without_noise(problem, np.ascontiguousarray(problem.data))
    cost = value(problem.kernel, data, point)
    return min(cost + noise_of(problem), max(cost, said))
