"""What a printed median or quantile says about the mean and the standard deviation beside it."""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from repro.tables.blocks import Block
from repro.tables.graded import graded
from repro.tables.rows import AuditRow
from repro.tables.spread import least_squares, printed_variances
from repro.tables.statistic_words import quantile_share, runs_around
from repro.tables.true_numbers import root, shown


def quantile_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield a row per quantile that lies too far from the mean, or that the mean cannot have.

    `k` values of n lie at a quantile or below, and as many at it or above, whichever of the usual
    definitions is meant: those on one side of the mean hold its standard deviation apart.
    """
    for name in block.cells:
        if quantile_share(name) is None or "mean" not in block.cells:
            continue
        if block.spread is not None and block.n > 1:
            yield from graded(
                paper,
                block,
                ("mean", name, block.spread),
                check="quantile-bound",
                finds=partial(_too_far, name),
            )
        for finds in (_mean_too_low, _mean_too_high):
            yield from graded(
                paper, block, ("mean", name), check="quantile-mean", finds=partial(finds, name)
            )


def _too_far(name: str, block: Block) -> str:
    mean, at, variances = block.span("mean"), block.span(name), printed_variances(block)
    if mean is None or at is None or variances is None:
        return ""
    below, above = runs_around(name, block.n)
    gap, k = max(((mean - at).low, below), ((at - mean).low, above))
    if gap <= 0 or k <= 0:
        return ""
    if k == block.n:
        k = block.n - 1  # one value at the other side balances all the others
    squares = gap**2 * Fraction(k * block.n, block.n - k)
    if variances.high * block.n >= least_squares(block, squares):
        return ""
    spread = str(block.spread)
    return (
        f"the mean {block.printed('mean').text} and the {name} {block.printed(name).text} are "
        f"{shown(gap)} or more apart, with {k} of {block.n} values no nearer to the mean: their "
        f"standard deviation is at least {shown(gap)} × sqrt({k}/{block.n - k}) = "
        f"{shown(root(squares / block.n))} in the n form (more in the n−1 form); printed is "
        f"{spread} {block.printed(spread).text}, at most {shown(root(variances.high))}"
    )


def _mean_too_low(name: str, block: Block) -> str:
    mean, at, best = block.span("mean"), block.span(name), block.span("best")
    low = best.low if best else block.floor
    if mean is None or at is None or low is None:
        return ""
    _, above = runs_around(name, block.n)
    least = low + (at.low - low) * Fraction(above, block.n)
    if mean.high >= least or at.low < low:
        return ""
    return (
        f"{above} of {block.n} runs are no less than the {name} {block.printed(name).text} and "
        f"none is below {shown(low)}, so the mean is at least {shown(least)}; printed is "
        f"{block.printed('mean').text}, at most {shown(mean.high)}"
    )


def _mean_too_high(name: str, block: Block) -> str:
    mean, at, worst = block.span("mean"), block.span(name), block.span("worst")
    high = worst.high if worst else block.ceiling
    if mean is None or at is None or high is None:
        return ""
    below, _ = runs_around(name, block.n)
    most = high - (high - at.high) * Fraction(below, block.n)
    if mean.low <= most or at.high > high:
        return ""
    return (
        f"{below} of {block.n} runs are no greater than the {name} {block.printed(name).text} and "
        f"none is above {shown(high)}, so the mean is at most {shown(most)}; printed is "
        f"{block.printed('mean').text}, at least {shown(mean.low)}"
    )
