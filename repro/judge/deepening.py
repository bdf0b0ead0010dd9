"""Runs of other readings are made deeper where they seem to turn a verdict."""

from collections.abc import Callable, Iterator, Mapping, Sequence

from repro.judge.findings import EvidenceUnder, judged, outcomes_under
from repro.judge.other_readings import evidence_under_readings
from repro.judge.turning import seeming
from repro.model.claims import Claim
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.paper import Paper

SHARE = 0.2
"""Of the evaluations of all other runs: what deepening may cost, and so less than a quarter of the
time. Evaluations decide and not seconds, so that every machine makes the same runs."""

Fetch = Callable[[Mapping[Cell, int]], Mapping[Cell, Runs]]
"""What gives so many repeats of each cell, as far as they are to be had."""


def deepened(
    paper: Paper, evidence: Evidence, fetch: Fetch
) -> tuple[Evidence, tuple[EvidenceUnder, ...]]:
    """Return the evidence, and that under each reading, once no more runs are wanted or given."""
    left = SHARE * sum(map(_evaluations, evidence.runs.values()))
    others = evidence_under_readings(paper, evidence)
    while wanted := _deeper(paper.said, evidence, others, left):
        more = {
            cell: runs
            for cell, runs in fetch(wanted).items()
            if len(runs.costs) > len(evidence.runs[cell].costs)
        }
        if not more:
            break
        left -= sum(_evaluations(more[cell]) - _evaluations(evidence.runs[cell]) for cell in more)
        evidence = evidence.deeper(more)
        others = evidence_under_readings(paper, evidence, before=others, grown=more.keys())
    return evidence, others


def _evaluations(runs: Runs) -> int:
    return runs.costs.size * runs.evaluations


def _deeper(
    claims: Sequence[Claim], evidence: Evidence, others: Sequence[EvidenceUnder], left: float
) -> dict[Cell, int]:
    """Return how many repeats to make of which cells of readings: twice those that there are.

    They are the cells under a reading that seems to turn a verdict, down to the depth of the
    paper's own. The cheapest come first; what costs more than is `left` of the budget is passed
    over.
    """
    wanted = dict(_wanted(claims, evidence, others))
    costs = {cell: _more(evidence.runs[cell], depth) for cell, depth in wanted.items()}
    chosen: dict[Cell, int] = {}
    for cell in sorted(wanted, key=lambda cell: (costs[cell], cell)):
        if costs[cell] <= left:
            chosen[cell] = wanted[cell]
            left -= costs[cell]
    return chosen


def _more(runs: Runs, depth: int) -> int:
    """Return the evaluations of the repeats that are missing to a depth."""
    return int((depth - len(runs.costs)) * runs.costs.shape[-1] * runs.evaluations)


def _wanted(
    claims: Sequence[Claim], evidence: Evidence, others: Sequence[EvidenceUnder]
) -> Iterator[tuple[Cell, int]]:
    """Return cells, by the names under which they were run, and the depth that each should have."""
    for position, claim in enumerate(claims):
        own = judged(claim, evidence)[1]
        under = list(outcomes_under(position, claim, others)) if own else []
        doubtful = seeming(own, [outcome for _, outcome in under]) if own else ()
        for other, outcome in under:
            if own and outcome in doubtful:
                yield from _twice(position, other, evidence, own.shown.repeats)


def _twice(
    position: int, other: EvidenceUnder, evidence: Evidence, full: int
) -> Iterator[tuple[Cell, int]]:
    measure = other.claims[position].measure
    for cell in measure.cells() if measure else ():
        run_as = other.changed.get(cell)
        made = len(evidence.runs[run_as].costs) if run_as else full
        if run_as and made < full:
            yield run_as, min(2 * made, full)
