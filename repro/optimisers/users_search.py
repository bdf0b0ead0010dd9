"""A user's own search, found by name and held to the rules of the others."""

import importlib
import math
import os
import sys
from dataclasses import dataclass
from typing import Any, ClassVar, Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.source_digests import digest_of
from repro.errors import InputError
from repro.optimisers.own_search import (
    OwnSearch,
    checked_point,
    filled,
    has_protocol,
    refuse_what_is_no_search,
)
from repro.optimisers.search import Budget, Problem, Result, noise_of, value, without_noise

Vector = NDArray[np.float64]
ROUNDING = 1e-9  # share by which a cost may differ that was summed in another order


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
            if has_protocol(found):
                return _by_protocol(found, problem, budget)
            return OwnSearch(search=found).minimise(problem, **budget)
        except SystemExit:
            message = "it tried to end the program"
            raise InputError(message) from None


def entrant(place: str) -> Entrant:
    """Return the search at a place; InputError where there is none."""
    return Entrant(place=place, source=digest_of(load(place), soft=True))


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
    refuse_what_is_no_search(found, place)
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
    point = checked_point(x, np.array(problem.bounds), "it returned")
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
    return filled(found, iterations)


def _nearest_cost(problem: Problem, point: Vector, said: float) -> float:
    """Return the cost of a point; with noise, the one nearest to what is said that it may have."""
    data = without_noise(problem, np.ascontiguousarray(problem.data))
    cost = value(problem.kernel, data, point)
    return min(cost + noise_of(problem), max(cost, said))
