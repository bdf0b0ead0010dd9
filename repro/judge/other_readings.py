"""What the runs under other readings of a paper say of its numbers."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from repro.judge.findings import EvidenceUnder
from repro.model.claims import CellClaim, Claim
from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.runs.readings import Reading, applied, changed_part, claims_under, readings
from repro.runs.studies import study_name
from repro.tables.published import UNITS

FARTHEST = 400.0  # decades: farther than any two positive doubles, for a 0 against a number
AS_CHOSEN = "as chosen"


def evidence_under_readings(
    paper: Paper,
    evidence: Evidence,
    *,
    before: Sequence[EvidenceUnder] = (),
    grown: Collection[Cell] = (),
) -> tuple[EvidenceUnder, ...]:
    """Return the evidence under each reading of the paper whose runs are all there.

    What was found `before` stays where none of its cells is among those that have `grown`.
    """
    kept = {
        under.reading.name: under
        for under in before
        if not any(cell in grown for cell in under.changed.values())
    }
    found = (
        kept.get(reading.name) or _under(paper, evidence, reading) for reading in readings(paper)
    )
    return tuple(under for under in found if under)


def _under(paper: Paper, evidence: Evidence, reading: Reading) -> EvidenceUnder | None:
    experiments = []
    changed: dict[Cell, Cell] = {}
    for experiment in paper.experiments:
        part = changed_part(experiment, reading)
        if part is None:
            continue
        experiments.append(applied(experiment, reading))
        for problem in part.problems:
            for algorithm in part.algorithms:
                touching = reading.touching(experiment.name, problem, algorithm)
                if not touching.alternatives:
                    continue
                name = study_name(experiment.name, touching.name)
                if (name, problem, algorithm) not in evidence.runs:
                    return None
                changed[experiment.name, problem, algorithm] = name, problem, algorithm
    runs = {cell: evidence.runs[run_as] for cell, run_as in changed.items()}
    return EvidenceUnder(
        reading=reading,
        claims=claims_under(paper, reading),
        evidence=evidence.under(experiments, runs),
        changed=changed,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Print:
    """How far a printed column is from the re-run under each reading, nearest first.

    A distance is the mean of |log10(measured / printed)| over the numbers of the column, in
    decades. `chosen` is that of the reading that the re-run follows, `lower` how many numbers the
    first repeat of the re-run comes out below.
    """

    table: str
    column: str
    numbers: int
    chosen: float
    lower: int
    others: tuple[tuple[str, float], ...]

    @property
    def nearest(self) -> str:
        """The reading that comes nearest to the column."""
        if self.others and self.others[0][1] < self.chosen:
            return self.others[0][0]
        return AS_CHOSEN


def fingerprints(
    claims: Sequence[Claim], evidence: Evidence, others: Sequence[EvidenceUnder]
) -> tuple[Print, ...]:
    """Return the distance of each printed column of measured numbers under each reading.

    No reading is chosen because it is near.
    """
    columns: dict[tuple[str, str], list[int]] = {}
    for position, claim in enumerate(claims):
        if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic) and not claim.gap:
            columns.setdefault((claim.table.label, claim.column), []).append(position)
    found = []
    for (table, column), positions in columns.items():
        own = [claims[position] for position in positions]
        chosen = _distance(own, evidence)
        distances = [
            (other.reading.name, _distance([other.claims[p] for p in positions], other.evidence))
            for other in others
            if any(_cells(other.claims[p]) & other.changed.keys() for p in positions)
        ]
        found.append(
            Print(
                table=table,
                column=column,
                numbers=len(positions),
                chosen=chosen,
                lower=sum(_lower(claim, evidence) for claim in own),
                others=tuple(sorted(distances, key=lambda pair: pair[1])),
            )
        )
    return tuple(found)


def _lower(claim: Claim, evidence: Evidence) -> bool:
    if claim.measure is None or not _cells(claim) <= evidence.runs.keys():
        return False
    return claim.measure.measure(evidence).value < claim.printed.si


def _cells(claim: Claim) -> frozenset[Cell]:
    return frozenset(claim.measure.cells() if claim.measure else ())


def _distance(claims: Sequence[Claim], evidence: Evidence) -> float:
    """Return the mean distance in decades; nan where a cell was not run."""
    return float(np.mean([_decades(claim, evidence) for claim in claims]))


def _decades(claim: Claim, evidence: Evidence) -> float:
    if claim.measure is None or not _cells(claim) <= evidence.runs.keys():
        return float("nan")
    median = float(np.median(claim.measure.measure(evidence).draws)) / UNITS[claim.printed.unit]
    printed = claim.printed.value
    if median == printed:
        return 0.0
    if np.sign(median) != np.sign(printed):
        return FARTHEST
    return float(min(abs(np.log10(abs(median)) - np.log10(abs(printed))), FARTHEST))
