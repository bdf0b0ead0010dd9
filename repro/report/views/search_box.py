"""What the search box of the index looks through: everything that has an address of its own."""

from collections.abc import Iterable, Iterator, Mapping

from repro.model.identifiers import anchor, identifiers
from repro.report.glossary import Glossary
from repro.report.results import Json, impossible_rows
from repro.report.rooms import ROOMS, address, page_of
from repro.report.words import interval, number, verdict_words

Row = list[str | int]
"""Text, what is said of it, the number of its mark, and its anchor where the text does not tell it.

What is not there is left out from the end.
"""
PRINTED = "printed protocol"  # how an algorithm of the paper stands among the standings


def search_index(papers: Iterable[Json], glossary: Glossary) -> Json:
    """Return groups of rows, which share kind, paper, page and the place `of` them, and the marks.

    A row's anchor is that of its place and text, unless it has one of its own.
    """
    marks: dict[str, int] = {}
    groups = [group for paper in papers for group in _groups(paper, glossary.rooms, marks)]
    words: list[Row] = [[term.name, term.says] for term in glossary.terms]
    groups.append(_group("word", "the words", "glossary.html", "", words))
    return {"marks": list(marks), "groups": [group for group in groups if group["rows"]]}


def _group(kind: str, paper: str, page: str, of: str, rows: Iterable[Row]) -> Json:
    return {"kind": kind, "paper": paper, "page": page, "of": of, "rows": list(rows)}


def _groups(paper: Json, called: Mapping[str, str], marks: dict[str, int]) -> Iterator[Json]:
    key = paper["key"]
    door: list[Row] = [[paper["title"], paper["summary"], 0, ""]]
    marks.setdefault("", 0)
    yield _group("paper", paper["cited"], page_of(key), "", door)
    yield from _parts(paper, called)
    for kind, section, rows in (
        ("algorithm", "baselines", _beside(paper)),
        ("algorithm", "comparison", _tested(paper)),
        ("optimum", "optimum", _optima(paper)),
        ("claim", "claims", _numbers(paper, None, marks)),
        ("audit", "audit", _audit(paper, marks)),
        ("reading", "readings", _readings(paper)),
        ("assumption", "assumptions", _open_points(paper)),
    ):
        place = address(key, section)
        page, _, own = place.partition("#")
        shown = ([*row[:3], *([0] * (3 - len(row[:3]))), *(row[3:] or [own])] for row in rows)
        yield _group(kind, paper["cited"], page, "", shown)
    page = address(key, "formulas").partition("#")[0]
    equations: list[Row] = [
        [f"{each['label']}: {each['says']}", each["where"], 0, anchor("equation", each["label"])]
        for each in paper.get("equations", ())
    ]
    yield _group("equation", paper["cited"], page, "", equations)
    page = address(key, "tables").partition("#")[0]
    for table in dict.fromkeys(one["table"] for one in paper["findings"] if one["table"]):
        yield _group("number", paper["cited"], page, table, _numbers(paper, table, marks))


def _parts(paper: Json, called: Mapping[str, str]) -> Iterator[Json]:
    """Yield the sections of the rooms that the paper has, with what else they are called."""
    filled = paper.get("rooms", ())
    for room in ROOMS:
        if room.name not in filled:
            continue
        rows: list[Row] = [
            [each.title, called.get(each.name, ""), 0, each.anchor] for each in room.sections
        ]
        yield _group("part", paper["cited"], page_of(paper["key"], room), "", rows)


def _numbers(paper: Json, table: str | None, marks: dict[str, int]) -> Iterator[Row]:
    """Yield the numbers of a table, or the claims of the text, as printed and as re-run."""
    names = identifiers(
        (one["table"] or "claim", one["row"], one["column"], one["claim"])
        for one in paper["findings"]
    )
    for name, one in zip(names, paper["findings"], strict=True):
        if one["table"] != table:
            continue
        text = one["claim"] or f"{one['row']}, {one['column']}"
        says = f"{one['printed']} {one['unit']}".rstrip()
        says += f", re-run {number(one['value'])}" if one["value"] is not None else ""
        mark = marks.setdefault(verdict_words(one["verdict"], one["side"]), len(marks))
        told = anchor(table, text) == name
        yield [text, says, mark] if told else [text, says, mark, name]


def _beside(paper: Json) -> Iterator[Row]:
    """Yield each algorithm that stands beside baselines, itself one or one of the paper's."""
    for name in dict.fromkeys(row["algorithm"] for row in paper["standings"]):
        own = [row for row in paper["standings"] if row["algorithm"] == name]
        problems = list(dict.fromkeys(row["problem"] for row in own if row["problem"]))
        role = "of the paper" if PRINTED in {row["kind"] for row in own} else "baseline"
        yield [name, f"{role}, on {', '.join(problems)}"]


def _tested(paper: Json) -> Iterator[Row]:
    """Yield each algorithm of the paper that is tested against others."""
    both = (row[name] for row in paper["tests"] for name in ("algorithm", "against"))
    for name in dict.fromkeys(filter(None, both)):
        yield [name, "ranks and tests against others"]


def _optima(paper: Json) -> Iterator[Row]:
    for one in paper["certificates"]:
        if one["minimum"] is not None:
            yield [f"certified optimum of {one['problem']}", f"{number(one['minimum'])} s, proved"]
        elif one["lower_bound"] is not None and one["attained"] is not None:
            between = interval((one["lower_bound"], one["attained"]))
            yield [f"bounds of {one['problem']}", f"{between} s"]
        else:
            yield [f"no minimum of {one['problem']}", ""]


def _audit(paper: Json, marks: dict[str, int]) -> Iterator[Row]:
    impossible = impossible_rows(paper)
    for position, row in enumerate(paper["audit"], start=1):
        cell = f", {row['row']}, {row['column']}" if row["row"] else ""
        mark = f"{'⚑' if row in impossible else 'audit:'} {row['grade']}"
        text = f"{row['table']}{cell}: {row['check']}"
        yield [text, "", marks.setdefault(mark, len(marks)), f"audit-{position}"]


def _readings(paper: Json) -> Iterator[Row]:
    for one in paper["assumptions"]:
        for other in one["alternatives"]:
            if other["reading"]:
                yield [other["reading"], other["says"]]


def _open_points(paper: Json) -> Iterator[Row]:
    yield from ([one["what"], one["chosen"]] for one in paper["assumptions"])
    yield from ([f"misprint: {one['printed']}", one["where"]] for one in paper["errata"])
    yield from ([f"not reproducible: {one['what']}", one["because"]] for one in paper["gaps"])
