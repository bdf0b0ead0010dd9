"""Sums, differences and percentages recomputed from the numbers that they are made of."""

import itertools
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from operator import add, sub

from repro.tables.digit_slips import slips
from repro.tables.published import Printed
from repro.tables.relations import Less, Number, PercentLower, Sum, TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, exact, shown, span, unit

Formula = Callable[[Sequence[Span]], Span]
LISTED = 4  # explanations by one slip that are spelt out


def sum_rows(paper: str, relation: Sum) -> Iterator[AuditRow]:
    """Yield a row where the addends cannot make the total."""
    return _checked(
        paper,
        check="sum",
        result=relation.total,
        parts=relation.addends,
        formula=lambda parts: reduce(add, parts),
        sign=" + ",
    )


def difference_rows(paper: str, relation: Less) -> Iterator[AuditRow]:
    """Yield a row where the difference is not the one printed."""
    return _checked(
        paper,
        check="difference",
        result=relation.printed,
        parts=(relation.before, relation.after),
        formula=lambda parts: reduce(sub, parts),
        sign=" − ",
    )


def percentage_rows(paper: str, relation: PercentLower) -> Iterator[AuditRow]:
    """Yield a row where the reduction is not the one printed, with the pairs that would fit."""
    before, after = relation.before, relation.after
    if span(before.printed).low <= 0:  # a share of nothing is no percentage
        return
    if _reduction(before.printed, after.printed).meets(span(relation.printed.printed)):
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
    )


def _checked(
    paper: str,
    *,
    check: str,
    result: Number,
    parts: Sequence[Number],
    formula: Formula,
    sign: str,
) -> Iterator[AuditRow]:
    """Yield a row where no numbers behind the printed parts give one behind the printed result."""
    possible, printed = formula([span(part.printed) for part in parts]), span(result.printed)
    if possible.meets(printed):
        return
    value = formula([_point(part.printed) for part in parts]).low
    yield audit_row(
        paper,
        (result, *parts),
        check=check,
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{sign.join(part.printed.text for part in parts)} = {_in_full(value)}, between "
            f"{_in_full(possible.low)} and {_in_full(possible.high)} with every rounding; printed "
            f"is {result.printed.text} ({result.where}), off by "
            f"{_in_full(exact(result.printed.value) - value)}. {_explained(result, parts, formula)}"
        ),
    )


def _explained(result: Number, parts: Sequence[Number], formula: Formula) -> str:
    """Say which single slips in one of the numbers would explain the difference."""
    points = [_point(part.printed) for part in parts]
    found = [
        f"{slip.meant.text} for {part.printed.text} ({slip.words})"
        for i, part in enumerate(parts)
        for slip in slips(part.printed)
        if _rounds_to(
            formula([*points[:i], _point(slip.meant), *points[i + 1 :]]).low, result.printed
        )
    ]
    found += [
        f"{slip.meant.text} for {result.printed.text} ({slip.words})"
        for slip in slips(result.printed)
        if _rounds_to(formula(points).low, slip.meant)
    ]
    if not found:
        return "No single slip in one of the numbers explains it"
    more = f", and {len(found) - LISTED} more" if len(found) > LISTED else ""
    return f"One slip would explain it: {' or '.join(found[:LISTED])}{more}"


def _rounds_to(value: Fraction, printed: Printed) -> bool:
    return abs(value - exact(printed.value)) <= unit(printed) / 2


def _reduction(before: Printed, after: Printed) -> Span:
    """Return every reduction in percent that two positive printed numbers allow."""
    old, new = span(before), span(after)
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


def _percent(before: Printed, after: Printed) -> Fraction:
    return 100 * (1 - exact(after.value) / exact(before.value))


def _arithmetic(before: Printed, after: Printed) -> str:
    return f"({before.text} − {after.text})/{before.text} = {shown(_percent(before, after))} %"


def _point(printed: Printed) -> Span:
    value = exact(printed.value)
    return Span(value, value)


def _in_full(number: Fraction) -> str:
    """Return a sum of printed numbers without loss."""
    return f"{float(number):.10g}"
