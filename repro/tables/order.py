"""best ≤ mean ≤ worst, and a mean that n runs with this best and worst can have."""

import itertools
import math
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from repro.tables.blocks import Block
from repro.tables.graded import graded
from repro.tables.rows import AuditRow
from repro.tables.statistic_words import quantile_share, runs_around
from repro.tables.true_numbers import Span, shown

ONE_DEFINITION = "median and quartiles are of one definition"
MANY = 10**6  # from here on a number of runs is shown in round figures


def order_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield a row per pair that stands in the wrong order, and one for a mean out of reach."""
    for pair in _ordered(block):
        yield from graded(
            paper,
            block,
            pair,
            check="order",
            finds=partial(_reversed, *pair),
            condition=_if_ordered(*pair, block.n),
        )
    for finds in (_mean_too_low, _mean_too_high):
        yield from graded(paper, block, ("mean",), check="mean-bound", finds=finds)


def _ordered(block: Block) -> Iterator[tuple[str, str]]:
    """Yield the pairs of printed statistics of which the first is no greater than the second."""
    shares = {name: quantile_share(name) for name in block.cells}
    inner = sorted((share, name) for name, share in shares.items() if share is not None)
    yield from itertools.combinations(
        [name for name in ("best", *(name for _, name in inner), "worst") if name in block.cells], 2
    )


def _if_ordered(lower: str, upper: str, n: int) -> str | None:
    """Return on which condition two quantiles are in order; None where any definitions are."""
    if quantile_share(lower) is None or quantile_share(upper) is None:
        return None
    # the runs from the lower one on and those up to the upper one have a run in common
    common = runs_around(lower, n)[1] + runs_around(upper, n)[0] > n
    return None if common else ONE_DEFINITION


def _reversed(lower: str, upper: str, block: Block) -> str:
    low, high = block.span(lower), block.span(upper)
    if low is None or high is None or low.low <= high.high:
        return ""
    return (
        f"{block.named(lower)} is greater than {block.named(upper)}: at least "
        f"{shown(low.low)} against at most {shown(high.high)}"
    )


def mean_is_attainable(block: Block) -> bool:
    """Say whether n runs with the printed best and worst can have the printed mean."""
    return not (_mean_too_low(block) or _mean_too_high(block))


def _mean_too_low(block: Block) -> str:
    best, mean, worst = (block.span(name) for name in ("best", "mean", "worst"))
    if not mean or not best:
        return ""
    if mean.high < best.low:
        return (
            f"the mean {block.printed('mean').text}, at most {shown(mean.high)} with rounding, "
            f"lies below the {block.named('best')}, at least {shown(best.low)}: no "
            "number of runs allows that"
        )
    if not worst:
        return ""
    least = (worst.low + (block.n - 1) * best.low) / block.n
    if mean.high >= least:
        return ""
    runs = _runs_needed(far=worst.low - best.low, near=mean.high - best.low)
    return (
        f"one of {block.n} runs is the {block.named('worst')}, none is below the "
        f"{block.named('best')}, so the mean is at least "
        f"({shown(worst.low)} + {block.n - 1} × {shown(best.low)})/{block.n} = {shown(least)}; "
        f"printed is {block.printed('mean').text}, at most {shown(mean.high)}. {runs}"
    )


def _mean_too_high(block: Block) -> str:
    best, mean, worst = (block.span(name) for name in ("best", "mean", "worst"))
    if not mean or not worst:
        return ""
    if mean.low > worst.high:
        return (
            f"the mean {block.printed('mean').text}, at least {shown(mean.low)} with rounding, "
            f"lies above the {block.named('worst')}, at most {shown(worst.high)}: no "
            "number of runs allows that"
        )
    if not best:
        return ""
    greatest = (best.high + (block.n - 1) * worst.high) / block.n
    if mean.low <= greatest:
        return ""
    runs = _runs_needed(far=worst.high - best.high, near=worst.high - mean.low)
    return (
        f"one of {block.n} runs is the {block.named('best')}, none is above the "
        f"{block.named('worst')}, so the mean is at most "
        f"({shown(best.high)} + {block.n - 1} × {shown(worst.high)})/{block.n} = "
        f"{shown(greatest)}; printed is {block.printed('mean').text}, at least {shown(mean.low)}. "
        f"{runs}"
    )


def _runs_needed(*, far: Fraction, near: Fraction) -> str:
    """Say how many runs would bring the mean so near to one extreme."""
    if near <= 0:
        return "No number of runs allows it"
    runs = math.ceil(far / near)
    return f"It would take {runs if runs < MANY else shown(runs)} runs or more"


def gap(upper: Span | None, lower: Span | None) -> Fraction | None:
    """Return by how much `upper` exceeds `lower` at least, 0 where it need not; None if unknown."""
    if upper is None or lower is None:
        return None
    return max(Fraction(0), (upper - lower).low)
