"""A measured interval against a printed number and the band accepted about it."""

import math
from enum import StrEnum
from typing import Literal

from repro.model.tolerances import Interval

Unseen = float | Literal["unbounded"]


class Verdict(StrEnum):
    """What is said of a printed number; the value is the words shown."""

    REPRODUCED = "reproduced"
    CONSISTENT = "consistent"
    UNDECIDED = "undecided"
    DEPENDS = "depends"
    CONTRADICTED = "contradicted"
    NOT_REPRODUCIBLE = "not reproducible"
    NOT_RUN = "not run"


HELD = (Verdict.REPRODUCED, Verdict.CONSISTENT)


def verdict_of(
    measured: Interval, printed: Interval, accepted: Interval
) -> tuple[Verdict, str | None]:
    """Return the verdict, and for a contradicted number on which side the measured one lies.

    `measured` is what a table like the paper's shows in 95 of 100 cases, `printed` the number with
    its rounding, `accepted` the band about it.
    """
    if accepted[0] <= measured[0] and measured[1] <= accepted[1]:
        return Verdict.REPRODUCED, None
    if measured[0] <= printed[1] and printed[0] <= measured[1]:
        return Verdict.CONSISTENT, None
    if measured[1] < accepted[0]:
        return Verdict.CONTRADICTED, "lower"
    if measured[0] > accepted[1]:
        return Verdict.CONTRADICTED, "higher"
    return Verdict.UNDECIDED, None


def unseen(measured: Interval, printed: float, minimum: float = 0.0) -> Unseen:
    """Return by which factor a consistent number could be off, and still be consistent.

    Factors are of distances from the `minimum`. There is no end where such tables reach the
    minimum itself, or where nothing bounds them.
    """
    low, high = (end - minimum for end in measured)
    own = printed - minimum
    if own < 0.0:
        own, low, high = -own, -high, -low
    if own == low == high:
        return 1.0
    if own <= 0.0 or low <= 0.0 or not math.isfinite(high):
        return "unbounded"
    return max(high / own, own / low, 1.0)
