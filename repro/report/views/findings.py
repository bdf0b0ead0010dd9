"""What the templates show of one paper, arranged from its findings."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from repro.audit import AuditRow
from repro.judge.findings import IN_WORDS, Finding
from repro.model.identifiers import anchor, identifiers
from repro.model.measures.measure import TABLES
from repro.report.words import difference, digits_for, interval, number, share, verdict_words
from repro.tables.published import UNITS, Printed, PublishedTable

Place = tuple[str | None, str | None, str | None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """One finding as the pages show it.

    It stands on `line` of the CSV file that is named by the paper's key and `group`.
    """

    finding: Finding
    anchor: str
    printed: str
    value: str
    difference: str
    verdict: str
    sign: str
    word: str
    kind: str
    measured: str
    accepted: str
    quantile: str
    group: str
    line: int
    order: float | None
    readings: tuple["ShownReading", ...] = ()
    marks: tuple[AuditRow, ...] = ()

    @property
    def impossible(self) -> bool:
        """Whether no runs whatever give the printed number."""
        return any(row.is_proof for row in self.marks)


@dataclass(frozen=True, slots=True, kw_only=True)
class ShownReading:
    """What becomes of a contradicted number under another reading, as the pages show it."""

    reading: str
    measured: str
    verdict: str
    kind: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Tally:
    """How many findings of one table, or of the claims (no label), have each verdict."""

    label: str
    anchor: str
    counts: Mapping[str, int]
    total: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """A printed table with the reproduced one beside it; an input has texts and no findings."""

    label: str
    where: str
    anchor: str
    headings: tuple[str, ...]
    columns: tuple[str, ...]
    rows: tuple[tuple[tuple[str, ...], tuple[Shown | str, ...]], ...]
    judged: bool


def everything(findings: Sequence[Finding], rows: Iterable[AuditRow]) -> list[Shown]:
    """Return every finding in the words and digits of the pages, with the audit rows on it."""
    marks = marks_by_cell(rows)
    names = identifiers((f.table or "claim", f.row, f.column, f.claim) for f in findings)
    lines: Counter[str] = Counter()
    found = []
    for name, finding in zip(names, findings, strict=True):
        group = anchor(finding.table or "claims")
        lines[group] += 1
        cell = (finding.table, finding.row, finding.column)
        own = tuple(marks.get(cell, ())) if finding.table else ()
        found.append(_shown(finding, name, group, lines[group] + 1, own))
    return found


def tallies(found: Iterable[Shown]) -> list[Tally]:
    """Return the verdict counts of each results table, and of the claims, in printed order."""
    counts: dict[tuple[str, str], Counter[str]] = {}
    for one in found:
        place = (one.finding.table or "", one.group)
        counts.setdefault(place, Counter())[one.finding.verdict] += 1
    return [
        Tally(label=label, anchor=group, counts=own, total=own.total())
        for (label, group), own in counts.items()
    ]


def _shown(
    finding: Finding, name: str, group: str, line: int, marks: tuple[AuditRow, ...]
) -> Shown:
    worded = finding.printed == IN_WORDS
    printed = None if worded else Printed(finding.printed, finding.unit)
    digits = digits_for(printed) if printed else 4
    verdict = verdict_words(finding.verdict, finding.side)
    return Shown(
        finding=finding,
        anchor=name,
        printed=finding.printed if finding.table or not printed else _with_unit(printed),
        value=number(finding.value, digits),
        difference=difference(printed, finding.value) if printed else "",
        verdict=verdict,
        sign=verdict.partition(" ")[0],
        word=verdict.partition(" ")[2],
        kind=anchor(finding.verdict),
        measured=interval(finding.measured, digits),
        accepted=interval(finding.accepted, digits),
        quantile=share(finding.quantile, TABLES),
        group=group,
        line=line,
        order=printed.value if printed else None,
        readings=tuple(
            ShownReading(
                reading=other.reading,
                measured=interval(other.measured, digits),
                verdict=verdict_words(other.verdict, other.side),
                kind=anchor(other.verdict),
            )
            for other in finding.readings
        ),
        marks=marks,
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
        judged=bool(found),
    )
