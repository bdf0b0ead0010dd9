"""From evidence to findings: every printed number and claim with interval, band and verdict."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from repro.judge.verdict import Verdict, verdict_of
from repro.model.claims import CellClaim, Claim
from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import Measure, Measured
from repro.model.tolerances import Interval
from repro.runs.readings import Reading
from repro.statistics.tables import quantile_interval
from repro.tables.published import UNITS

LEVEL = 0.95
PROVISIONAL = "provisional: one repeat only"
IN_WORDS = "in words"
FLIPS = "the odd and the even repeats come to opposite verdicts"


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingOutcome:
    """What becomes of a number under another reading of the paper, by the reading's name."""

    reading: str
    measured: Interval
    verdict: Verdict
    side: str | None


@dataclass(frozen=True, slots=True, kw_only=True)
class EvidenceUnder:
    """The evidence under a reading of the paper, with its claims in the order of the paper's.

    `changed` are the cells whose runs are not the paper's.
    """

    reading: Reading
    claims: tuple[Claim, ...]
    evidence: Evidence
    changed: frozenset[Cell]


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
    readings: tuple[ReadingOutcome, ...] = ()


def findings_of(
    claims: Iterable[Claim], evidence: Evidence, others: Sequence[EvidenceUnder] = ()
) -> tuple[Finding, ...]:
    """Return one finding per claim, in the order of declaration.

    A contradicted number is judged again under every other reading that bears on it.
    """
    findings = []
    for position, claim in enumerate(claims):
        finding = judged(claim, evidence)
        if finding.verdict is Verdict.CONTRADICTED:
            finding = replace(finding, readings=_readings(position, claim, others))
        findings.append(finding)
    return tuple(findings)


def _readings(
    position: int, own: Claim, others: Sequence[EvidenceUnder]
) -> tuple[ReadingOutcome, ...]:
    outcomes = []
    for other in others:
        claim = other.claims[position]
        cells = claim.measure.cells() if claim.measure else ()
        if claim is own and other.changed.isdisjoint(cells):
            continue
        finding = judged(claim, other.evidence, halves=False)
        if finding.measured is not None:
            outcomes.append(
                ReadingOutcome(
                    reading=other.reading.name,
                    measured=finding.measured,
                    verdict=finding.verdict,
                    side=finding.side,
                )
            )
    return tuple(outcomes)


def judged(claim: Claim, evidence: Evidence, *, halves: bool = True) -> Finding:
    """Return what is said of one claim; `halves` of the repeats must then agree."""
    if claim.measure is None:
        why = claim.gap.because if claim.gap else ""
        return _unsaid(claim, Verdict.NOT_REPRODUCIBLE, note=why)
    absent = [cell for cell in claim.measure.cells() if cell not in evidence.runs]
    if absent:
        names = ", ".join("/".join(cell) for cell in absent)
        return _unsaid(claim, Verdict.NOT_RUN, note=f"no whole repeat of {names}")
    measured = claim.measure.measure(evidence)
    interval = _interval(claim, measured)
    verdict, side = verdict_of(interval, claim.accepted.band(claim.printed))
    note = PROVISIONAL if measured.repeats == 1 else ""
    if halves and _flips(claim.measure, claim, evidence):
        verdict, side, note = Verdict.UNDECIDED, None, FLIPS
    return replace(
        _unsaid(claim, verdict, note=note),
        measured=interval,
        value=measured.value / UNITS[claim.printed.unit],
        side=side,
        quantile=_quantile(claim, measured) if measured.repeats and not _in_words(claim) else None,
        repeats=measured.repeats,
    )


def _in_words(claim: Claim) -> bool:
    return not isinstance(claim, CellClaim) and claim.in_words


def _interval(claim: Claim, measured: Measured) -> Interval:
    """Return the central interval of the draws, in the printed unit."""
    low, high = quantile_interval(measured.draws, LEVEL)
    factor = UNITS[claim.printed.unit]
    return low / factor, high / factor


def _flips(measure: Measure, claim: Claim, evidence: Evidence) -> bool:
    """Return whether the odd and the even repeats, judged alone, come to opposite verdicts."""
    cells = measure.cells()
    if not cells or any(len(evidence.runs[cell].costs) < 2 for cell in cells):
        return False
    accepted = claim.accepted.band(claim.printed)
    verdicts = {
        verdict_of(_interval(claim, measure.measure(half)), accepted) for half in evidence.halves()
    }
    decided = {pair for pair in verdicts if pair[0] is not Verdict.UNDECIDED}
    return len(decided) > 1


def _quantile(claim: Claim, measured: Measured) -> float:
    """Return the share of resampled tables below the printed value, ties counted as half."""
    printed = claim.printed.si
    below = (measured.draws < printed).mean()
    return float(below + 0.5 * (measured.draws == printed).mean())


def _unsaid(claim: Claim, verdict: Verdict, *, note: str = "") -> Finding:
    """Return a finding that names the claim and measures nothing."""
    table, row, column = claim.place or (None, None, None)
    return Finding(
        table=table,
        row=row,
        column=column,
        claim=None if isinstance(claim, CellClaim) else claim.claim,
        where=claim.where,
        printed=IN_WORDS if _in_words(claim) else claim.printed.text,
        unit=claim.printed.unit,
        measured=None,
        value=None,
        accepted=claim.accepted.band(claim.printed),
        verdict=verdict,
        side=None,
        note=note,
        measure=claim.measure.words if claim.measure else "",
        tolerance=claim.accepted.words,
    )
