"""What a check finds impossible in a block, and the least that it must take for granted."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product

from repro.tables.arithmetic import (
    GREATEST_SINGLE,
    LEAST_SINGLE,
    Arithmetic,
    is_bare_zero,
    joined,
    rounded_at,
)
from repro.tables.blocks import Block
from repro.tables.relations import Cell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import exact


def graded(
    paper: str,
    block: Block,
    statistics: tuple[str, ...],
    *,
    check: str,
    finds: Callable[[Block], str],
    condition: str | None = None,
    beside: tuple[Cell, ...] = (),
    grade: Grade = Grade.IMPOSSIBLE,
) -> Iterator[AuditRow]:
    """Yield the row of what a check finds, with the least that it needs as condition.

    `finds` returns an explanation, or nothing where it finds nothing; the one shown takes all for
    granted. `condition` is what the check needs however the table was made. Cells `beside` those of
    the statistics may be what contradicts them.
    """
    explanation = finds(block)  # with all granted: what that does not find, nothing else does
    if not explanation:
        return
    tried = ways(block)
    needed = next(given for given in (*tried, block.given) if finds(replace(block, given=given)))
    yield audit_row(
        paper,
        (*beside, *(block.cells[name] for name in statistics)),
        check=check,
        grade=grade,
        explanation=explanation,
        condition=joined((condition, needed.beyond(tried[0]))),
    )


def ways(block: Block) -> list[Arithmetic]:
    """Return how the block may have been made, from what takes least for granted to most."""
    printed = [cell.printed for cell in block.cells.values()]
    zeros = any(is_bare_zero(each, scientific=block.scientific) for each in printed)
    told = block.given.significant
    whole = any(rounded_at(each) for each in printed)
    boxed = block.function is not None and block.function.only_in_box
    spread = block.spread is not None
    is_open = (zeros, whole, boxed, spread)
    choices = [(False, True) if each else (False,) for each in is_open]
    doubles = (True,) if _needs_doubles(block) else (False, True)
    return [
        Arithmetic(exact_zeros=z, whole=w, in_box=b, two_pass=t, doubles=d, significant=told)
        for z, w, b, t, d in sorted(product(*choices, doubles), key=sum)
    ]


def _needs_doubles(block: Block) -> bool:
    """Say whether a number is printed that single precision cannot hold, nor a mean of such."""
    sizes = [abs(exact(cell.printed.value)) for cell in block.cells.values()]
    least = LEAST_SINGLE / (2 * block.n)
    return any(0 < size < least or size > 2 * GREATEST_SINGLE for size in sizes)
