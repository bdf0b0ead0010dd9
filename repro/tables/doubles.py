"""What IEEE doubles forbid: values that a function cannot take, and spreads that are rounding."""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.blocks import Block
from repro.tables.graded import graded
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.statistic_words import is_width
from repro.tables.true_numbers import Span, exact, shown, span

RUNS = 1000  # the largest number of runs that is tried to explain a spread of rounding
SPACINGS = 16  # a computed mean of equal values is off by fewer of its last bits than this


def double_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield rows for values below the minimum, between two doubles, and for spreads of rounding."""
    for name in block.cells:
        if not is_width(name) and block.function is not None:
            yield from graded(
                paper, block, (name,), check="above-ceiling", finds=partial(_above_ceiling, name)
            )
            yield from graded(
                paper, block, (name,), check="below-minimum", finds=partial(_below_minimum, name)
            )
            yield from graded(
                paper,
                block,
                (name,),
                check="double-step",
                finds=partial(_between_doubles, name),
                condition=block.function.condition,
            )
    if explanation := _rounding_spread(block):
        yield audit_row(
            paper,
            (block.cells["std"],),
            check="std-at-rounding",
            grade=Grade.NOTED,
            explanation=explanation,
            condition=IN_DOUBLES,
        )


def _below_minimum(statistic: str, block: Block) -> str:
    highest, function = block.own_span(statistic).high, block.function
    if function is None or block.floor is None or highest >= block.floor:
        return ""
    return (
        f"printed is {block.printed(statistic).text}, at most {shown(highest)} with its rounding; "
        f"{function.title} has the minimum {shown(function.minimum)}, and no run or mean "
        "of runs lies below it"
    )


def _above_ceiling(statistic: str, block: Block) -> str:
    lowest, function = block.own_span(statistic).low, block.function
    if function is None or block.ceiling is None or lowest <= block.ceiling:
        return ""
    return (
        f"printed is {block.printed(statistic).text}, at least {shown(lowest)} with its rounding; "
        f"no value of {function.title} on its box is above {shown(block.ceiling)}"
    )


def _between_doubles(statistic: str, block: Block) -> str:
    """Explain a value above 0 that is less than the smallest step of a cancelling function."""
    function, here = block.function, block.own_span(statistic)
    if function is None or not function.step or here.low <= 0:
        return ""
    step, runs = function.step, block.n if statistic == "mean" else 1
    if here.high >= step / runs * Fraction(1023, 1024):  # spares the rounding of the division
        return ""
    what = f"the mean of {runs} runs" if runs > 1 else "a run"
    least = f"{shown(step)}/{runs} = {shown(step / runs)}" if runs > 1 else shown(step)
    return (
        f"near its minimum 0, {function.title} takes values in steps of {shown(step)}, so {what} "
        f"is 0 or at least {least}; printed is {block.printed(statistic).text}"
    )


def _rounding_spread(block: Block) -> str:
    """Explain a spread no larger than the last bits of the mean.

    Equal values have a computed mean that can be off by k spacings of doubles, and then a
    standard deviation of k spacings times sqrt(n/(n-1)).
    """
    if not {"mean", "std"} <= block.cells.keys() or block.n < 2:
        return ""
    spacing = Fraction(math.ulp(block.printed("mean").value))
    printed = span(block.printed("std"))
    if printed.low <= 0 or printed.high > SPACINGS * spacing:
        return ""
    nearest = max(1, round(exact(block.printed("std").value) / spacing))
    expected = float(nearest * spacing) * math.sqrt(block.n / (block.n - 1))
    return (
        f"doubles near {block.printed('mean').text} are {shown(spacing)} apart; {block.n} equal "
        "values whose computed mean is off by k of these spacings give k × "
        f"{shown(spacing)} × sqrt({block.n}/{block.n - 1}), {shown(expected)} for k = {nearest}; "
        f"printed is {block.printed('std').text}, {_fits(printed, spacing)}"
    )


def _fits(printed: Span, spacing: Fraction) -> str:
    """Say for which numbers of equal runs rounding alone gives the printed spread."""
    fits = []
    for k in range(1, SPACINGS + 1):
        low, high = ((end / (k * spacing)) ** 2 for end in (printed.low, printed.high))
        if high > 1:  # n/(n-1) falls with n and lies between these
            least = math.ceil(high / (high - 1))
            most = math.floor(low / (low - 1)) if low > 1 else RUNS
            if least <= min(most, RUNS):
                fits.append(f"k = {k} and {_range(least, min(most, RUNS))}")
    return f"which fits {'; '.join(fits)}" if fits else f"which fits no n up to {RUNS}"


def _range(least: int, most: int) -> str:
    return f"n = {least}" if least == most else f"n from {least} to {most}"
