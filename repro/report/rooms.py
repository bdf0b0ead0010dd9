"""The pages of a paper: a door and rooms, what stands in which, and where a thing is found."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace

from jinja2 import pass_context
from jinja2.runtime import Context

from repro.errors import InputError
from repro.model.identifiers import anchor
from repro.report.verdict_pages import VERDICTS


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """A part of a page: `name` is its template's, `anchor` that of its heading."""

    name: str
    anchor: str
    title: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Room:
    """One page of a paper; the door has no name."""

    name: str
    title: str
    sections: tuple[Section, ...]


def _room(name: str, title: str, *sections: tuple[str, str, str]) -> Room:
    parts = (Section(name=own, anchor=place, title=says) for own, place, says in sections)
    return Room(name=name, title=title, sections=tuple(parts))


ROOMS = (
    _room(
        "", "At a glance",
        ("title", "title", "what it comes to"),
        ("heat_map", "at-a-glance", "every number as a square"),
        ("times", "times", "times side by side"),
        ("summary", "summary", "summary, and how sure"),
        ("claims", "claims", "claims of the text"),
        ("contents", "rooms", "rooms"),
    ),
    _room("tables", "Every number", ("tables", "tables", "tables")),
    _room("optimum", "Certified optimum", ("optimum", "optimum", "certified optimum")),
    _room(
        "readings", "Readings and assumptions",
        ("readings", "readings", "other readings"),
        ("assumptions", "assumptions", "assumptions"),
    ),
    _room("audit", "Audit", ("audit", "audit", "audit")),
    _room(
        "statistics", "Statistics",
        ("distributions", "distributions", "how the runs are spread"),
        ("comparison", "comparison", "rank-sum tests and ranks"),
        ("centre_bias", "centre-bias", "centre bias"),
        ("baselines", "baselines", "baselines and equal budgets"),
    ),
    _room("figures", "Figures", ("figures", "figures", "figures")),
    _room("arm", "The arm, moving", ("arm", "arm", "arm")),
    _room("equations", "Equations", ("formulas", "equations", "equations")),
    _room(
        "data", "Run it again, and data",
        ("again", "again", "run it again"),
        ("provenance", "provenance", "provenance"),
    ),
)  # fmt: skip
"""Every room that a paper may have, in their order. What moves to another room moves here alone."""
DOOR = ROOMS[0]
_ROOM_OF = {section.name: room for room in ROOMS for section in room.sections}
_ANCHOR_OF = {section.name: section.anchor for room in ROOMS for section in room.sections}
OURS = "repro"
"""What each page names as its generator: so a page that we wrote is told from another's."""
_OWN = ("index", "verdicts", "glossary", VERDICTS)  # names of pages that are of no one paper


def page_of(key: str, room: Room = DOOR) -> str:
    """Return the name of a room's file."""
    return f"{key}.{room.name}.html" if room.name else f"{key}.html"


def address(key: str, section: str, name: str | None = None, only: str = "") -> str:
    """Return where a thing is found from any page: `name` is its anchor, else the section's own.

    `section` is the name of the template that shows it, whichever room that is in; `only` a verdict
    that the filter of that page is set to.
    """
    query = f"?only={anchor(only)}" if only else ""
    part = _ANCHOR_OF[section] if name is None else name
    return f"{page_of(key, _ROOM_OF[section])}{query}#{part}"


@pass_context
def to(context: Context, section: str, name: str | None = None, only: str = "") -> str:
    """Return `address` as seen from the room that is being made: on the same page, no file."""
    here = context.get("here")
    whole = address(context["paper"].key, section, name, only)
    near = here and here.name == _ROOM_OF[section].name
    return whole.removeprefix(page_of(context["paper"].key, here)) if near else whole


def rooms_with(holds: Callable[[str], bool]) -> tuple[Room, ...]:
    """Return the rooms with those of their sections that hold anything, without empty rooms."""
    kept = (
        replace(room, sections=tuple(each for each in room.sections if holds(each.name)))
        for room in ROOMS
    )
    return tuple(room for room in kept if room.sections)


def pages_of_paper(key: str) -> tuple[str, ...]:
    """Return the names of all pages that a paper may have."""
    return (*(page_of(key, room) for room in ROOMS), f"{key}.md")


def check_names(keys: Iterable[str]) -> None:
    """Raise InputError where two pages would be one file, on disks that ignore case too."""
    owners = {f"{name}.{kind}": "a page of all papers" for name in _OWN for kind in ("html", "md")}
    for key in dict.fromkeys(keys):
        for page in pages_of_paper(key):
            owner = owners.setdefault(page.casefold(), key)
            if owner != key:
                message = f"{key} and {owner} would both be written to {page}: give it another key"
                raise InputError(message)


def check_apart(files: Iterable[str], more: Iterable[str], key: str) -> None:
    """Raise InputError where files of a paper would replace those of another, whatever the case."""
    taken = {name.casefold() for name in files}
    for name in more:
        if name.casefold() in taken:
            message = f"{key} and another paper would both be written to {name}: rename one of them"
            raise InputError(message)


def neighbours(rooms: Iterable[Room]) -> Iterator[tuple[Room | None, Room, Room | None]]:
    """Yield each room between the one before and the one after it."""
    row: list[Room | None] = [None, *rooms, None]
    for before, own, after in zip(row, row[1:], row[2:], strict=False):
        if own:
            yield before, own, after
