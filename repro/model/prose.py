"""The prose of a paper, read from the TOML beside its module: the one file that this room opens."""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, fields, replace
from inspect import cleandoc
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

from repro.errors import DeclarationError
from repro.model.assumptions import Alternative, Assumption
from repro.model.known_words import shown_value
from repro.model.open_points import Erratum, Gap
from repro.model.paper import Formula, Paper, Source

T = TypeVar("T")
Entry = Mapping[str, Any]
_LISTS = ("assumption", "erratum", "gap", "formula")
_TEXTS = ("summary", "together", "source")
_NO_TEXTS: Mapping[str, tuple[type, ...]] = MappingProxyType(
    {
        "year": (int, str),
        "at": (int, float),
        "ruled_out": (bool,),
        "open": (bool,),
        "full_depth": (bool,),
        "result": (bool,),
    }
)


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
            alternatives = (each for own in assumptions for each in own.alternatives)
            known = ", ".join(repr(each.name) for each in alternatives if each.name)
            names = ", ".join(map(repr, unbound))
            message = f"{self.place}: changes of {names}, which no alternative is; there is {known}"
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
    content = _content(path)
    source = content.get("source", {})
    if not isinstance(source, dict):
        message = f"{place}, source is {shown_value(source)}: it stands once, as [source]"
        raise DeclarationError(message)
    lists = {name: _entries(content.get(name, []), f"{place}, {name}") for name in _LISTS}
    return Prose(
        place=place,
        key=key,
        source=_made(Source, source, f"{place}, source"),
        summary=_text(content.get("summary"), f"{place}, summary"),
        together=tuple(_texts(content.get("together", []), f"{place}, together")),
        assumptions=lists["assumption"],
        errata=tuple(
            _made(Erratum, each, f"{place}, erratum {k}") for k, each in _counted(lists["erratum"])
        ),
        gaps=_gaps(lists["gap"], place),
        formulas=tuple(
            _formula(each, f"{place}, formula {k}") for k, each in _counted(lists["formula"])
        ),
    )


def _content(path: Path) -> Entry:
    """Return what a TOML holds; DeclarationError where it cannot be read or means nothing here."""
    place = path.name
    try:
        content: Entry = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        message = (
            f"{path} is not there: the prose of a paper stands in a TOML of its module's name, "
            "as `repro new` writes it"
        )
        raise DeclarationError(message) from None
    except (OSError, ValueError) as error:
        message = f"{path} cannot be read: {error}"
        raise DeclarationError(message) from None
    if unknown := content.keys() - {*_LISTS, *_TEXTS}:
        known = ", ".join((*_TEXTS, *_LISTS))
        message = f"{place}: {', '.join(sorted(unknown))} means nothing here; known: {known}"
        raise DeclarationError(message)
    return content


def _entries(found: object, place: str) -> tuple[Entry, ...]:
    """Return the tables of a list; DeclarationError for what is none."""
    if not isinstance(found, list) or not all(isinstance(each, dict) for each in found):
        name = place.rpartition(" ")[2]
        heading = "assumption.or" if name == "or" else name
        message = (
            f"{place} is {shown_value(found)}: write [[{heading}]], in two pairs of brackets, "
            "above each, if there is but one, too"
        )
        raise DeclarationError(message)
    return tuple(found)


def _texts(found: object, place: str) -> list[str]:
    if not isinstance(found, list):
        message = f"{place} is {found!r}, not a list of names"
        raise DeclarationError(message)
    return [_text(each, place) for each in found]


def _text(found: object, place: str) -> str:
    if not isinstance(found, str) or not found.strip():
        message = f"{place} is {'not there' if found is None else repr(found)}: it must be a text"
        raise DeclarationError(message)
    return found


def _counted(entries: tuple[Entry, ...]) -> Iterator[tuple[int, Entry]]:
    return enumerate(entries, start=1)


def _gaps(entries: tuple[Entry, ...], place: str) -> dict[str, Gap]:
    found: dict[str, Gap] = {}
    for k, entry in _counted(entries):
        own = {name: value for name, value in entry.items() if name != "name"}
        gap = _made(Gap, own, f"{place}, gap {k}")
        name = _text(entry.get("name", gap.what), f"{place}, gap {k}, name")
        if name in found:
            message = f"{place}, gap {k}: another gap is called {name!r} too"
            raise DeclarationError(message)
        found[name] = gap
    return found


def _formula(entry: Entry, place: str) -> Formula:
    """Return a formula; its LaTeX is indented in the file alone."""
    made = _made(Formula, entry, place)
    return replace(made, latex=cleandoc(made.latex))


def _assumption(place: str, entry: Entry, unbound: dict[str, Entry]) -> Assumption:
    """Return an assumption with its alternatives; take what they change out of `unbound`."""
    where = f"{place}, assumption {entry.get('what', '')!r}"
    alternatives = tuple(
        _made(
            Alternative, each, f"{where}, alternative {k}", unbound.pop(str(each.get("name")), {})
        )
        for k, each in _counted(_entries(entry.get("or", []), f"{where}, or"))
    )
    own = {name: value for name, value in entry.items() if name != "or"}
    return _made(Assumption, own, where, {"alternatives": alternatives})


def _made(kind: type[T], entry: Entry, place: str, besides: Entry = MappingProxyType({})) -> T:
    """Return a declaration made of an entry of texts, and of what the module has besides."""
    known = {each.name: each for each in fields(kind)}  # type: ignore[arg-type]
    said = {**entry, **besides}
    strange = [name for name in said if name not in known]
    lacking = [
        name
        for name, each in known.items()
        if name not in said and each.default is MISSING and each.default_factory is MISSING
    ]
    for names, fault in ((strange, "means nothing here"), (lacking, "is missing")):
        if names:
            message = f"{place}: {', '.join(map(repr, names))} {fault}; it has {', '.join(known)}"
            raise DeclarationError(message)
    for name, value in entry.items():
        kinds = _NO_TEXTS.get(name)
        if not kinds:
            _text(value, f"{place}, {name}")
        elif type(value) not in kinds:
            allowed = " or ".join(each.__name__ for each in kinds)
            message = f"{place}, {name} is {value!r}: it must be {allowed}"
            raise DeclarationError(message)
    return kind(**said)
