"""A user's own search, found by name and held to the rules of the others."""

import hashlib
import importlib
import math
import os
import sys
from contextlib import chdir, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.plain_costs import callable_cost
from repro.determinism.source_digests import digest_of
from repro.errors import InputError
from repro.optimisers.asked_search import is_asked
from repro.optimisers.global_generators import seeded
from repro.optimisers.libraries.budget import BudgetSpent, iterations_of
from repro.optimisers.metered import ELSEWHERE, Meter, MeteredProblem, stopping_threads
from repro.optimisers.own_search import checked_point, filled
from repro.optimisers.returned_points import point_in
from repro.optimisers.search import Budget, Problem, Result, noise_of, value, without_noise
from repro.optimisers.search_forms import (
    Offer,
    as_object,
    called_with,
    check_form,
    speaks_protocol,
)

Vector = NDArray[np.float64]
ROUNDING = 1e-9  # share by which a cost may differ that was summed in another order


@dataclass(frozen=True, slots=True, kw_only=True)
class Entrant:
    """A search named by its place, "module:object"; `source` is the digest of its source code.

    It comes in one of the forms that `search_forms` knows, or is an object with our protocol. Its
    evaluations are those that its cost is asked for. The generators that all of a program shares
    are seeded by the run, so that it comes out again.
    """

    holds_interpreter: ClassVar[bool] = True
    seeds_shared: ClassVar[bool] = True
    place: str
    source: str

    def found(self) -> Any:  # noqa: ANN401 (whatever the user wrote)
        """Return the search; InputError where there is none."""
        return load(self.place)

    def prepare(self, problem: Problem) -> None:
        """Load the search and compile the cost, which is no part of the time of a run."""
        self.found()
        bounds, data = np.array(problem.bounds, dtype=np.float64), np.array(problem.data)
        callable_cost(problem.kernel)(bounds.mean(axis=1), data.astype(np.float64))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by at most N·T evaluations.

        Raises InputError for a search that leaves the box, overspends or returns no point.
        """
        return self.noted(problem, budget)[0]

    def noted(self, problem: Problem, budget: Budget, salt: str = "") -> tuple[Result, str]:
        """Return the result, and what is to be said of how it was counted, "" for nothing.

        With another `salt` the shared generators are seeded otherwise. Raises as `minimise`.
        """
        state = f"{salt}{budget['rng'].bit_generator.state}"
        seed = int.from_bytes(hashlib.sha256(state.encode()).digest()[:4], "big")
        try:
            with (
                seeded(seed),
                stopping_threads(),
                chdir(Path.cwd()),
            ):  # each run begins where all do
                found = as_object(self.found())
                if speaks_protocol(found):
                    return _by_protocol(found, problem, budget)
                return _by_call(found, problem, budget), ""
        except SystemExit:
            message = "it tried to end the program"
            raise InputError(message) from None


def _by_call(found: Any, problem: Problem, budget: Budget) -> Result:  # noqa: ANN401
    """Run a search until it ends or its budget does."""
    steps = iterations_of(budget)
    meter = Meter(problem, population=budget["population"], iterations=steps)
    offer = Offer(
        cost=meter.as_function(), bounds=meter.bounds, budget=meter.budget, rng=budget["rng"],
        population=budget["population"],
    )  # fmt: skip
    try:
        returned = called_with(found, offer)
        if returned is not None or not (is_asked(found) or meter.spent):
            meter.judge(point_in(returned, len(meter.bounds)))
    except BudgetSpent:
        pass
    except Exception as error:
        if Meter.as_function.__qualname__ in str(error):  # of pickle, which cannot send it
            raise InputError(ELSEWHERE) from None
        if not meter.overrun:  # what a library makes of being stopped, SystemError in C
            raise
    if meter.faults:
        raise meter.faults[0]
    return filled(meter.result(), steps)


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
    check_form(found, place)
    return found


def _imported(module: str) -> Any:  # noqa: ANN401
    here = os.getcwd()  # noqa: PTH109 (sys.path holds texts)
    if here not in sys.path:
        sys.path.insert(0, here)
    try:
        with redirect_stdout(sys.stderr):  # what a search prints is no answer of ours
            return importlib.import_module(module)
    except ModuleNotFoundError as error:
        missing = f"no module {error.name!r} in this folder or among the installed ones"
        message = missing if error.name == module else f"{module!r} cannot be imported: {missing}"
        raise InputError(message) from None
    except (Exception, SystemExit) as error:  # noqa: BLE001 (the user's module may do anything)
        message = f"{module!r} cannot be imported: {type(error).__name__}: {error}"
        raise InputError(message) from None


def _by_protocol(search: Any, problem: Problem, budget: Budget) -> tuple[Result, str]:  # noqa: ANN401
    population, iterations = budget["population"], iterations_of(budget)
    meter = Meter(problem, population=population, iterations=iterations)
    allowed, rng = meter.budget, budget["rng"]
    shown = MeteredProblem(problem, meter)
    try:
        result = search.minimise(shown, population=population, evaluations=allowed, rng=rng)
    except BudgetSpent:
        result = None
    except Exception:
        if not meter.overrun:
            raise
        result = None
    if meter.overrun:
        note = f"it went on after the {allowed} evaluations of a run and was stopped there"
        return filled(meter.result(), iterations), note
    found, said = _told(result, problem, allowed, iterations)
    counted = meter.spent or said
    note = f"it declares {said} evaluations, and its cost was asked {meter.spent} times"
    found = Result(x=found.x, cost=found.cost, history=found.history, evaluations=counted)
    return filled(found, iterations), "" if said == meter.spent else note


def _told(result: Any, problem: Problem, allowed: int, iterations: int) -> tuple[Result, int]:  # noqa: ANN401
    """Return what an object says that it found, checked, and the evaluations that it declares."""
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
    return Result(x=point, cost=true, history=history, evaluations=evaluations), evaluations


def _nearest_cost(problem: Problem, point: Vector, said: float) -> float:
    """Return the cost of a point; with noise, the one nearest to what is said that it may have."""
    data = without_noise(problem, np.ascontiguousarray(problem.data))
    cost = value(problem.kernel, data, point)
    return min(cost + noise_of(problem), max(cost, said))
