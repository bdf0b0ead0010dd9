"""The numbers of runs that a block allows, where no number of runs is told."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from repro.tables.blocks import Block
from repro.tables.rows import AuditRow

TRIED = (*range(2, 31), 35, 40, 50, 51, 60, 75, 100, 150, 200, 300, 500, 1000)
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

    Those that differ with it hold up to the greatest that was tried, and say so. More runs do not
    always allow more: a spread that a few give in the n-1 form can be too wide for many.
    """
    many = list(rows(replace(block, n=TRIED[-1])))
    if not many:
        return []
    few = rows(replace(block, n=TRIED[0]))
    same = {(row.check, row.column, row.explanation) for row in few}
    told = f"the number of runs is at most {TRIED[-1]}"
    at_all = [row for row in many if (row.check, row.column, row.explanation) in same]
    if not at_all and least_runs(block, rows) is not None:
        return []
    return [
        row
        if row in at_all
        else replace(row, condition=f"{row.condition}, and {told}" if row.condition else told)
        for row in many
    ]
