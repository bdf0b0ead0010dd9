"""What the index's search box looks through: papers, tables, cells, claims and audit rows."""

from collections.abc import Iterable, Iterator

from repro.model.identifiers import anchor, identifiers
from repro.report.results import Json, impossible_rows
from repro.report.rooms import address, page_of
from repro.report.words import verdict_words

Row = tuple[str, str, str, str]


def search_rows(papers: Iterable[Json]) -> list[Row]:
    """Return (paper, address, text, verdict) of everything that has an address of its own."""
    return [row for paper in papers for row in _rows(paper)]


def _rows(paper: Json) -> Iterator[Row]:
    key = paper["key"]
    yield key, page_of(key), f"{paper['title']}. {paper['summary']}", "paper"
    findings = paper["findings"]
    for table in dict.fromkeys(one["table"] for one in findings if one["table"]):
        yield key, address(key, "tables", anchor(table)), table, "table"
    names = identifiers(
        (one["table"] or "claim", one["row"], one["column"], one["claim"]) for one in findings
    )
    for name, one in zip(names, findings, strict=True):
        place = one["claim"] or f"{one['table']}, {one['row']}, {one['column']}"
        text = f"{place}: {one['printed']} {one['unit']}".strip()
        where = address(key, "claims" if one["claim"] else "tables", name)
        yield key, where, text, verdict_words(one["verdict"], one["side"])
    impossible = impossible_rows(paper)
    for number, row in enumerate(paper["audit"], start=1):
        cell = f", {row['row']}, {row['column']}" if row["row"] else ""
        text = f"{row['table']}{cell}: {row['check']}"
        mark = "⚑" if row in impossible else "audit:"
        yield key, address(key, "audit", f"audit-{number}"), text, f"{mark} {row['grade']}"
