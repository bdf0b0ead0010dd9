"""What the templates show of one paper, arranged from its findings."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from repro.audit import AuditRow
from repro.findings import IN_WORDS, Finding
from repro.published import UNITS, Printed, PublishedTable
from repro.report.words import (
    anchor,
    difference,
    digits_for,
    interval,
    number,
    verdict_words,
)

Place = tuple[str | None, str | None, str | None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """One finding as the pages show it."""

    finding: Finding
    anchor: str
    printed: str
    value: str
    difference: str
    verdict: str
    kind: str
    measured: str
    accepted: str
    quantile: str
    marks: tuple[AuditRow, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """A printed table with the reproduced one beside it; an input has texts and no findings."""

    label: str
    where: str
    anchor: str
    headings: tuple[str, ...]
    columns: tuple[str, ...]
    rows: tuple[tuple[tuple[str, ...], tuple[Shown | str, ...]], ...]


def shown(finding: Finding, marks: Mapping[Place, list[AuditRow]]) -> Shown:
    """Return a finding in the words and digits of the pages."""
    place = (finding.table, finding.row, finding.column)
    worded = finding.printed == IN_WORDS
    printed = None if worded else Printed(finding.printed, finding.unit)
    digits = digits_for(printed) if printed else 4
    return Shown(
        finding=finding,
        anchor=anchor(*place, finding.claim),
        printed=finding.printed if finding.table or not printed else _with_unit(printed),
        value=number(finding.value, digits),
        difference=difference(printed, finding.value) if printed else "",
        verdict=verdict_words(finding.verdict, finding.side),
        kind=anchor(finding.verdict),
        measured=interval(finding.measured, digits),
        accepted=interval(finding.accepted, digits),
        quantile="–" if finding.quantile is None else f"{finding.quantile:.3f}",
        marks=tuple(marks.get(place, ())) if finding.table else (),
    )


def _with_unit(printed: Printed) -> str:
    if printed.unit == "rank":
        return f"rank {printed.text}"
    return f"{printed.text} {printed.unit}".strip()


def marks_by_cell(rows: Iterable[AuditRow]) -> dict[Place, list[AuditRow]]:
    """Return the audit rows that concern each cell."""
    marks: dict[Place, list[AuditRow]] = {}
    for row in rows:
        cells = [(row.row, row.column)] if row.row else [(c["row"], c["column"]) for c in row.cells]
        for cell in cells:
            marks.setdefault((row.table, *cell), []).append(row)
    return marks


def table_view(table: PublishedTable, found: Mapping[Place, Shown]) -> Table:
    """Return a printed table; cells that no finding concerns show their text."""
    rows = []
    for name, headings, cells in zip(table.row_names, table.rows, table.cells, strict=True):
        shown_cells = tuple(
            found.get((table.label, name, column.name))
            or (cell if isinstance(cell, str) else cell.text)
            for column, cell in zip(table.columns, cells, strict=True)
        )
        rows.append((headings, shown_cells))
    return Table(
        label=table.label,
        where=table.where,
        anchor=anchor(table.label),
        headings=table.headings,
        columns=tuple(
            f"{column.name} [{column.unit}]"
            if column.unit in UNITS and column.unit
            else column.name
            for column in table.columns
        ),
        rows=tuple(rows),
    )
