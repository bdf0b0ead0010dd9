"""Printed inputs against each other: spacing, ranges, series that agree."""

from collections.abc import Iterator
from itertools import pairwise

from repro.tables.relations import EqualSpacing, InRange, SameNumbers
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import SINGLES, Span, exact, shown, span


def spacing_rows(paper: str, relation: EqualSpacing) -> Iterator[AuditRow]:
    """Yield a row where no common step fits all numbers within their rounding."""
    spans = [span(number.printed, share=SINGLES) for number in relation.numbers]
    steps = [after - before for before, after in pairwise(spans)]
    if not steps:
        return
    common = Span(max(step.low for step in steps), min(step.high for step in steps))
    if common.low <= common.high:
        return
    values = [exact(number.printed.value) for number in relation.numbers]
    yield audit_row(
        paper,
        relation.numbers,
        check="spacing",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{', '.join(number.printed.text for number in relation.numbers)} should be equally "
            f"spaced; the steps are {', '.join(shown(b - a) for a, b in pairwise(values))}"
        ),
    )


def range_rows(paper: str, relation: InRange) -> Iterator[AuditRow]:
    """Yield a row where a number lies outside its printed range."""
    here, low, high = (
        span(number.printed, share=SINGLES)
        for number in (relation.value, relation.low, relation.high)
    )
    if here.high >= low.low and here.low <= high.high:
        return
    yield audit_row(
        paper,
        (relation.value,),
        check="range",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{relation.value.printed.text} ({relation.value.where}) lies outside "
            f"{relation.low.printed.text} to {relation.high.printed.text} "
            f"({relation.low.where}; {relation.high.where})"
        ),
    )


def same_rows(paper: str, relation: SameNumbers) -> Iterator[AuditRow]:
    """Yield a note where two series that are independent by meaning agree number by number."""
    pairs = list(zip(relation.first, relation.second, strict=True))
    if all(one.printed.value == other.printed.value for one, other in pairs):
        texts = ", ".join(number.printed.text for number in relation.first)
        yield audit_row(
            paper,
            (*relation.first, *relation.second),
            check="same-numbers",
            grade=Grade.NOTED,
            explanation=(
                f"{texts} stand both at {relation.first[0].where} and the cells that follow and "
                f"at {relation.second[0].where} and those that follow: {relation.meaning}"
            ),
        )
