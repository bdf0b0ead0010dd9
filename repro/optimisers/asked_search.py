"""Searches that are asked for points and told their costs, under whatever names."""

import copy
import inspect
from collections.abc import Callable, Sequence
from numbers import Real
from typing import Any

import numpy as np

from repro.optimisers.returned_points import point_in
from repro.optimisers.search_box import parameters

ASKS = ("ask", "suggest", "propose")
TELLS = ("tell", "observe")
_STOPS = ("stop", "should_stop", "is_finished", "has_finished")
_RECOMMENDS = ("provide_recommendation", "recommend")
_SIZES = ("population_size", "popsize")


def is_asked(found: object) -> bool:
    """Return whether something, an object or a class of it, can be asked and told."""
    return _first(found, ASKS) is not None and _first(found, TELLS) is not None


def ask_and_tell(asked: Any, cost: Callable[..., Any], pairs: Sequence[tuple[float, float]]) -> Any:  # noqa: ANN401
    """Ask for points and tell their costs until the budget ends or the object stops.

    What is asked for is one point or some, or one object or some that hold one each; a trial like
    optuna's is asked for its coordinates in `pairs`. What is told are points and costs, or a list
    of both. Returns what the object recommends where it stops, None where it recommends nothing.
    """
    ask, tell = _first(asked, ASKS), _first(asked, TELLS)
    stop, recommend = _question(asked), _first(asked, _RECOMMENDS)
    told_pairs = len(parameters(tell)) == 1
    waiting: list[tuple[Any, Any]] = []
    while not (stop and stop()):
        given = ask()
        single = _is_single(given, len(pairs))
        candidates = [given] if single else list(given)
        if not candidates:
            break
        costs = [cost(_point(candidate, pairs)) for candidate in candidates]
        if told_pairs:
            waiting += zip(candidates, costs, strict=True)
            if not single or len(waiting) >= _at_once(asked):
                tell(waiting)
                waiting = []
        elif single:
            tell(given, costs[0])
        else:
            tell(given, np.array(costs) if isinstance(given, np.ndarray) else costs)
    return recommend() if recommend else None


def started(found: Any, by_name: Callable[[list[inspect.Parameter]], dict[str, Any]]) -> Any:  # noqa: ANN401
    """Return a copy of an object, told of its problem by `start` where it has that."""
    own = copy.deepcopy(found)
    start = getattr(own, "start", None)
    if callable(start):
        start(**by_name(parameters(start)))
    return own


def _point(candidate: Any, pairs: Sequence[tuple[float, float]]) -> Any:  # noqa: ANN401
    suggest = getattr(candidate, "suggest_float", None)
    if callable(suggest):
        return [suggest(f"x{k}", *pair) for k, pair in enumerate(pairs)]
    return point_in(candidate, len(pairs))


def _is_single(given: Any, size: int) -> bool:  # noqa: ANN401
    """Return whether one point was asked for, not a list of them."""
    if not isinstance(given, list | tuple | np.ndarray):
        return True
    return len(given) == size and isinstance(given[0], Real)


def _at_once(asked: object) -> int:
    """Return how many costs an object wants to be told at once that is asked for single points."""
    found = (getattr(asked, name, None) for name in _SIZES)
    return next((size for size in found if isinstance(size, int)), 1)


def _question(asked: object) -> Callable[[], Any] | None:
    """Return what says whether the object is done; a `stop` that returns None is an order."""
    stop = _first(asked, _STOPS)
    if stop is None or any(p.default is p.empty for p in parameters(stop)):
        return None
    try:
        says = inspect.signature(stop).return_annotation
    except (TypeError, ValueError):
        says = inspect.Signature.empty
    return None if says in (None, "None") else stop


def _first(found: object, names: Sequence[str]) -> Any:  # noqa: ANN401 (a method of anything)
    methods = (getattr(found, name, None) for name in names)
    return next((method for method in methods if callable(method)), None)
