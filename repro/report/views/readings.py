"""What the pages say of the other readings of a paper."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from repro.judge.findings import Finding
from repro.judge.judgement import Judgement
from repro.judge.other_readings import AS_CHOSEN, Print
from repro.judge.turning import ReadingOutcome
from repro.judge.verdict import Verdict
from repro.model.identifiers import anchor
from repro.model.paper import Paper
from repro.report.words import interval, number, verdict_words
from repro.runs.readings import readings


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingRow:
    """One reading: its name and what it departs from.

    It bears on `bears` numbers and claims and turns `turns` of them; `repeats` says in how many
    repeats of the protocol it was run, of which some of its cells may have more; `open` that it is
    a value of a setting that the text leaves wholly open, `ruled_out` that the text rules it out.
    """

    name: str
    anchor: str
    says: str
    open: bool
    ruled_out: bool
    bears: int
    turns: int
    repeats: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Beside:
    """Two forms of one search side by side: what each makes of every cell that tells them apart.

    `counts` are the verdicts as re-run and under the reading; `rows` cell, printed number, and both
    intervals with their verdicts.
    """

    reading: str
    counts: tuple[Counter[str], Counter[str]]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingsView:
    """Other readings, how the numbers fare under them, and the fingerprint of each column.

    Of `judged` numbers and claims that are run or computed, readings bear on `touched`; `depends`
    turn on one, `contradicted` are so under everything that was tried, which for `untouched` of
    them is the re-run alone.
    """

    rows: tuple[ReadingRow, ...]
    judged: int
    touched: int
    depends: int
    contradicted: int
    untouched: int
    prints: tuple[tuple[str, ...], ...]
    beside: tuple[Beside, ...] = ()


def readings_view(judgement: Judgement) -> ReadingsView:
    """Return what is shown of the readings of one paper."""
    paper, findings = judgement.paper, judgement.findings
    contradicted = [f for f in findings if f.verdict is Verdict.CONTRADICTED]
    by_name: dict[str, list[ReadingOutcome]] = {}
    for finding in findings:
        for outcome in finding.readings:
            by_name.setdefault(outcome.reading, []).append(outcome)
    settings = settings_of(paper)
    turned = [
        {reading for name in f.turns_on for reading in (name, *settings.get(name, ()))}
        for f in findings
    ]
    return ReadingsView(
        rows=tuple(
            ReadingRow(
                name=name,
                anchor=anchor(paper.key, "reading", name),
                says=each.reading.says,
                ruled_out=each.reading.ruled_out,
                open=all(assumption.open for assumption in each.reading.of),
                bears=len(by_name.get(name, ())),
                turns=sum(name in names for names in turned),
                repeats=_repeats(by_name.get(name, ())),
            )
            for each in judgement.readings
            for name in [each.reading.name]
        ),
        judged=sum(f.measured is not None for f in findings),
        touched=sum(bool(f.readings) for f in findings),
        depends=sum(f.verdict is Verdict.DEPENDS for f in findings),
        contradicted=len(contradicted),
        untouched=sum(not f.readings for f in contradicted),
        prints=tuple(_print_row(each) for each in judgement.prints if each.others),
        beside=_beside(judgement),
    )


def _beside(judgement: Judgement) -> tuple[Beside, ...]:
    """Return the readings of a control that were run as often as its protocol."""
    if not judgement.paper.control:
        return ()
    full = [
        each.reading.name
        for each in judgement.readings
        if all(alternative.full_depth for alternative in each.reading.alternatives)
    ]
    return tuple(_side_by_side(name, judgement.findings) for name in full)


def _side_by_side(reading: str, findings: Sequence[Finding]) -> Beside:
    pairs = [
        (finding, outcome)
        for finding in findings
        for outcome in finding.readings
        if outcome.reading == reading and finding.table and finding.as_run
    ]
    return Beside(
        reading=reading,
        rows=tuple(
            (
                f"{finding.table}, {finding.row}, {finding.column}",
                finding.printed,
                interval(finding.measured),
                verdict_words(finding.as_run, finding.as_run_side),
                interval(outcome.measured),
                verdict_words(outcome.verdict, outcome.side),
            )
            for finding, outcome in pairs
            if finding.as_run
        ),
        counts=(
            Counter(str(finding.as_run) for finding, _ in pairs),
            Counter(str(outcome.verdict) for _, outcome in pairs),
        ),
    )


def settings_of(paper: Paper) -> Mapping[str, tuple[str, ...]]:
    """Return the names of the readings that are values of each open setting, by what it sets."""
    return {
        assumption.what: tuple(each.name for each in assumption.alternatives if each.changes)
        for assumption in paper.assumptions
        if assumption.open
    }


def ruled_out_by(paper: Paper) -> frozenset[str]:
    """Return the names of the readings that the text rules out."""
    return frozenset(reading.name for reading in readings(paper) if reading.ruled_out)


def _repeats(outcomes: Sequence[ReadingOutcome]) -> str:
    """Return how deep a reading was run; what needs no run has no repeats."""
    depths = sorted({outcome.repeats for outcome in outcomes} - {0})
    if not depths:
        return "–"
    return f"{depths[0]}" if len(depths) == 1 else f"{depths[0]} to {depths[-1]}"


def _print_row(each: Print) -> tuple[str, ...]:
    name, distance = each.others[0]
    nearest = AS_CHOSEN if each.nearest == AS_CHOSEN else name
    return (
        each.table,
        each.column,
        f"{each.numbers}",
        f"{each.lower} of {each.numbers}",
        number(each.chosen, 3),
        nearest,
        number(min(distance, each.chosen), 3),
        number(each.others[-1][1], 3),
    )
