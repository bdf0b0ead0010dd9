"""Sums, differences and percentages recomputed from the numbers that they are made of."""

import itertools
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from operator import add, sub

from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.digit_slips import slips
from repro.tables.published import Printed
from repro.tables.relations import Less, Number, PercentLower, Sum, TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import DOUBLES, SINGLES, Span, exact, shown, span, unit

Formula = Callable[[Sequence[Span]], Span]


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

    def agrees(share: Fraction) -> bool:
        possible = formula([span(part.printed, share=share) for part in parts])
        return possible.meets(span(result.printed, share=share))

    if agrees(DOUBLES):
        return
    possible = formula([span(part.printed) for part in parts])
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
        condition=IN_DOUBLES if agrees(SINGLES) else None,
    )


def _explained(result: Number, parts: Sequence[Number], formula: Formula) -> str:
    """Say which single slips in one of the numbers would close the sum, and how many they are."""
    printed = [*(part.printed for part in parts), result.printed]
    exactly, within = [], []
    for i, number in enumerate(printed):
        for slip in slips(number):
            meant = [*printed[:i], slip.meant, *printed[i + 1 :]]
            addends, total = meant[:-1], meant[-1]
            words = f"{slip.meant.text} for {number.text} ({slip.words})"
            if _rounds_to(formula(list(map(_point, addends))).low, total):
                exactly.append(words)
            elif formula(list(map(span, addends))).meets(span(total)):
                within.append(words)
    if not exactly and not within:
        return "No single slip in one of the numbers explains it"
    return ". ".join(
        f"{_counted(len(found))} would close it {how}: {', '.join(found)}"
        for found, how in (
            (exactly, "with the other numbers as they are printed"),
            (within, "only with the rounding of the others"),
        )
        if found
    )


def _counted(count: int) -> str:
    return "1 single slip" if count == 1 else f"{count} single slips, any one of them,"


def _rounds_to(value: Fraction, printed: Printed) -> bool:
    return abs(value - exact(printed.value)) <= unit(printed) / 2


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
