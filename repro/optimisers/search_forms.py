"""The forms in which other people's searches come, each called as it is.

f(cost, bounds, budget, rng) -> x; a function like scipy's `minimize`, whose parameters say by their
names what they are; an object that is asked and told, or what makes one; an object, or a class of
one, with such a function as a method.
"""

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError
from repro.optimisers.asked_search import ask_and_tell, is_asked, started
from repro.optimisers.own_search import CALL
from repro.optimisers.search_box import as_wanted, pairs, parameters, says_parameters
from repro.optimisers.search_words import (
    BOUNDS,
    BUDGETS,
    COSTS,
    GENERATORS,
    METHODS,
    OTHERS,
    SEEDS,
    STARTS,
)

Vector = NDArray[np.float64]
_PROTOCOL = ("population", "evaluations", "rng")
_CHANCE = (*GENERATORS, *SEEDS)
_IN_PLACE = (COSTS, BOUNDS, BUDGETS, _CHANCE)
_SORTS = (*_IN_PLACE, STARTS)
_POSITIONAL = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
_OPEN = (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)


@dataclass(frozen=True, slots=True, kw_only=True)
class Offer:
    """What a search may be given: the cost, the box, how much it may spend, and its chance.

    The budget is that of `population` agents that are all evaluated in each iteration.
    """

    cost: Callable[..., Any]
    bounds: Vector
    budget: int
    rng: np.random.Generator
    population: int = 1

    def named(self, parameter: inspect.Parameter) -> Any:  # noqa: ANN401 (one of many)
        """Return what a parameter asks for by its name; KeyError for any other name."""
        name, (low, high) = parameter.name.lower(), self.bounds.T
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
                 "step": float(np.mean(high - low)) / 5, "population": self.population,
                 "iterations": self.budget // self.population}  # fmt: skip
        return words[OTHERS[name]] if name in OTHERS else made[name]()

    def given(self, known: list[inspect.Parameter]) -> dict[str, Any]:
        """Return what each parameter asks for; one of each sort is enough."""
        given: dict[str, Any] = {}
        taken: set[tuple[str, ...]] = set()
        for parameter in known:
            name = parameter.name.lower()
            sort = next((each for each in _SORTS if name in each), (name,))
            needed = parameter.default is inspect.Parameter.empty
            if (sort in taken or sort not in _SORTS) and not needed:
                continue
            if parameter.kind not in _OPEN:
                taken.add(sort)
                given[parameter.name] = self.named(parameter)
        return given


def speaks_protocol(found: object) -> bool:
    """Return whether something is an object with the `minimise` of `Optimiser`."""
    minimise = getattr(found, "minimise", None)
    if isinstance(found, type) or not callable(minimise):
        return False
    try:
        inspect.signature(minimise).bind(None, **dict.fromkeys(_PROTOCOL))
    except TypeError:
        return False
    except ValueError:  # a compiled method that does not say how it is called
        return True
    return True


def as_object(found: Any) -> Any:  # noqa: ANN401 (whatever the user wrote)
    """Return an object of a class that needs nothing to be made, and anything else as it is."""
    bare = isinstance(found, type) and not is_asked(found) and not _needed(parameters(found))
    return found() if bare else found


def check_form(found: Any, place: str) -> None:  # noqa: ANN401 (whatever the user wrote)
    """Raise InputError, which names the place, for what is no form of a search."""
    if isinstance(found, type) and not is_asked(found):
        _check_class(found, place)
        return
    if speaks_protocol(found) or (is_asked(found) and not isinstance(found, type)):
        return
    called = _called(found)
    if called is None:
        message = f"{place} is neither an object with minimise(problem, …) nor a callable {CALL}"
        raise InputError(message)
    if inspect.iscoroutinefunction(called) or inspect.isgeneratorfunction(called):
        message = f"{place} cannot be called as {CALL}: it returns before it has searched"
        raise InputError(message)
    if not is_called_by_place(called) and (because := _because(called)):
        message = f"{place} cannot be called as {CALL}{because}"
        raise InputError(message)


