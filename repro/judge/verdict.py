"""A measured interval against an accepted band."""

from enum import StrEnum

from repro.model.tolerances import Interval


class Verdict(StrEnum):
    """What is said of a printed number; the value is the words shown."""

    REPRODUCED = "reproduced"
    CONTRADICTED = "contradicted"
    UNDECIDED = "undecided"
    NOT_REPRODUCIBLE = "not reproducible"
    NOT_RUN = "not run"


def verdict_of(measured: Interval, accepted: Interval) -> tuple[Verdict, str | None]:
    """Return the verdict, and for a contradicted number on which side the measured one lies."""
    if measured[1] < accepted[0]:
        return Verdict.CONTRADICTED, "lower"
    if measured[0] > accepted[1]:
        return Verdict.CONTRADICTED, "higher"
    if accepted[0] <= measured[0] and measured[1] <= accepted[1]:
        return Verdict.REPRODUCED, None
    return Verdict.UNDECIDED, None
