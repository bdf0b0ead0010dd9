"""From evidence to findings: every printed number and claim with interval, band and verdict."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from repro.judge.turning import ReadingOutcome, Weighed, turned
from repro.judge.verdict import Unseen, Verdict, unseen, verdict_of
from repro.model.claims import CellClaim, Claim
from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import Measured
from repro.model.tolerances import FromMinimum, Interval, rounded
from repro.runs.readings import Reading
from repro.statistics.tables import quantile_interval
from repro.tables.published import UNITS

LEVEL = 0.95
PROVISIONAL = "provisional: one repeat only"
THIN = f"{PROVISIONAL}, and so few runs contradict no extreme, nor anything where half are equal"
IN_WORDS = "in words"


@dataclass(frozen=True, slots=True, kw_only=True)
class EvidenceUnder:
    """The evidence under a reading of the paper, with its claims in the order of the paper's.

    `changed` are the cells whose runs are not the paper's, by the names under which they were run.
    """

    reading: Reading
    claims: tuple[Claim, ...]
    evidence: Evidence
    changed: dict[Cell, Cell]
    weighed: dict[int, Weighed | None] = field(default_factory=dict, compare=False, repr=False)

    def outcome(self, position: int) -> Weighed | None:
        """Return what becomes of the claim at a position, found once; None where it is not run."""
        if position not in self.weighed:
            found = judged(self.claims[position], self.evidence, reading=self.reading)
            self.weighed[position] = found[1]
        return self.weighed[position]


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """What is said of one printed number or sentence; numbers are in the printed unit.

    Findings of one `group` count once, those of none are not counted. `turns_on` names readings
    and settings that turn the verdict, which `as_run` was without them; `unseen` is the factor by
    which a consistent number could be off.
    """

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
    group: str | None = None
    unseen: Unseen | None = None
    as_run: Verdict | None = None
    as_run_side: str | None = None
    turns_on: tuple[str, ...] = ()
    readings: tuple[ReadingOutcome, ...] = ()


def findings_of(
    claims: Sequence[Claim], evidence: Evidence, others: Sequence[EvidenceUnder] = ()
) -> tuple[Finding, ...]:
    """Return one finding per claim, in the order of declaration.

    Every number that is run is judged under every reading that bears on it, too.
    """
    return tuple(
        _under_all(position, claim, evidence, others) for position, claim in enumerate(claims)
    )


def bears(position: int, own: Claim, other: EvidenceUnder) -> bool:
    """Return whether a reading makes anything else of the claim at that position."""
    claim = other.claims[position]
    cells = claim.measure.cells() if claim.measure else ()
    return claim is not own or not other.changed.keys().isdisjoint(cells)


def outcomes_under(
    position: int, claim: Claim, others: Iterable[EvidenceUnder]
) -> Iterator[tuple[EvidenceUnder, Weighed]]:
    """Yield what becomes of the claim at a position under each reading that bears on it."""
    for other in others:
        if bears(position, claim, other) and (found := other.outcome(position)):
            yield other, found


def _under_all(
    position: int, claim: Claim, evidence: Evidence, others: Sequence[EvidenceUnder]
) -> Finding:
    own, outcome = judged(claim, evidence)
    if outcome is None:
        return own
    outcomes = [found for _, found in outcomes_under(position, claim, others)]
    turns_on = turned(outcome, outcomes)
    shown = tuple(other.shown for other in outcomes)
    if not turns_on:
        return replace(own, readings=shown)
    return replace(
        own, verdict=Verdict.DEPENDS, side=None, unseen=None, turns_on=turns_on, readings=shown
    )


def judged(
    claim: Claim, evidence: Evidence, *, reading: Reading | None = None
) -> tuple[Finding, Weighed | None]:
    """Return what is said of one claim, and how sure that is; None where nothing is measured."""
    if claim.gap or claim.measure is None:
        why = claim.gap.because if claim.gap else ""
        return _unsaid(claim, Verdict.NOT_REPRODUCIBLE, note=why), None
    absent = [cell for cell in claim.measure.cells() if cell not in evidence.runs]
    if absent:
        names = ", ".join("/".join(cell) for cell in absent)
        return _unsaid(claim, Verdict.NOT_RUN, note=f"no whole repeat of {names}"), None
    measured = claim.measure.measure(evidence)
    interval = _interval(claim, measured)
    found = _found(claim, measured, interval)
    shown = ReadingOutcome(
        reading=reading.name if reading else "",
        verdict=found.verdict,
        side=found.side,
        measured=interval,
        repeats=measured.repeats,
    )
    return found, Weighed(shown=shown, reading=reading, p=_p_value(claim, measured))


def _found(claim: Claim, measured: Measured, interval: Interval) -> Finding:
    accepted = claim.accepted.band(claim.printed)
    verdict, side = verdict_of(interval, _printed(claim), accepted)
    note = PROVISIONAL if measured.repeats == 1 else ""
    if measured.repeats == 1 and measured.thin and verdict is Verdict.CONTRADICTED:
        verdict, side, note = Verdict.UNDECIDED, None, THIN
    minimum = claim.accepted.minimum if isinstance(claim.accepted, FromMinimum) else 0.0
    consistent = verdict is Verdict.CONSISTENT
    return replace(
        _unsaid(claim, verdict, note=note),
        measured=interval,
        value=measured.value / UNITS[claim.printed.unit],
        side=side,
        quantile=_quantile(claim, measured) if measured.repeats and not _in_words(claim) else None,
        repeats=measured.repeats,
        as_run=verdict,
        as_run_side=side,
        unseen=unseen(interval, claim.printed.value, minimum) if consistent else None,
    )


def _in_words(claim: Claim) -> bool:
    return not isinstance(claim, CellClaim) and claim.in_words


def _printed(claim: Claim) -> Interval:
    """Return the number with its rounding; of a sentence without one, all that it accepts."""
    if _in_words(claim):
        return claim.accepted.band(claim.printed)
    return rounded(claim.printed, claim.accepted)


def _interval(claim: Claim, measured: Measured) -> Interval:
    """Return the central interval of the draws, in the printed unit."""
    low, high = quantile_interval(measured.draws, LEVEL)
    factor = UNITS[claim.printed.unit]
    return low / factor, high / factor


def _p_value(claim: Claim, measured: Measured) -> float:
    """Return the two-sided chance of a table that is in the accepted band or beyond it."""
    low, high = (end * UNITS[claim.printed.unit] for end in claim.accepted.band(claim.printed))
    shares = (measured.draws >= low).mean(), (measured.draws <= high).mean()
    return min(1.0, 2.0 * float(min(shares)))


def _quantile(claim: Claim, measured: Measured) -> float:
    """Return the share of tables below the printed value, ties counted as half."""
    printed = claim.printed.si
    below = (measured.draws < printed).mean()
    return float(below + 0.5 * (measured.draws == printed).mean())


def _unsaid(claim: Claim, verdict: Verdict, *, note: str = "") -> Finding:
    """Return a finding that names the claim and measures nothing."""
    table, row, column = claim.place or (None, None, None)
    sentence = None if isinstance(claim, CellClaim) else claim.claim
    own = claim.group or sentence or ", ".join(claim.place or ())
    return Finding(
        table=table,
        row=row,
        column=column,
        claim=sentence,
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
        group=own if claim.counts else None,
    )
