"""What the templates show of one paper, arranged from its findings."""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, repeat

from repro.audit import AuditRow
from repro.judge.counting import by_group
from repro.judge.findings import IN_WORDS, Finding
from repro.judge.verdict import HELD, Verdict
from repro.model.identifiers import anchor, identifiers
from repro.model.measures.measure import TABLES
from repro.report.views.line_plot import drawn_number
from repro.report.views.turns import ShownReading, Turn, shown_reading, turns_of
from repro.report.words import (
    could_be_off,
    counted,
    difference,
    digits_for,
    interval,
    number,
    seconds_raised,
    share,
    verdict_words,
)
from repro.tables.published import UNITS, Printed, PublishedTable

Place = tuple[str | None, str | None, str | None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """One finding as the pages show it.

    It stands on `line` of the CSV file that is named by the paper's key and `group`. `unseen` says
    how far a consistent number could be off, `size` how large what is said in words is by the print
    and by the runs, `own` what the re-run alone says of one that depends,
    `counted` with what it counts, where that is not by
    itself; `turns` are the readings on which the verdict turns, among all `readings`; `least` is
    the proved least, and `drawn` what the line plot shows.
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
    own: str = ""
    own_kind: str = ""
    least: str = ""
    drawn: str = ""
    unseen: str = ""
    size: str = ""
    counted: str = ""
    readings: tuple[ShownReading, ...] = ()
    turns: tuple[Turn, ...] = ()
    marks: tuple[AuditRow, ...] = ()

    @property
    def impossible(self) -> bool:
        """Whether no runs whatever give the printed number."""
        return any(row.is_proof for row in self.marks)

    @property
    def brief(self) -> str:
        """What a verdict is worth, in the few words for which a table has room."""
        if self.finding.unseen is not None and self.finding.printed == IN_WORDS:
            return "not in every table"
        if self.finding.unseen == "unbounded":
            return "unbounded unseen"
        if self.finding.unseen is not None:
            return f"×{number(self.finding.unseen, 3)} unseen"
        if len(self.turns) > 1:
            return f"on {len(self.turns)} readings or settings"
        return f"on {self.turns[0].name}" if self.turns else ""

    @property
    def turning(self) -> int:
        """Under how many of the readings that were tried the number holds where it did not."""
        held = self.finding.as_run in HELD
        return sum(one.held != held for turn in self.turns for one in turn.outcomes)


@dataclass(frozen=True, slots=True, kw_only=True)
class Tally:
    """How many results of one table, or of the claims (no label), have each verdict."""

    label: str
    anchor: str
    counts: Mapping[str, int]
    total: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Bare:
    """A printed number that is not judged, with the rows of the audit that concern it."""

    printed: str
    marks: tuple[AuditRow, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """A printed table with the reproduced one beside it; one that is not judged has no findings."""

    label: str
    where: str
    anchor: str
    headings: tuple[str, ...]
    columns: tuple[str, ...]
    rows: tuple[tuple[tuple[str, ...], tuple[Shown | Bare | str, ...]], ...]
    judged: bool


def everything(
    findings: Sequence[Finding],
    rows: Iterable[AuditRow],
    settings: Mapping[str, Sequence[str]] | None = None,
    ruled_out: Collection[str] = (),
    least: Sequence[float | None] = (),
) -> list[Shown]:
    """Return every finding in the words and digits of the pages, with the audit rows on it.

    `settings` names the readings that are values of each open setting, `ruled_out` those that the
    text rules out; `least` are proved least values of what the first findings measure.
    """
    marks = marks_by_cell(rows)
    names = identifiers((f.table or "claim", f.row, f.column, f.claim) for f in findings)
    together = Counter(finding.group for finding in findings)
    lines: Counter[str] = Counter()
    found = []
    proved = chain(least, repeat(None))
    for name, finding, low in zip(names, findings, proved, strict=False):
        group = anchor(finding.table or "claims")
        lines[group] += 1
        cell = (finding.table, finding.row, finding.column)
        own = tuple(marks.get(cell, ())) if finding.table else ()
        shown = _shown(finding, name, group, lines[group] + 1, own)
        digits = digits_of(finding)
        readings = tuple(shown_reading(each, digits, ruled_out) for each in finding.readings)
        found.append(
            replace(
                shown,
                readings=readings,
                least=number(low, digits) if low is not None else "",
                drawn=drawn_number(finding, low),
                counted=counted(finding.group, together[finding.group] - 1),
                turns=turns_of(finding, readings, settings or {}),
            )
        )
    return found


def tallies(found: Iterable[Shown]) -> list[Tally]:
    """Return the counts of results of each table, and of the claims, in printed order.

    What shows in several tables counts in each of them once, by the verdict that it has in all.
    """
    shown = list(found)
    verdicts = by_group((one.finding.group, one.finding.verdict) for one in shown)
    groups: dict[tuple[str, str], dict[str, Verdict]] = {}
    for one in shown:
        own = groups.setdefault((one.finding.table or "", one.group), {})
        if one.finding.group is not None:
            own[one.finding.group] = verdicts[one.finding.group]
    return [
        Tally(label=label, anchor=group, counts=Counter(own.values()), total=len(own))
        for (label, group), own in groups.items()
    ]


def digits_of(finding: Finding) -> int:
    """Return how many digits of what is measured are shown."""
    worded = finding.printed == IN_WORDS
    return 4 if worded else digits_for(Printed(finding.printed, finding.unit))


def _shown(
    finding: Finding, name: str, group: str, line: int, marks: tuple[AuditRow, ...]
) -> Shown:
    worded = finding.printed == IN_WORDS
    printed = None if worded else Printed(finding.printed, finding.unit)
    digits = digits_of(finding)
    verdict = verdict_words(finding.verdict, finding.side)
    return Shown(
        finding=finding,
        anchor=name,
        printed=finding.printed
        if finding.table or not printed
        else with_unit(printed.text, printed.unit),
        value=_own_unit(finding, number(finding.value, digits)),
        difference=difference(printed, finding.value) if printed else "",
        verdict=verdict,
        sign=verdict.partition(" ")[0],
        word=verdict.partition(" ")[2],
        kind=anchor(finding.verdict),
        measured=_own_unit(finding, interval(finding.measured, digits)),
        accepted=_own_unit(finding, interval(finding.accepted, digits)),
        quantile=share(finding.quantile, TABLES),
        group=group,
        line=line,
        order=printed.value if printed else None,
        own=_own(finding),
        own_kind=anchor(finding.as_run),
        unseen="" if finding.unseen is None else could_be_off(finding.unseen, in_words=worded),
        marks=marks,
    )


def _own_unit(finding: Finding, text: str) -> str:
    """Return a number with its unit; a table's stands at its heading."""
    return text if finding.table or text == "–" else with_unit(text, finding.unit)


def _own(finding: Finding) -> str:
    """Return what the re-run alone says, where it is not what is said."""
    if finding.as_run is None or finding.as_run is finding.verdict:
        return ""
    return verdict_words(finding.as_run, finding.as_run_side)


def with_unit(text: str, unit: str) -> str:
    """Return a number or an interval with its unit, of which a rank's stands before it."""
    return f"rank {text}" if unit == "rank" else f"{text} {seconds_raised(unit)}".strip()


def marks_by_cell(rows: Iterable[AuditRow]) -> dict[Place, list[AuditRow]]:
    """Return the audit rows that concern each cell."""
    marks: dict[Place, list[AuditRow]] = {}
    for row in rows:
        cells = [(row.row, row.column)] if row.row else [(c["row"], c["column"]) for c in row.cells]
        for cell in cells:
            marks.setdefault((row.table, *cell), []).append(row)
    return marks


def bare_table(table: PublishedTable, rows: Iterable[AuditRow]) -> Table:
    """Return a printed table that no run stands behind, with the audit rows on its cells."""
    marked = {
        place[1:]: own for place, own in marks_by_cell(rows).items() if place[0] == table.label
    }
    marks: dict[Place, Bare] = {
        (table.label, *place): Bare(printed=table[place].text, marks=tuple(marked[place]))
        for place in table.places()
        if place in marked
    }
    return replace(table_view(table, marks), judged=False)


def table_view(table: PublishedTable, found: Mapping[Place, Shown] | Mapping[Place, Bare]) -> Table:
    """Return a printed table; cells that no finding concerns show their text."""
    rows = []
    units = table.row_units or ("",) * len(table.rows)
    for name, headings, unit, cells in zip(
        table.row_names, table.rows, units, table.cells, strict=True
    ):
        shown_cells = tuple(
            found.get((table.label, name, column.name))
            or (cell if isinstance(cell, str) else cell.text)
            for column, cell in zip(table.columns, cells, strict=True)
        )
        *first, last = headings
        shown_headings = (
            (*first, f"{last} [{seconds_raised(unit)}]") if unit in UNITS and unit else headings
        )
        rows.append((shown_headings, shown_cells))
    return Table(
        label=table.label,
        where=table.where,
        anchor=anchor(table.label),
        headings=table.headings,
        columns=tuple(
            f"{column.name} [{seconds_raised(column.unit)}]"
            if column.unit in UNITS and column.unit
            else column.name
            for column in table.columns
        ),
        rows=tuple(rows),
        judged=bool(found),
    )
