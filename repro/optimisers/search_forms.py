"""The forms in which other people's searches come, each called as it is.

f(cost, bounds, budget, rng) -> x; a function like scipy's `minimize`, whose parameters say by their
names what they are; an object with `ask` and `tell`, or what makes one.
"""

import copy
import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError
from repro.optimisers.own_search import CALL
from repro.optimisers.search_box import as_wanted, parameters

Vector = NDArray[np.float64]
COSTS = ("cost", "fun", "func", "function", "f", "objective", "objective_function", "obj_func",
         "fitness", "obj", "fn")  # fmt: skip
BOUNDS = ("bounds", "box", "limits", "ranges")
BUDGETS = ("budget", "evaluations", "maxfun", "maxfev", "max_evals", "max_evaluations", "n_calls",
           "max_fun", "nfev", "n_evals", "max_nfe")  # fmt: skip
GENERATORS = ("rng", "generator", "random_generator")
SEEDS = ("seed", "random_state", "random_seed")
STARTS = ("x0", "x_0", "initial_guess", "start")
OTHERS = {
    **dict.fromkeys(("lower", "lb", "xmin"), "lower"),
    **dict.fromkeys(("upper", "ub", "xmax"), "upper"),
    **dict.fromkeys(("dim", "dimension", "n"), "size"),
    "sigma0": "step",
}
_KINDS = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
_POINTS = ("x", "solution", "best_x", "xbest", "best_solution")


@dataclass(frozen=True, slots=True, kw_only=True)
class Offer:
    """What a search may be given: the cost, the box, how much it may spend, and its chance."""

    cost: Callable[..., Any]
    bounds: Vector
    budget: int
    rng: np.random.Generator

    def named(self, parameter: inspect.Parameter) -> Any:  # noqa: ANN401 (one of many)
        """Return what a parameter asks for by its name; KeyError for any other name."""
        name, (low, high) = parameter.name, self.bounds.T
        if name in BOUNDS:
            return as_wanted(self.bounds, parameter)
        made: dict[str, Callable[[], Any]] = {
            **dict.fromkeys(COSTS, lambda: self.cost),
            **dict.fromkeys(BUDGETS, lambda: self.budget),
            **dict.fromkeys(GENERATORS, lambda: self.rng),
            **dict.fromkeys(SEEDS, lambda: int(self.rng.integers(2**31))),
            **dict.fromkeys(STARTS, lambda: self.rng.uniform(low, high)),
        }
        words = {"lower": low.copy(), "upper": high.copy(), "size": len(low),
                 "step": float(np.mean(high - low)) / 5}  # fmt: skip
        return words[OTHERS[name]] if name in OTHERS else made[name]()


def is_asked(found: object) -> bool:
    """Return whether something, an object or a class of it, has `ask` and `tell`."""
    return callable(getattr(found, "ask", None)) and callable(getattr(found, "tell", None))


def is_called_by_place(function: Callable[..., Any]) -> bool:
    """Return whether a callable takes cost, bounds, budget and rng in this order."""
    known = parameters(function)
    if not known or any(each.kind is inspect.Parameter.VAR_POSITIONAL for each in known):
        return True
    needed = [p for p in known if p.kind in _KINDS and p.default is inspect.Parameter.empty]
    return len(needed) == 4 and not _unknown(known, keyword_only=True)


def check_form(found: Any, place: str) -> None:  # noqa: ANN401 (whatever the user wrote)
    """Raise InputError, which names the place, for what is no form of a search."""
    if is_asked(found) and not isinstance(found, type):
        return
    if not callable(found):
        message = f"{place} is neither an object with minimise(problem, …) nor a callable {CALL}"
        raise InputError(message)
    if isinstance(found, type) and not is_asked(found):
        message = f"{place} is a class: name an object of it"
        raise InputError(message)
    known = parameters(found)
    if is_called_by_place(found):
        return
    names = {parameter.name for parameter in known}
    chance = {*GENERATORS, *SEEDS, *STARTS} & names
    strict = all(p.default is inspect.Parameter.empty for p in known) and names & set(BUDGETS)
    if unknown := _unknown(known):
        message = f"{place} cannot be called as {CALL}; {unknown[0]!r} says not what it asks for"
    elif strict and not chance and names & set(COSTS):
        message = f"{place} cannot be called as {CALL}: it takes no rng"
    elif names & set(COSTS) or ({"bounds", *GENERATORS, *SEEDS} & names and _makes_asked(found)):
        if names & {*BOUNDS, *STARTS, *OTHERS}:
            return
        message = f"{place} cannot be called as {CALL}: it asks for no bounds"
    else:
        message = f"{place} cannot be called as {CALL}"
    raise InputError(message)


