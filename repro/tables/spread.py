"""The standard deviations that n runs with the printed best, worst and mean can have."""

from collections.abc import Iterator
from fractions import Fraction

from repro.tables.blocks import Block
from repro.tables.extremes import Narrowest, Widest, narrowest, widest
from repro.tables.graded import graded
from repro.tables.order import gap, mean_is_attainable
from repro.tables.rows import AuditRow
from repro.tables.true_numbers import Span, factor, root, shown, times


def spread_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield a row for a negative standard deviation, else for one too large and one too small."""
    if "std" not in block.cells:
        return
    negative = list(graded(paper, block, ("std",), check="negative-std", finds=_negative))
    yield from negative
    if negative or block.n < 2:
        return
    small = "zero-std" if block.printed("std").value == 0 else "std-floor"
    for check, finds in (("std-bound", _too_large), (small, _too_small)):
        yield from graded(paper, block, ("std",), check=check, finds=finds)


def _negative(block: Block) -> str:
    if block.own_span("std").high >= 0:
        return ""
    return f"printed is {block.printed('std').text}; no standard deviation is negative"


def _too_large(block: Block) -> str:
    std, best, mean, worst = (block.span(name) for name in ("std", "best", "mean", "worst"))
    low = best.low if best else block.floor
    highs = [high for high in (worst.high if worst else None, block.ceiling) if high is not None]
    sample = widest(block.n, low, min(highs, default=None), mean)
    if std is None or sample is None or std.low <= 0:
        return ""
    # squares are taken about the computed mean, and every step of them is rounded
    squares = sample.squares + block.n * block.mean_error**2
    if std.low**2 * (block.n - 1) <= squares * (1 + _rounded(block)):
        return ""
    most = root(sample.squares / (block.n - 1))
    beyond = f"{times(factor(std.low, most))} the bound" if most else "and none can be"
    return (
        f"{block.n} runs with {_known(block, sample)} spread most with {sample.words}: a standard "
        f"deviation of {shown(most)} in the n−1 form (less in the n form); printed is "
        f"{block.printed('std').text}, at least {shown(std.low)}: {beyond}"
    )


def _known(block: Block, sample: Widest) -> str:
    """Say what bounds the spread from above; a worst that no run can reach does not."""
    names = [name for name in ("best", "mean", "worst") if name in block.cells]
    if "mean" in names and "worst" in names and sample.upper == 0:
        names.remove("worst")
    parts = [f"{name} {block.printed(name).text}" for name in names]
    function = block.function
    if "best" not in names and function is not None:
        parts.append(f"no value below {shown(function.minimum)}, the minimum of {function.title}")
    if sample.high == block.ceiling and sample.upper > 0 and function is not None:
        parts.append(f"no value above {shown(sample.high)}, which {function.title} never exceeds")
    return f"{', '.join(parts)} (each at the generous end of its rounding)"


def _too_small(block: Block) -> str:
    std = block.span("std")
    least, words = _least(block)
    if std is None or least is None:
        return ""
    if std.high**2 * block.n >= least.squares * (1 - _rounded(block)):
        return ""
    bound = root(least.squares / block.n)
    printed = (
        "printed is 0, which stands for equal runs or differences whose squares underflow, "
        f"below {shown(std.high)}"
        if block.printed("std").value == 0
        else f"printed is {block.printed('std').text}, at most {shown(std.high)}: "
        f"the bound is {times(factor(bound, std.high))} as much"
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
            f"allowing for rounding, the best lies {shown(below)} or more below the mean and the "
            f"worst {shown(above)} or more above it"
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
