"""Digests of what a run rests on: the objects that it is given, and the source that they reach.

What a digest follows and what it leaves out stands in docs/determinism.md.
"""

import sys
import types
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from repro.determinism.definitions import Definition, Reached, changes_in_runs, digest, reached
from repro.determinism.held_values import Teller, fields_of
from repro.determinism.source_files import is_of_engine, is_own

Parts = Mapping[str, str]
"""What something is made of: names in words, each with a digest."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Told:
    """What some objects are: digests of their values by name, and the definitions they rest on."""

    values: Parts
    roots: frozenset[Definition]

    @property
    def digest(self) -> str:
        """A digest of all of it."""
        return digest(f"{sorted(self.values.items())}{_joined(self.roots)}")

    @property
    def sources(self) -> str:
        """A digest of the source code alone, whatever the values are."""
        return _joined(self.roots)

    @property
    def parts(self) -> Parts:
        """Every value and every definition, by name."""
        return {**_sources(self.roots), **self.values}


def told(**objects: object) -> Told:
    """Return what some objects are, each under its name, with each of its fields.

    Raises DeclarationError, naming the place, for an object whose value cannot be told.
    """
    teller = Teller()
    values = {
        name: digest(text)
        for place, value in objects.items()
        for name, text in _fields(teller, value, place)
    }
    return Told(values=values, roots=frozenset(teller.roots))


def together(*several: Told) -> Told:
    """Return what several say as one."""
    values = {name: text for one in several for name, text in one.values.items()}
    return Told(values=values, roots=frozenset[Definition]().union(*(o.roots for o in several)))


def digest_of(value: object, *, soft: bool = False) -> str:
    """Return a digest of all that an object is, holds and reaches.

    With `soft` what cannot be told is its type alone; else DeclarationError.
    """
    teller = Teller(soft=soft)
    text = teller.text(value, type(value).__name__)
    return digest(f"{text}\0{_joined(frozenset(teller.roots))}")


def _fields(teller: Teller, value: object, place: str) -> Iterator[tuple[str, str]]:
    """Yield an object as a text, and each field of one that is ours or a user's by itself."""
    yield place, teller.text(value, place)
    if is_own(type(value).__module__):
        for name, held in fields_of(value):
            yield f"{place}.{name}", Teller(soft=True).text(held, name)


@cache
def _joined(roots: frozenset[Definition]) -> str:
    return digest(str(sorted(_sources(roots).items())))


@cache
def _sources(roots: frozenset[Definition]) -> Parts:
    while True:
        found = reached(roots)
        teller = Teller(soft=True)
        values = {f"value of {one}": digest(teller.text(v, str(one))) for one, v in _loaded(found)}
        if teller.roots <= found.keys():
            return MappingProxyType({**{str(one): text for one, text in found.items()}, **values})
        roots |= teller.roots


def _loaded(found: Reached) -> Iterator[tuple[Definition, object]]:
    """Yield what names stand for now: it may come from a file, or be set from elsewhere.

    What functions change while runs go is left out, and of the engine what is as it was written.
    """
    for one in found:
        if one.name and is_own(one.module):
            names = vars(sys.modules.get(one.module, object))
            if one.name in names and not changes_in_runs(one) and _may_be_set(one, names[one.name]):
                yield one, names[one.name]


def _may_be_set(one: Definition, value: object) -> bool:
    """Return whether a value may be another one than its definition makes, as far as it shows."""
    if not is_of_engine(one.module):
        return True
    made = getattr(value, "py_func", value)
    if isinstance(made, type | types.FunctionType):
        return (made.__module__, made.__qualname__) != (one.module, one.name)
    return isinstance(value, int | float | str | tuple)
