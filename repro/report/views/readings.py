"""What the pages say of the other readings of a paper."""

from collections import Counter
from dataclasses import dataclass

from repro.judge.judgement import Judgement
from repro.judge.other_readings import AS_CHOSEN, Print
from repro.judge.verdict import Verdict
from repro.model.identifiers import anchor
from repro.report.words import number


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingRow:
    """One reading: its name, what it departs from, and how many contradicted numbers it reaches."""

    name: str
    anchor: str
    says: str
    tried: int
    reached: int


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingsView:
    """Other readings, how the contradicted numbers fare, and the fingerprint of each column.

    `within_reach` numbers are not contradicted under some reading, `out_of_reach` ones are under
    every reading that bears on them; no reading bears on `untouched` ones.
    """

    rows: tuple[ReadingRow, ...]
    contradicted: int
    within_reach: int
    out_of_reach: int
    untouched: int
    prints: tuple[tuple[str, ...], ...]


def readings_view(judgement: Judgement) -> ReadingsView:
    """Return what is shown of the readings of one paper."""
    paper = judgement.paper
    contradicted = [f for f in judgement.findings if f.verdict is Verdict.CONTRADICTED]
    tried = Counter(outcome.reading for f in contradicted for outcome in f.readings)
    hits = Counter(name for f in judgement.findings for name in f.turns_on)
    within = sum(f.verdict is Verdict.DEPENDS for f in judgement.findings)
    untouched = sum(not f.readings for f in contradicted)
    return ReadingsView(
        rows=tuple(
            ReadingRow(
                name=each.reading.name,
                anchor=anchor(paper.key, "reading", each.reading.name),
                says=each.reading.says,
                tried=tried[each.reading.name],
                reached=hits[each.reading.name],
            )
            for each in judgement.readings
        ),
        contradicted=len(contradicted),
        within_reach=within,
        out_of_reach=len(contradicted) - within - untouched,
        untouched=untouched,
        prints=tuple(_print_row(each) for each in judgement.prints if each.others),
    )


def _print_row(each: Print) -> tuple[str, ...]:
    name, distance = each.others[0]
    nearest = AS_CHOSEN if each.nearest == AS_CHOSEN else name
    return (
        each.table,
        each.column,
        f"{each.numbers}",
        number(each.chosen, 3),
        nearest,
        number(min(distance, each.chosen), 3),
        number(each.others[-1][1], 3),
    )
