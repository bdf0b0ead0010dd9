"""Counts that must add up, and success rates that n runs can have."""

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial

from repro.tables.arithmetic import joined
from repro.tables.blocks import Block, turned
from repro.tables.facts import Success, WinsAndLosses
from repro.tables.graded import graded
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, exact, shown, span

ALL_SHOWN = "the table has a line for every problem that is counted, and for no other"
ALL_COUNTED = "every problem that the caption speaks of is counted"
ONCE = "every problem is counted once, not once a dimension or measure"


def tally_rows(paper: str, tally: WinsAndLosses) -> Iterator[AuditRow]:
    """Yield a row where wins, ties and losses are no counts, or not those of all problems."""
    cells, condition = tally.cells, None
    numbers = [exact(cell.printed.value) for cell in cells]
    text = " + ".join(cell.printed.text for cell in cells)
    if any(number < 0 or number.denominator != 1 for number in numbers):
        says = f"{text}: wins, ties and losses are whole numbers"
    elif tally.problems is None or not cells:
        return
    elif sum(numbers) > tally.problems or (
        tally.wins and tally.losses and tally.ties and sum(numbers) < tally.problems
    ):
        says = f"{text} = {sum(numbers)}, for {tally.problems} problems"
        condition = _if_counted(sum(numbers), tally.problems, is_told=tally.is_told)
    else:
        return
    yield audit_row(
        paper,
        cells,
        check="tally",
        grade=Grade.INCONSISTENT,
        explanation=says,
        condition=condition,
    )


def _if_counted(total: Fraction | int, problems: int, *, is_told: bool) -> str | None:
    """Return on which condition a tally of so many is not one of so many problems."""
    if not is_told:
        return ALL_SHOWN
    if total < problems:
        return ALL_COUNTED
    return ONCE if total % problems == 0 else None


def success_rows(paper: str, success: Success) -> Iterator[AuditRow]:
    """Yield a row for a rate that is no k/n, else one per statistic that it contradicts."""
    counts = _counts(success)
    rate, n = success.rate.printed, success.runs
    if not counts:
        whole = 100 if success.percent else 1
        near = float(exact(rate.value) * n / whole)
        fits = " and ".join(f"{k}/{n}" for k in (math.floor(near), math.ceil(near)) if 0 <= k <= n)
        yield audit_row(
            paper,
            (success.rate,),
            check="success-rate",
            grade=Grade.IMPOSSIBLE,
            explanation=f"printed is {rate.text}, which is no share of {n} runs; next to it are "
            f"{fits or f'0 and {n}/{n}'}",
        )
    elif success.threshold is not None and success.block is not None:
        yield from _against_threshold(paper, success, counts, success.threshold)


def _counts(success: Success) -> range:
    """Return how many of the runs can have succeeded."""
    around, whole = span(success.rate.printed), 100 if success.percent else 1
    first = math.ceil(around.low * success.runs / whole)
    last = math.floor(around.high * success.runs / whole)
    return range(max(0, first), min(success.runs, last) + 1)


def _against_threshold(
    paper: str, success: Success, counts: range, threshold: Fraction
) -> Iterator[AuditRow]:
    if success.block is None:
        return
    n, block = success.runs, replace(turned(success.block), n=success.runs)
    # the number of runs at the threshold or below it; where runs maximise these are the others
    below = (
        Span(Fraction(n - counts[-1]), Fraction(n - counts[0]))
        if success.block.maximise
        else Span(Fraction(counts[0]), Fraction(counts[-1]))
    )
    for name in ("best", "mean", "median", "worst"):
        if name in block.cells:
            rows = graded(
                paper,
                block,
                (name,),
                check="success-threshold",
                finds=partial(_contradicted, name, success, below, threshold),
                beside=(success.rate,),
                grade=Grade.INCONSISTENT,
            )
            for row in rows:
                yield replace(row, condition=joined((row.condition, success.condition)))


def _contradicted(
    name: str, success: Success, below: Span, threshold: Fraction, block: Block
) -> str:
    around = block.span(name)
    low, high = _allowed(name, block, below, threshold)
    moved = abs(threshold) * block.given.roundoff  # a run may be kept as the float next to it
    if around is None:
        return ""
    if high is not None and around.low > high + moved:
        says = f"at most {shown(high)}"
    elif low is not None and around.high < low - moved:
        says = f"at least {shown(low)}"
    else:
        return ""
    rate = f"{success.rate.printed.text}{_percent(success)}"
    return (
        f"where {rate} of {success.runs if success.is_told else 'the'} runs reach "
        f"{shown(threshold)}, the {block.word(name)} is {says}; printed is "
        f"{block.printed(name).text}"
    )


def _percent(success: Success) -> str:
    return " %" if success.percent and "%" not in success.rate.printed.text else ""


def _allowed(
    name: str, block: Block, below: Span, threshold: Fraction
) -> tuple[Fraction | None, Fraction | None]:
    """Return what the statistic is between, where so many runs end at the threshold or below."""
    n = block.n
    if name == "mean":
        return _mean_allowed(block, below, threshold)
    needed = {"best": 1, "median": n // 2 + 1, "worst": n}[name]
    enough = {"best": 1, "median": (n + 1) // 2, "worst": n}[name]
    return (
        threshold if below.high < enough else None,
        threshold if below.low >= needed else None,
    )


def _mean_allowed(
    block: Block, below: Span, threshold: Fraction
) -> tuple[Fraction | None, Fraction | None]:
    best, worst, n = block.span("best"), block.span("worst"), block.n
    least = best.low if best else block.floor
    most = worst.high if worst else block.ceiling
    low = high = None
    if below.high == 0:
        low = threshold
    elif least is not None:
        low = threshold + min(Fraction(0), least - threshold) * below.high / n
    if below.low == n:
        high = threshold
    elif most is not None:
        high = threshold + max(Fraction(0), most - threshold) * (n - below.low) / n
    return low, high
