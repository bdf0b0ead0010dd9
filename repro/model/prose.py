"""The prose of a paper, read from the TOML beside its module: the one file that this room opens."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from inspect import cleandoc
from pathlib import Path
from typing import Any, TypeVar

from repro.errors import DeclarationError
from repro.model.open_points import Erratum, Gap
from repro.model.paper import Alternative, Assumption, Formula, Paper, Source

T = TypeVar("T")
Entry = Mapping[str, Any]
_LISTS = ("assumption", "erratum", "gap", "formula")
_TEXTS = ("summary", "together", "source")


@dataclass(frozen=True, slots=True, kw_only=True)
class Prose:
    """What a paper's TOML says: `[source]`, `[[assumption]]` with `[[assumption.or]]`, and so on.

    `gaps` are found by their `name`, or by what is missing where they have none.
    """

    place: str
    key: str
    source: Source
    summary: str
    together: tuple[str, ...]
    assumptions: tuple[Entry, ...]
    errata: tuple[Erratum, ...]
    gaps: Mapping[str, Gap]
    formulas: tuple[Formula, ...]

    def gap(self, name: str) -> Gap:
        """Return the gap of that name; DeclarationError names those that there are."""
        if name not in self.gaps:
            message = f"{self.place}: no gap {name!r}; there is {', '.join(self.gaps) or 'none'}"
            raise DeclarationError(message)
        return self.gaps[name]

    def paper(self, *, changes: Mapping[str, Entry], **parts: Any) -> Paper:  # noqa: ANN401
        """Return the paper of this prose and of what its module declares.

        `changes` says by the name of an alternative what it changes: its fields `algorithms`,
        `problems`, `protocol`, `claims`. DeclarationError for a name that no alternative has.
        """
        unbound = dict(changes)
        assumptions = tuple(_assumption(self.place, entry, unbound) for entry in self.assumptions)
        if unbound:
            names = ", ".join(map(repr, unbound))
            message = f"{self.place}: changes without an alternative of that name: {names}"
            raise DeclarationError(message)
        return Paper(
            key=self.key,
            source=self.source,
            summary=self.summary,
            together=self.together,
            assumptions=assumptions,
            errata=self.errata,
            gaps=tuple(self.gaps.values()),
            formulas=self.formulas,
            **parts,
        )


def prose(module: str) -> Prose:
    """Return the prose beside a module, which gives its `__file__`: KEY.toml beside KEY.py.

    Raises DeclarationError for a file that cannot be read and for entries that mean nothing.
    """
    path = Path(module)
    key = path.stem if path.stem != "__init__" else path.parent.name
    path = path.with_name(f"{key}.toml")
    place = path.name
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        message = f"{path} cannot be read: {error}"
        raise DeclarationError(message) from None
    if unknown := content.keys() - {*_LISTS, *_TEXTS}:
        known = ", ".join((*_TEXTS, *_LISTS))
        message = f"{place}: {', '.join(sorted(unknown))} means nothing here; known: {known}"
        raise DeclarationError(message)
    lists = {name: tuple(content.get(name, ())) for name in _LISTS}
    return Prose(
        place=place,
        key=key,
        source=_made(Source, content.get("source", {}), f"{place}, source"),
        summary=content.get("summary", ""),
        together=tuple(content.get("together", ())),
        assumptions=lists["assumption"],
        errata=tuple(_made(Erratum, entry, f"{place}, erratum") for entry in lists["erratum"]),
        gaps=dict(_gap(place, entry) for entry in lists["gap"]),
        formulas=tuple(_formula(place, entry) for entry in lists["formula"]),
    )


def _gap(place: str, entry: Entry) -> tuple[str, Gap]:
    gap = _made(Gap, {k: v for k, v in entry.items() if k != "name"}, f"{place}, gap")
    return entry.get("name", gap.what), gap


def _formula(place: str, entry: Entry) -> Formula:
    """Return a formula; its LaTeX is indented in the file alone."""
    latex = cleandoc(entry.get("latex", ""))
    return _made(Formula, {**entry, "latex": latex}, f"{place}, formula")


def _assumption(place: str, entry: Entry, unbound: dict[str, Entry]) -> Assumption:
    """Return an assumption with its alternatives; take what they change out of `unbound`."""
    where = f"{place}, assumption {entry.get('what', '')!r}"
    alternatives = tuple(
        _made(Alternative, {**each, **unbound.pop(each.get("name", ""), {})}, where)
        for each in entry.get("or", ())
    )
    own = {name: value for name, value in entry.items() if name != "or"}
    return _made(Assumption, {**own, "alternatives": alternatives}, where)


def _made(kind: type[T], fields: Entry, place: str) -> T:
    try:
        return kind(**fields)
    except TypeError as error:
        message = f"{place}: {str(error).partition('() ')[2] or error}"
        raise DeclarationError(message) from None
