"""Whether the fields of a declaration hold what their annotations say, a line a fault."""

import types
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from repro.model.assumptions import Alternative
from repro.model.known_words import shown_value
from repro.tables.relations import PlacedNumber, TextNumber

_NUMBERS: dict[type, tuple[type, ...]] = {
    int: (int, np.integer),
    float: (int, float, np.integer, np.floating),
}

# what is declared inside of relations and assumptions; runs, tables and measures are looked at
# by those who know them
_SAID_ELSEWHERE = ("population", "iterations", "runs", "evaluations", "accepted")
_WITHIN = (TextNumber, PlacedNumber, Alternative)


def kind_faults(place: str, of: object) -> Iterator[str]:
    """Yield the fields of a dataclass that hold another kind of thing than is meant there.

    What an annotation leaves open, and kinds that others implement, are left to whoever uses them.
    """
    for name, hint in _hints(type(of)).items():  # type: ignore[arg-type]
        value = getattr(of, name)
        if name not in _SAID_ELSEWHERE and not _fits(value, hint):
            yield f"{place}, {name}: {shown_value(value)} is no {kind_words(hint)}"
            continue
        for k, part in enumerate(_parts(value), start=1):
            inside = f"{place}, {name}" if part is value else f"{place}, {name} {k}"
            yield from kind_faults(inside, part)


@cache
def _hints(kind: type) -> dict[str, Any]:
    try:
        hints = get_type_hints(kind)
    except NameError:  # an annotation of what is imported for the type checker alone
        return {}
    return {name: hints[name] for name in getattr(kind, "__dataclass_fields__", ())}


def _parts(value: object) -> Iterator[object]:
    """Yield the numbers and readings that stand in a field, which have fields themselves."""
    values = value if isinstance(value, tuple | list) else [value]
    yield from (each for each in values if isinstance(each, _WITHIN))


def _fits(value: Any, hint: Any) -> bool:  # noqa: ANN401 (anything)
    inside = get_args(hint)
    if get_origin(hint) in {Union, types.UnionType}:
        return any(_fits(value, each) for each in inside)
    if get_origin(hint) is Literal:
        return value in inside
    if get_origin(hint) is not None:
        return _is_container(value, get_origin(hint), inside)
    return not isinstance(hint, type) or _is_of(value, hint)


def _is_container(value: Any, origin: Any, inside: tuple[Any, ...]) -> bool:  # noqa: ANN401
    if origin is tuple:
        each = inside[0] if inside[1:] == (...,) else Any
        return isinstance(value, tuple | list) and all(_fits(part, each) for part in value)
    return origin not in {Mapping, dict} or isinstance(value, Mapping)


def _is_of(value: object, kind: type) -> bool:
    if getattr(kind, "_is_protocol", False):
        return all(hasattr(value, name) for name in vars(kind) if not name.startswith("_"))
    if isinstance(value, bool) and kind in _NUMBERS:
        return False
    return isinstance(value, _NUMBERS.get(kind, (kind,)))


def kind_words(hint: Any) -> str:  # noqa: ANN401 (a type, several, or an annotation)
    """Return what is meant by a type, a tuple of types or an annotation."""
    if hint in {None, type(None)}:
        return "None"
    origin, inside = get_origin(hint), get_args(hint)
    if isinstance(hint, tuple) or origin in {Union, types.UnionType}:
        return _listed(kind_words(each) for each in (inside or hint))
    if origin is Literal:
        return _listed(map(repr, inside))
    if inside and origin is tuple:
        return f"tuple of {kind_words(inside[0])}"
    return "text" if hint is str else str(getattr(hint, "__name__", hint))


def _listed(words: Iterable[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} or {last}" if first else last
