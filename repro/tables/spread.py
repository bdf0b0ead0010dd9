"""The standard deviations that n runs with the printed best, worst and mean can have."""

from collections.abc import Iterator
from fractions import Fraction

from repro.tables.blocks import Block
from repro.tables.extremes import Narrowest, Widest, narrowest, widest
from repro.tables.graded import graded
from repro.tables.order import gap, mean_is_attainable
from repro.tables.rows import AuditRow
from repro.tables.true_numbers import (
    Span,
    factor,
    root,
    root_above,
    root_below,
    shown,
    times,
)


def spread_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield a row for a negative standard deviation, else for one too large and one too small."""
    name = block.spread
    if name is None:
        return
    negative = list(graded(paper, block, (name,), check="negative-std", finds=_negative))
    yield from negative
    if negative or block.n < 2:
        return
    small = "zero-std" if block.printed(name).value == 0 else "std-floor"
    for check, finds in (("std-bound", _too_large), (small, _too_small)):
        yield from graded(paper, block, (name,), check=check, finds=finds)


def _negative(block: Block) -> str:
    name = str(block.spread)
    if block.own_span(name).high >= 0:
        return ""
    what = "standard deviation" if name == "std" else name
    return f"printed is {block.printed(name).text}; no {what} is negative"


def printed_variances(block: Block) -> Span | None:
    """Return what can be the printed standard deviation squared; None where it can be none."""
    return block.variances(block.spread) if block.spread else None


def most_squares(block: Block, squares: Fraction) -> Fraction:
    """Return how large a sum of n squares about the mean can come out that is `squares`."""
    true = root_above(squares) + root_above(Fraction(block.n)) * _moved(block)
    return true**2 * (1 + _rounded(block)) + _cancelled(block, squares)


def least_squares(block: Block, squares: Fraction) -> Fraction:
    """Return how small a sum of n squares about the mean can come out that is `squares` or more."""
    true = root_below(squares) - root_above(Fraction(block.n)) * _moved(block)
    if true <= 0:
        return Fraction(0)
    return true**2 * (1 - _rounded(block)) - _cancelled(block, squares)


def _moved(block: Block) -> Fraction:
    """Return how far a difference to the mean may be off before it is squared.

    The mean is a computed one. In single precision the runs may have been turned into floats.
    """
    turned = 0 if block.given.doubles else block.given.roundoff * block.size
    return block.mean_error + turned


def _cancelled(block: Block, squares: Fraction) -> Fraction:
    """Return what a mean of squares less the square of the mean loses, times n."""
    if block.given.two_pass:
        return Fraction(0)
    return (4 * block.n + 16) * block.given.roundoff * (squares + block.n * block.greatest_mean**2)


def _too_large(block: Block) -> str:
    best, mean, worst = (block.span(name) for name in ("best", "mean", "worst"))
    low = best.low if best else block.floor
    highs = [high for high in (worst.high if worst else None, block.ceiling) if high is not None]
    sample = widest(block.n, low, min(highs, default=None), mean)
    variances = printed_variances(block)
    if variances is None or sample is None or variances.low <= 0:
        return ""
    if variances.low * (block.n - 1) <= most_squares(block, sample.squares):
        return ""
    name, most = str(block.spread), root(sample.squares / (block.n - 1))
    beyond = f"{times(factor(root(variances.low), most))} the bound" if most else "and none can be"
    return (
        f"{block.n} runs with {_known(block, sample)} spread most with {sample.words}: a standard "
        f"deviation of {shown(most)} in the n−1 form (less in the n form); printed is "
        f"{_as_deviation(block, name)}, at least {shown(root(variances.low))}: {beyond}"
    )


def _as_deviation(block: Block, name: str) -> str:
    text = block.printed(name).text
    return text if name == "std" else f"a {name} of {text}, which is a standard deviation"


def _known(block: Block, sample: Widest) -> str:
    """Say what bounds the spread from above; a worst that no run can reach does not."""
    names = [name for name in ("best", "mean", "worst") if name in block.cells]
    if "mean" in names and "worst" in names and sample.upper == 0:
        names.remove("worst")
    parts = [f"{block.word(name)} {block.printed(name).text}" for name in names]
    function = block.function
    if "best" not in names and function is not None:
        parts.append(f"no value below {shown(function.minimum)}, the minimum of {function.title}")
    if sample.high == block.ceiling and sample.upper > 0 and function is not None:
        parts.append(f"no value above {shown(sample.high)}, which {function.title} never exceeds")
    return f"{', '.join(parts)} (each at the generous end of its rounding)"


def _too_small(block: Block) -> str:
    variances = printed_variances(block)
    least, words = _least(block)
    if variances is None or least is None:
        return ""
    if variances.high * block.n >= least_squares(block, least.squares):
        return ""
    name, bound, high = str(block.spread), root(least.squares / block.n), root(variances.high)
    printed = (
        "printed is 0, which stands for equal runs or differences whose squares underflow, "
        f"below {shown(high)}"
        if block.printed(name).value == 0
        else f"printed is {_as_deviation(block, name)}, at most {shown(high)}: "
        f"the bound is {times(factor(bound, high))} as much"
    )
    return (
        f"{words}; with the others equal, {block.n} runs have a standard deviation of at least "
        f"sqrt(({least.formula})/{block.n}) = {shown(bound)} in the n form (more in the n−1 "
        f"form); {printed}"
    )


def _rounded(block: Block) -> Fraction:
    """Return what share a computed sum of n squares may be off by, its root rounded too."""
    return 3 * (block.n + 6) * block.given.roundoff


def _least(block: Block) -> tuple[Narrowest | None, str]:
    """Return the least spread that the other cells leave, and what it rests on.

    A mean that best and worst forbid says nothing about the spread, so it is then left out.
    """
    best, mean, worst = (block.span(name) for name in ("best", "mean", "worst"))
    if mean and mean_is_attainable(block):
        below, above = gap(mean, best) or Fraction(0), gap(worst, mean) or Fraction(0)
        words = (
            f"allowing for rounding, the {block.word('best')} lies {shown(below)} or more below "
            f"the mean and the {block.word('worst')} {shown(above)} or more above it"
        )
        return narrowest(block.n, below, above), words
    return _least_of_range(block.n, best, worst)


def _least_of_range(n: int, best: Span | None, worst: Span | None) -> tuple[Narrowest | None, str]:
    width = gap(worst, best)
    if width is None:
        return None, ""
    words = (
        f"allowing for rounding, best and worst lie {shown(width)} or more apart, so at best "
        f"{shown(width / 2)} on either side of the mean"
    )
    return narrowest(n, width / 2, width / 2), words