def _makes_asked(found: Any) -> bool:  # noqa: ANN401
    """Return whether a callable may return an object with `ask` and `tell`: it takes no cost."""
    return is_asked(found) or not {p.name for p in parameters(found)} & set(COSTS)


def _unknown(known: list[inspect.Parameter], *, keyword_only: bool = False) -> list[str]:
    """Return the parameters without a default whose names say nothing."""
    words = {*COSTS, *BOUNDS, *BUDGETS, *GENERATORS, *SEEDS, *STARTS, *OTHERS}
    kinds = (
        (inspect.Parameter.KEYWORD_ONLY,)
        if keyword_only
        else (*_KINDS, inspect.Parameter.KEYWORD_ONLY)
    )
    return [
        p.name for p in known if p.kind in kinds and p.default is p.empty and p.name not in words
    ]


def called_with(found: Any, offer: Offer) -> Any:  # noqa: ANN401
    """Run a search in its own form and return what it returns; an ask/tell loop returns None."""
    if is_asked(found) and not isinstance(found, type):
        return ask_and_tell(_started(copy.deepcopy(found), offer), offer)
    known = parameters(found)
    if is_called_by_place(found) and not isinstance(found, type):
        second = known[1] if len(known) > 1 else None
        returned = found(offer.cost, as_wanted(offer.bounds, second), offer.budget, offer.rng)
    else:
        returned = found(**_by_name(known, offer))
    return ask_and_tell(returned, offer) if is_asked(returned) else returned


def _by_name(known: list[inspect.Parameter], offer: Offer) -> dict[str, Any]:
    """Return what each parameter asks for; one of each sort is enough."""
    given: dict[str, Any] = {}
    sorts = (COSTS, BOUNDS, BUDGETS, (*GENERATORS, *SEEDS), STARTS)
    taken: set[tuple[str, ...]] = set()
    for parameter in known:
        sort = next((each for each in sorts if parameter.name in each), (parameter.name,))
        needed = parameter.default is inspect.Parameter.empty
        open_kind = parameter.kind in (
            inspect.Parameter.VAR_KEYWORD,
            inspect.Parameter.VAR_POSITIONAL,
        )
        if open_kind or (sort in taken and not needed) or (not needed and sort not in sorts):
            continue
        taken.add(sort)
        given[parameter.name] = offer.named(parameter)
    return given


def _started(found: Any, offer: Offer) -> Any:  # noqa: ANN401
    """Return an object with `ask`, told of its problem by `start` where it has that."""
    start = getattr(found, "start", None)
    if callable(start):
        start(**_by_name(parameters(start), offer))
    return found


def ask_and_tell(asked: Any, offer: Offer) -> None:  # noqa: ANN401 (an object with ask and tell)
    """Ask for points and tell their costs until the budget ends or the object stops.

    `ask` returns one point (n,) or some (m, n); `tell` takes points and costs, or pairs of them.
    """
    pairs = len(parameters(asked.tell)) == 1
    stop = next((s for s in (getattr(asked, n, None) for n in ("stop", "should_stop")) if s), None)
    while not (callable(stop) and stop()):
        points = asked.ask()
        single = np.ndim(points) == 1
        costs = [offer.cost(x) for x in ([points] if single else points)]
        if pairs:
            asked.tell(list(zip([points] if single else points, costs, strict=True)))
        else:
            asked.tell(points, costs[0] if single else costs)


def point_in(returned: Any, size: int) -> Any:  # noqa: ANN401
    """Return the point in what a search returned: itself, its `x`, or the first of a tuple."""
    for name in _POINTS:
        if not isinstance(returned, np.ndarray) and np.shape(_held(returned, name)) == (size,):
            return getattr(returned, name)
    if isinstance(returned, tuple) and returned and np.shape(_plain(returned[0])) == (size,):
        return returned[0]
    return returned


def _held(returned: Any, name: str) -> Any:  # noqa: ANN401
    return getattr(returned, name, None)


def _plain(part: Any) -> Any:  # noqa: ANN401
    return part if isinstance(part, list | tuple | np.ndarray) else None
