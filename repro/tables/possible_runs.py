"""The numbers of runs that a block allows, where no number of runs is told."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from repro.tables.arithmetic import both, joined
from repro.tables.blocks import Block
from repro.tables.rows import AuditRow

TRIED = (*range(2, 31), 35, 40, 50, 51, 60, 75, 100, 150, 200, 300, 500, 1000)
GROWING = ("mean-bound", "std-floor", "zero-std", "double-step", "below-minimum")
"""Checks that allow the more the more runs there are."""
FEW, USUAL = TRIED[0], 30
ONE_OF_THESE = f"the number of runs is {FEW}, {USUAL} or {TRIED[-1]}"
Check = Callable[[Block], Iterable[AuditRow]]


def can_be(block: Block, n: int, rows: Check) -> bool:
    """Say whether nothing is found in a block of n runs."""
    return next(iter(rows(replace(block, n=n))), None) is None


def least_runs(block: Block, rows: Check) -> int | None:
    """Return the smallest number of runs for which a block can be; None where none of those tried.

    Rows that need more than the usual count, too: they say what is unlikely.
    """
    return next((n for n in TRIED if can_be(block, n, rows)), None)


def possible_runs(block: Block, rows: Check) -> str:
    """Return in words which numbers of runs a block allows, of those that are tried."""
    least = least_runs(block, rows)
    if least is None:
        return f"for no n up to {TRIED[-1]}"
    most = next(n for n in reversed(TRIED) if can_be(block, n, rows))
    if most == TRIED[-1]:
        return f"from n = {least}"
    return f"from n = {least} to {most}" if least < most else f"for n = {least} alone"


def rows_at_any_number(block: Block, rows: Check) -> list[AuditRow]:
    """Return the rows of a block that no number of runs tried allows.

    Those that differ with it say up to which number they hold, or which ones were tried. More runs
    do not always allow more: a spread that a few give in the n-1 form can be too wide for many.
    """
    many = list(rows(replace(block, n=TRIED[-1])))
    if not many:
        return []
    few = list(rows(replace(block, n=FEW)))
    same = {_key(row): row.condition for row in few}
    always = [row for row in many if _key(row) in same]
    if not always and least_runs(block, rows) is not None:
        return []
    growing = [row for row in many if row not in always and row.check in GROWING]
    rest = [row for row in many if row not in always and row not in growing]
    for found in (few, list(rows(replace(block, n=USUAL))) if rest else []):
        places = {_place(row): row.condition for row in found}
        rest = [
            replace(row, condition=both(row.condition, places[_place(row)]))
            for row in rest
            if _place(row) in places
        ]
    upto = f"the number of runs is at most {TRIED[-1]}"
    return [
        *(replace(row, condition=both(row.condition, same[_key(row)])) for row in always),
        *(replace(row, condition=joined((row.condition, upto))) for row in growing),
        *(replace(row, condition=joined((row.condition, ONE_OF_THESE))) for row in rest),
    ]


def _place(row: AuditRow) -> tuple[str, str | None]:
    return row.check, row.column


def _key(row: AuditRow) -> tuple[str, str | None, str]:
    return row.check, row.column, row.explanation
