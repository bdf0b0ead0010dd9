"""What a printed interquartile range says beside the other statistics of its runs."""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from repro.tables.blocks import Block
from repro.tables.graded import graded
from repro.tables.order import ONE_DEFINITION
from repro.tables.rows import AuditRow
from repro.tables.spread import least_squares, printed_variances
from repro.tables.statistic_words import is_range, runs_around
from repro.tables.true_numbers import Span, root, shown


def range_rows_of(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield rows for a range below 0, wider than all runs, unlike its quartiles, or than the std.

    Whichever definition of quartiles is meant, a quarter of the runs, rounded down, lies at the
    first one or below, and as many at the third one or above.
    """
    for name in filter(is_range, block.cells):
        checks = (
            ("negative-range", (name,), _negative, None),
            ("range-bound", ("best", "worst", name), _wider_than_all, None),
            ("range-quartiles", ("q1", "q3", name), _unlike_quartiles, ONE_DEFINITION),
            ("range-std", (name, str(block.spread)), _wider_than_spread, None),
        )
        for check, cells, finds, condition in checks:
            if block.cells.keys() >= set(cells):
                yield from graded(
                    paper,
                    block,
                    cells,
                    check=check,
                    finds=partial(finds, name),
                    condition=condition,
                )


def _negative(name: str, block: Block) -> str:
    if block.own_span(name).high >= 0:
        return ""
    return f"printed is {block.printed(name).text}; no range is negative"


def _between(block: Block, lower: str, upper: str) -> Span:
    """Return what can be the computed difference of two statistics."""
    apart = block.own_span(upper) - block.own_span(lower)
    error = 2 * block.given.roundoff * max(abs(apart.low), abs(apart.high))
    return Span(apart.low - error, apart.high + error)


def _wider_than_all(name: str, block: Block) -> str:
    apart, around = _between(block, "best", "worst"), block.own_span(name)
    if around.low <= max(apart.high, Fraction(0)):
        return ""
    return (
        f"all runs lie within {shown(apart.high)} of each other, as {block.named('best')} and "
        f"{block.named('worst')} say; the interquartile range is {block.printed(name).text}, at "
        f"least {shown(around.low)}"
    )


def _unlike_quartiles(name: str, block: Block) -> str:
    apart, around = _between(block, "q1", "q3"), block.own_span(name)
    if apart.meets(around):
        return ""
    return (
        f"{block.named('q3')} less {block.named('q1')} is {shown(apart.low)} to "
        f"{shown(apart.high)}; the interquartile range is {block.printed(name).text}"
    )


def _wider_than_spread(name: str, block: Block) -> str:
    variances, width = printed_variances(block), block.own_span(name).low
    k = runs_around("q1", block.n)[0]
    # of runs of unknown size, rounding may lose a spread that their range shows
    sized = "mean" in block.cells or {"best", "worst"} <= block.cells.keys()
    if variances is None or block.n < 2 or width <= 0 or not k or not sized:
        return ""
    squares = width**2 * Fraction(k, 2)  # least where the mean lies in the middle
    if variances.high * block.n >= least_squares(block, squares):
        return ""
    spread = str(block.spread)
    return (
        f"{k} of {block.n} runs lie at either end of the interquartile range "
        f"{block.printed(name).text} or beyond it, so their standard deviation is at least "
        f"{shown(width)}/2 × sqrt({2 * k}/{block.n}) = {shown(root(squares / block.n))} in the n "
        f"form (more in the n−1 form); printed is {spread} {block.printed(spread).text}, at most "
        f"{shown(root(variances.high))}"
    )