def called_with(found: Any, offer: Offer) -> Any:  # noqa: ANN401
    """Run a search in its own form and return what it returns, or recommends when it is asked."""
    if is_asked(found) and not isinstance(found, type):
        return _asked(started(found, offer.given), offer)
    called = found if isinstance(found, type) else _called(found)
    known = parameters(called)
    if is_called_by_place(called) and not isinstance(found, type):
        second = known[1] if len(known) > 1 else None
        returned = called(offer.cost, as_wanted(offer.bounds, second), offer.budget, offer.rng)
    else:
        first = [p for p in known if p.kind is inspect.Parameter.POSITIONAL_ONLY]
        named = offer.given(known)
        before = [named.pop(p.name) for p in first if p.name in named]
        returned = called(*before, **named)
    if is_asked(returned):
        return _asked(returned, offer)
    if isinstance(found, type):
        last = _called(returned)
        return last(**offer.given(parameters(last)))
    return returned


def is_called_by_place(function: Callable[..., Any]) -> bool:
    """Return whether a callable takes cost, bounds, budget and rng in this order."""
    known = parameters(function)
    if not known:
        return not says_parameters(function)
    if any(each.kind is inspect.Parameter.VAR_POSITIONAL for each in known):
        return True
    needed = [p for p in _needed(known) if p.kind in _POSITIONAL]
    others = [p for p in _needed(known) if p.kind not in _POSITIONAL]
    return len(needed) == 4 and not _unknown(others) and not _stand_elsewhere(needed)


def _stand_elsewhere(needed: list[inspect.Parameter]) -> bool:
    """Return whether names say that cost, bounds, budget and rng are not what stands here."""
    for parameter, sort in zip(needed, _IN_PLACE, strict=True):
        name = parameter.name.lower()
        means = next((each for each in _SORTS if name in each), None)
        if (means and means is not sort) or name in SEEDS or (name in OTHERS and len(name) > 1):
            return True
    return False


def _asked(found: Any, offer: Offer) -> Any:  # noqa: ANN401
    return ask_and_tell(found, offer.cost, pairs(offer.bounds))


def _called(found: Any) -> Any:  # noqa: ANN401
    """Return what is called of a search: itself, or a method of it; None where there is nothing."""
    if callable(found):
        return found
    methods = (getattr(found, name, None) for name in METHODS)
    return next((method for method in methods if callable(method)), None)


def _check_class(found: type, place: str) -> None:
    """Raise InputError for a class that makes no search, or cannot be made."""
    if not _needed(parameters(found)):
        try:
            check_form(found(), place)
        except InputError:
            raise
        except Exception as error:  # noqa: BLE001 (a class of the user's may raise anything)
            message = f"{place} is a class that cannot be made: {type(error).__name__}: {error}"
            raise InputError(" ".join(message.split())) from None
        return
    if unknown := _unknown(_needed(parameters(found))):
        message = f"{place} is a class that needs {unknown[0]!r}: name an object of it"
        raise InputError(message)
    names = {name for one in found.__mro__ for name in vars(one)}
    if not names & {"__call__", *METHODS}:
        message = f"{place} is a class without a method {', '.join(METHODS)} or __call__"
        raise InputError(message)


def _because(called: Callable[..., Any]) -> str:
    """Return why something cannot be called by the names of its parameters, "" where it can."""
    known = parameters(called)
    names = {parameter.name.lower() for parameter in known}
    chance = names & {*_CHANCE, *STARTS}
    strict = _needed(known) == known and names & set(BUDGETS)
    if unknown := _unknown(_needed(known)):
        return f"; {unknown[0]!r} says not what it asks for"
    if strict and not chance and names & set(COSTS):
        return ": it takes no rng"
    if names & set(COSTS):
        return "" if names & {*BOUNDS, *STARTS, *OTHERS} else ": it asks for no bounds"
    # without a cost it may return an object that is asked and told
    return "" if names & {*BOUNDS, *_CHANCE, "lower", "lb"} else ": it asks for no cost"


def _needed(known: list[inspect.Parameter]) -> list[inspect.Parameter]:
    return [p for p in known if p.default is p.empty and p.kind not in _OPEN]


def _unknown(known: list[inspect.Parameter]) -> list[str]:
    """Return the parameters whose names say nothing."""
    words = {*COSTS, *BOUNDS, *BUDGETS, *_CHANCE, *STARTS, *OTHERS}
    return [p.name for p in known if p.name.lower() not in words]
