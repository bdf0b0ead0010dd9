"""Means and standard deviations that n whole numbers can have, such as counts.

For means: N. J. L. Brown, J. A. J. Heathers, The GRIM test, Social Psychological and Personality
Science 8 (2017) 363-369; for standard deviations: J. Anaya, The GRIMMER test, PeerJ Preprints
4:e2400v1 (2016). Both are exact here: n is known, and rounding may be up, down or cut off.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from repro.tables.blocks import Block
from repro.tables.graded import graded
from repro.tables.rows import AuditRow
from repro.tables.spread import least_squares, most_squares, printed_variances
from repro.tables.true_numbers import shown

TOTALS = 1000  # more whole sums than this behind one mean say nothing of a spread


def whole_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield rows for statistics that whole numbers cannot have, where the runs are whole."""
    if not block.whole_numbers:
        return
    for name in ("best", "worst"):
        if name in block.cells:
            yield from graded(
                paper, block, (name,), check="whole-number", finds=partial(_no_whole, name)
            )
    if "mean" not in block.cells:
        return
    found = list(graded(paper, block, ("mean",), check="whole-mean", finds=_no_mean))
    yield from found
    if not found and block.spread is not None and block.n > 1:
        cells = ("mean", block.spread)
        yield from graded(paper, block, cells, check="whole-std", finds=_no_spread)


def _no_whole(name: str, block: Block) -> str:
    around = block.own_span(name)
    if math.ceil(around.low) <= around.high:
        return ""
    return f"every run is a whole number; the {block.word(name)} is {block.printed(name).text}"


def _totals(block: Block) -> range:
    around = block.own_span("mean")
    return range(math.ceil(around.low * block.n), math.floor(around.high * block.n) + 1)


def _no_mean(block: Block) -> str:
    if _totals(block):
        return ""
    value = Fraction(repr(block.printed("mean").value)) * block.n
    near = (math.floor(value), math.ceil(value))
    fits = " and ".join(f"{total}/{block.n} = {total / block.n:.6g}" for total in near)
    return (
        f"the mean of {block.n} whole numbers is a whole sum over {block.n}: next to the printed "
        f"{block.printed('mean').text} are {fits}"
    )


def _no_spread(block: Block) -> str:
    variances, totals = printed_variances(block), _totals(block)
    if variances is None or len(totals) > TOTALS:
        return ""
    if any(_squares_fit(block, total, variances.low, variances.high) for total in totals):
        return ""
    spread = str(block.spread)
    return (
        f"{block.n} whole numbers with the mean {block.printed('mean').text} have the sum "
        f"{totals[0]}{f' to {totals[-1]}' if len(totals) > 1 else ''}; none whose squares have a "
        f"whole sum, odd where that is odd, has the {spread} {block.printed(spread).text} in the "
        f"n or the n−1 form (sums of squares about the mean between "
        f"{shown(variances.low * (block.n - 1))} and {shown(variances.high * block.n)} were tried)"
    )


def _squares_fit(block: Block, total: int, low: Fraction, high: Fraction) -> bool:
    """Say whether a whole sum of squares, odd or even as the total is, gives such a variance."""
    base = Fraction(total * total, block.n)
    for degrees in (block.n, block.n - 1):
        wide = 2 * high * degrees + 1  # beyond the true sum of squares
        slack = most_squares(block, wide) - least_squares(block, wide)
        first = math.ceil(base + low * degrees - slack)
        last = math.floor(base + high * degrees + slack)
        first += (first - total) % 2
        if first <= last:
            return True
    return False
