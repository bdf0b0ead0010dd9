"""From evidence to findings: every printed number and claim with interval, band and verdict."""

import math
from dataclasses import dataclass

from repro.claims import CellClaim, Claim
from repro.evidence import Evidence
from repro.measures import Measured
from repro.published import UNITS
from repro.statistics.tables import quantile_interval
from repro.verdict import Interval, Verdict, judge

LEVEL = 0.95
PROVISIONAL = "provisional: one repeat only"


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """What is said of one printed number or sentence; numbers are in the printed unit."""

    table: str | None
    row: str | None
    column: str | None
    claim: str | None
    where: str
    printed: str
    unit: str
    measured: Interval | None
    value: float | None
    accepted: Interval
    verdict: Verdict
    side: str | None
    note: str
    quantile: float | None = None
    repeats: int = 0
    measure: str = ""
    tolerance: str = ""


def judge_paper(evidence: Evidence) -> tuple[Finding, ...]:
    """Return one finding per claim of the paper, in the order of declaration."""
    return tuple(_finding(claim, evidence) for claim in evidence.paper.claims)


def _finding(claim: Claim, evidence: Evidence) -> Finding:
    accepted = claim.accepted.band(claim.printed)
    if claim.measure is None:
        why = claim.gap.because if claim.gap else ""
        return _named(claim, accepted, Verdict.NOT_REPRODUCIBLE, note=why)
    absent = [cell for cell in claim.measure.cells() if cell not in evidence.runs]
    if absent:
        names = ", ".join("/".join(cell) for cell in absent)
        return _named(claim, accepted, Verdict.NOT_RUN, note=f"no whole repeat of {names}")
    measured = claim.measure.measure(evidence)
    factor = UNITS[claim.printed.unit]
    low, high = quantile_interval(measured.draws, LEVEL)
    interval = (low / factor, high / factor)
    verdict, side = judge(interval, accepted)
    return _named(
        claim,
        accepted,
        verdict,
        measured=interval,
        value=measured.value / factor,
        side=side,
        note=PROVISIONAL if measured.repeats == 1 else "",
        quantile=_quantile(claim, measured) if measured.repeats else None,
        repeats=measured.repeats,
    )


def _quantile(claim: Claim, measured: Measured) -> float:
    """Return the share of resampled tables below the printed value, ties counted as half."""
    printed = claim.printed.si
    below = (measured.draws < printed).mean()
    return float(below + 0.5 * (measured.draws == printed).mean())


def _named(
    claim: Claim,
    accepted: Interval,
    verdict: Verdict,
    *,
    measured: Interval | None = None,
    value: float | None = None,
    side: str | None = None,
    note: str = "",
    quantile: float | None = None,
    repeats: int = 0,
) -> Finding:
    return Finding(
        table=claim.table.label if isinstance(claim, CellClaim) else None,
        row=claim.row if isinstance(claim, CellClaim) else None,
        column=claim.column if isinstance(claim, CellClaim) else None,
        claim=None if isinstance(claim, CellClaim) else claim.claim,
        where=claim.where,
        printed=claim.printed.text,
        unit=claim.printed.unit,
        measured=measured,
        value=value,
        accepted=accepted,
        verdict=verdict,
        side=side,
        note=note,
        quantile=quantile,
        repeats=repeats,
        measure=claim.measure.words if claim.measure else "",
        tolerance=claim.accepted.words,
    )


def shown(value: float | None) -> str:
    """Return a number with four significant digits, as the pages show it."""
    if value is None:
        return "–"
    if value == 0 or (math.isfinite(value) and 1e-3 <= abs(value) < 1e5):
        return f"{value:.4g}"
    return f"{value:.3e}"
