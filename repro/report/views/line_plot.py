"""The numbers of the small line plot in a number's panel, which a script draws."""

import math
from collections.abc import Iterable, Sequence

from repro.judge.certificates import Certificate
from repro.judge.findings import IN_WORDS, Finding
from repro.judge.proved_times import TOTAL
from repro.model.claims import Claim
from repro.model.measures.measure import Statistic
from repro.tables.published import UNITS, Printed

DIGITS = 6  # more than a plot of some 400 px can show
OF_RUNS = ("best", "mean", "median", "worst", "single")  # statistics that no proved least exceeds


def least_values(
    claims: Iterable[Claim], certificates: Sequence[Certificate]
) -> list[float | None]:
    """Return for each claim the proved least of what it measures, in its unit, where there is one.

    Only total times of certified motions have one.
    """
    proved = {each.problem: each.minimum for each in certificates}
    return [_least(claim, proved) for claim in claims]


def _least(claim: Claim, proved: dict[str, float | None]) -> float | None:
    measure = claim.measure
    if not isinstance(measure, Statistic) or measure.quantity != TOTAL:
        return None
    minimum = proved.get(f"{measure.experiment}/{measure.problem}")
    if minimum is None or measure.statistic not in OF_RUNS:
        return None
    return minimum * UNITS["s"] / UNITS[claim.printed.unit]


def drawn_number(finding: Finding, least: float | None) -> str:
    """Return printed number, accepted band, interval and proved least; "" for what is not there.

    Nothing at all is drawn of a number that was not measured.
    """
    if finding.measured is None:
        return ""
    worded = finding.printed == IN_WORDS
    printed = math.nan if worded else Printed(finding.printed, finding.unit).value
    ends = (printed, *finding.accepted, *finding.measured, math.nan if least is None else least)
    return drawn_ends(ends)


def drawn_ends(numbers: Iterable[float]) -> str:
    """Return numbers in few characters, with commas between; what is not finite is left out."""
    return ",".join(f"{n:.{DIGITS}g}" if math.isfinite(n) else "" for n in numbers)
