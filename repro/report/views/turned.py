"""What turns what: readings of a paper against its tables, with every number that turns."""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from repro.judge.turning import ReadingOutcome
from repro.judge.verdict import HELD, Verdict
from repro.report.views.findings import Shown
from repro.report.views.readings import ReadingRow
from repro.report.words import verdict_words

CLAIMS = "claims"
KINDS = ("held", "contradicted", "passed")
"""A reading makes a number hold, or contradicts it, or is a value of a setting that leads past."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Turned:
    """A number that a reading turns: its words, where it stands, and both verdicts."""

    label: str
    section: str
    anchor: str
    kind: str
    before: str
    after: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Crossing:
    """What a reading does to one table: on how many numbers it bears, and those that it turns."""

    bears: int
    turned: tuple[Turned, ...]

    @property
    def counts(self) -> tuple[tuple[str, int], ...]:
        """How many turn which way."""
        found = Counter(each.kind for each in self.turned)
        return tuple((kind, found[kind]) for kind in KINDS if found[kind])


@dataclass(frozen=True, slots=True, kw_only=True)
class Matrix:
    """Readings against tables, those that turn the most first.

    `columns` are labels of tables, "claims" for the text.
    `depending` are the numbers that turn on any reading or setting, by column.
    """

    columns: tuple[str, ...]
    rows: tuple[tuple[ReadingRow, tuple[Crossing, ...]], ...]
    depending: tuple[tuple[str, tuple[Shown, ...]], ...]


def turned_by(
    rows: Iterable[ReadingRow], found: Sequence[Shown], settings: Mapping[str, Collection[str]]
) -> Matrix:
    """Return what each reading turns; `settings` names the readings that are values of each."""
    crossings: dict[tuple[str, str], list[tuple[Shown, ReadingOutcome]]] = {}
    depending: dict[str, list[Shown]] = {}
    for shown in found:
        column = shown.finding.table or CLAIMS
        for outcome in shown.finding.readings:
            crossings.setdefault((outcome.reading, column), []).append((shown, outcome))
        if shown.finding.verdict is Verdict.DEPENDS:
            depending.setdefault(column, []).append(shown)
    first = sorted(rows, key=lambda row: -row.turns)
    columns = tuple(dict.fromkeys(shown.finding.table or CLAIMS for shown in found))
    columns = tuple(c for c in columns if any(key[1] == c for key in crossings))
    return Matrix(
        columns=columns,
        rows=tuple(
            (row, tuple(_crossing(crossings.get((row.name, c), ()), settings) for c in columns))
            for row in first
        ),
        depending=tuple((column, tuple(own)) for column, own in depending.items()),
    )


def _crossing(
    pairs: Sequence[tuple[Shown, ReadingOutcome]], settings: Mapping[str, Collection[str]]
) -> Crossing:
    return Crossing(
        bears=len(pairs),
        turned=tuple(
            _turned(shown, outcome)
            for shown, outcome in pairs
            if any(
                outcome.reading in (name, *settings.get(name, ()))
                for name in shown.finding.turns_on
            )
        ),
    )


def _turned(shown: Shown, outcome: ReadingOutcome) -> Turned:
    finding = shown.finding
    if outcome.verdict in HELD:
        kind = "held"
    elif outcome.verdict is Verdict.CONTRADICTED and finding.as_run is not Verdict.CONTRADICTED:
        kind = "contradicted"
    else:
        kind = "passed"
    as_run = finding.as_run or finding.verdict
    return Turned(
        label=finding.claim or f"{finding.row}, {finding.column}",
        section="tables" if finding.table else CLAIMS,
        anchor=shown.anchor,
        kind=kind,
        before=verdict_words(as_run, finding.as_run_side),
        after=verdict_words(outcome.verdict, outcome.side),
    )
