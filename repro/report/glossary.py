"""The words of the pages and of the manual."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from markupsafe import Markup

from repro.errors import InputError
from repro.model.identifiers import anchor

PAGE = "glossary"


@dataclass(frozen=True, slots=True, kw_only=True)
class Term:
    """A word with what it means; `see` are other words that explain it.

    `forms` is how pages write it where they mean this; None is the name, also with an s.
    """

    name: str
    says: str
    see: tuple[str, ...] = ()
    forms: tuple[str, ...] | None = None

    @property
    def anchor(self) -> str:
        """Its place on the page."""
        return anchor(self.name)

    @property
    def written(self) -> tuple[str, ...]:
        """What is a use of it on a page."""
        return (self.name, f"{self.name}s") if self.forms is None else self.forms


@dataclass(frozen=True, slots=True, kw_only=True)
class Glossary:
    """All words in their order, and what else the parts of a paper's pages are called."""

    terms: tuple[Term, ...]
    rooms: Mapping[str, str]


@cache
def glossary() -> Glossary:
    """Return what glossary.toml says."""
    path = files("repro.report") / "templates" / "glossary.toml"
    content = tomllib.loads(path.read_text(encoding="utf-8"))
    terms = (
        Term(
            name=each["name"],
            says=each["says"],
            see=tuple(each.get("see", ())),
            forms=tuple(each["forms"]) if "forms" in each else None,
        )
        for each in content["term"]
    )
    return Glossary(
        terms=tuple(sorted(terms, key=lambda term: term.name.lower())), rooms=content["rooms"]
    )


def term_link(name: str, text: str = "", *, markdown: bool) -> Markup:
    """Return a link from a page to a word; `text` stands in its place in the sentence.

    Raises InputError for a word that the glossary does not have.
    """
    found = next((term for term in glossary().terms if term.name == name), None)
    if found is None:
        message = f"{name!r} is not in glossary.toml"
        raise InputError(message)
    shown = text or name
    if markdown:
        return Markup("[{}]({}.md#{})").format(shown, PAGE, found.anchor)
    return Markup('<a class="term" href="{}.html#{}">{}</a>').format(PAGE, found.anchor, shown)
