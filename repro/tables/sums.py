"""Sums, differences and percentages recomputed from the numbers that they are made of."""

import itertools
from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from operator import add, sub

from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.derived import Derivation, derived_rows
from repro.tables.published import Printed
from repro.tables.relations import Less, Mean, PercentLower, Sum, TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import DOUBLES, SINGLES, Span, exact, shown, span, unit


def sum_rows(paper: str, relation: Sum) -> Iterator[AuditRow]:
    """Yield a row where the addends cannot make the total."""
    return derived_rows(
        paper,
        Derivation(
            check="sum",
            result=relation.total,
            parts=relation.addends,
            formula=lambda parts: reduce(add, parts),
            written=" + ".join(["{}"] * len(relation.addends)),
            exact=relation.exact,
            whole=True,
            alike=True,
        ),
    )


def difference_rows(paper: str, relation: Less) -> Iterator[AuditRow]:
    """Yield a row where the difference is not the one printed."""
    return derived_rows(
        paper,
        Derivation(
            check="difference",
            result=relation.printed,
            parts=(relation.before, relation.after),
            formula=lambda parts: reduce(sub, parts),
            written="{} − {}",
            exact=relation.exact,
            whole=True,
            alike=True,
        ),
    )


def mean_rows(paper: str, relation: Mean) -> Iterator[AuditRow]:
    """Yield a row where the numbers cannot have the printed mean."""
    count = len(relation.numbers)
    each = Span(Fraction(1, count), Fraction(1, count))
    return derived_rows(
        paper,
        Derivation(
            check="mean",
            result=relation.mean,
            parts=relation.numbers,
            formula=lambda parts: reduce(add, parts) * each,
            written=f"({' + '.join(['{}'] * count)})/{count}",
            exact=relation.exact,
            alike=True,
        ),
    )


def percentage_rows(paper: str, relation: PercentLower) -> Iterator[AuditRow]:
    """Yield a row where the reduction is not the one printed, with the pairs that would fit."""
    before, after = relation.before, relation.after
    if span(before.printed).low <= 0:  # a share of nothing is no percentage
        return

    def agrees(share: Fraction) -> bool:
        found = _reduction(before.printed, after.printed, share)
        return found.meets(span(relation.printed.printed, share=share))

    if agrees(DOUBLES):
        return
    yield audit_row(
        paper,
        (before, after, relation.printed),
        check="percentage",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{relation.printed.where} prints {relation.printed.printed.text} % less; from "
            f"{before.printed.text} ({before.where}) to {after.printed.text} ({after.where}) it "
            f"is {_arithmetic(before.printed, after.printed)}. {_other_pairs(relation)}"
        ),
        condition=IN_DOUBLES if agrees(SINGLES) else None,
    )


def _reduction(before: Printed, after: Printed, share: Fraction) -> Span:
    """Return every reduction in percent that two positive printed numbers allow."""
    old, new = span(before, share=share), span(after, share=share)
    return Span(100 * (1 - new.high / old.low), 100 * (1 - new.low / old.high))


def _other_pairs(relation: PercentLower) -> str:
    """Say which two numbers of the same column have the printed reduction."""
    before, after = relation.before, relation.after
    if not (
        isinstance(before, TableCell)
        and isinstance(after, TableCell)
        and (before.table.label, before.column) == (after.table.label, after.column)
    ):
        return "The two numbers do not share a column in which another pair could be sought"
    cells = [(row, before.table[row, before.column]) for row in before.table.row_names]
    fits = [
        f"{_arithmetic(old, new)} from {old_row} to {new_row}"
        for (old_row, old), (new_row, new) in itertools.permutations(cells, 2)
        if _rounds_to(_percent(old, new), relation.printed.printed)
    ]
    if not fits:
        return f"No two rows of {before.table.label} differ by as much in that column"
    return f"In the same column it would fit {' or '.join(fits)}"


def _rounds_to(value: Fraction, printed: Printed) -> bool:
    return abs(value - exact(printed.value)) <= unit(printed) / 2


def _percent(before: Printed, after: Printed) -> Fraction:
    return 100 * (1 - exact(after.value) / exact(before.value))


def _arithmetic(before: Printed, after: Printed) -> str:
    return f"({before.text} − {after.text})/{before.text} = {shown(_percent(before, after))} %"
