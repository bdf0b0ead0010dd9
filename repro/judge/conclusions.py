"""What a paper's evidence comes to, as numbers: every sentence at the head of a page is made of it.

Each conclusion names where its evidence is: a finding by its position, a certificate by its
problem, an experiment, a row of the audit by its position.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from repro.judge.counting import counts
from repro.judge.judgement import Judgement
from repro.judge.one_sided import OneSided, one_sided
from repro.judge.ordinary import OffCentre, Ordinary, off_centre, ordinary
from repro.judge.proposed import FirstPlaces, Rival, first_places, rivals_in_time
from repro.judge.proved_times import ProvedTime, proved_times
from repro.judge.verdict import Verdict
from repro.tables.rows import AuditRow, Grade

MOST_SAID = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Scored:
    """How many results of a paper have each verdict, by the runs of so many repeats.

    `runs_asked` says whether anything was to be run; `not_rerun` names proposed algorithms that are
    not, each with the reason.
    """

    counts: Mapping[str, int]
    results: int
    repeats: int
    runs_asked: bool
    not_rerun: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Impossible:
    """What no runs give: rows of the audit under no condition, and those under one that is said.

    `proofs` are positions of the rows, `numbers` the printed numbers that they concern; `audited`
    says whether there was any number to audit, `others` counts places that disagree with others.
    """

    proofs: tuple[int, ...]
    numbers: int
    conditional: tuple[int, ...]
    others: int
    audited: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Conclusions:
    """Everything that is concluded of a paper; `said` names what its first sentences say."""

    times: tuple[ProvedTime, ...]
    rivals: tuple[Rival, ...]
    firsts: tuple[FirstPlaces, ...]
    tally: Scored
    impossible: Impossible
    one_sided: tuple[OneSided, ...]
    ordinary: tuple[Ordinary, ...]
    off_centre: tuple[OffCentre, ...]
    said: tuple[str, ...] = ()


def conclude(judgement: Judgement) -> Conclusions:
    """Return what the evidence of a paper comes to."""
    found = Conclusions(
        times=proved_times(judgement),
        rivals=rivals_in_time(judgement),
        firsts=first_places(judgement),
        tally=_tally(judgement),
        impossible=_impossible(judgement),
        one_sided=one_sided(judgement.findings),
        ordinary=ordinary(judgement),
        off_centre=off_centre(judgement),
    )
    return replace(found, said=tuple(_said(found))[:MOST_SAID])


def _said(found: Conclusions) -> Iterator[str]:
    """Yield what is said, the most telling first: of a time, of the rival, of what cannot be."""
    tally, impossible = found.tally, found.impossible
    forbidden = bool(impossible.proofs or impossible.conditional)
    yield "times" if found.times else "tally"
    if found.rivals:
        yield "rivals"
    elif found.firsts:
        yield "firsts"
    if forbidden:
        yield "impossible"
    if found.times and (tally.results or tally.not_rerun):
        yield "tally"
    if found.rivals and found.firsts:
        yield "firsts"
    if impossible.audited and not forbidden:
        yield "impossible"


def _tally(judgement: Judgement) -> Scored:
    paper = judgement.paper
    counted = counts((finding.group, finding.verdict) for finding in judgement.findings)
    absent = {
        each.proposed: each.left_out[each.proposed].because
        for each in paper.experiments
        if not each.runs_proposed and each.proposed in each.left_out
    }
    return Scored(
        counts={str(verdict): counted[verdict] for verdict in Verdict if counted[verdict]},
        results=sum(counted.values()),
        repeats=judgement.repeats,
        runs_asked=bool(paper.experiments),
        not_rerun=tuple(absent.items()),
    )


def _impossible(judgement: Judgement) -> Impossible:
    rows = list(enumerate(judgement.audit))
    proofs = [(k, row) for k, row in rows if row.is_proof]
    places = {place for k, row in proofs for place in _places(k, row)}
    return Impossible(
        proofs=tuple(k for k, _ in proofs),
        numbers=len(places),
        conditional=tuple(
            k for k, row in rows if row.grade is Grade.IMPOSSIBLE and not row.is_proof
        ),
        others=sum(row.grade is Grade.INCONSISTENT for _, row in rows),
        audited=bool(judgement.paper.results or judgement.paper.audited),
    )


def _places(position: int, row: AuditRow) -> list[tuple[str, str, str]]:
    """Return the printed numbers that a row concerns; of the text, the row itself."""
    if row.cells:
        return [(row.table, cell["row"], cell["column"]) for cell in row.cells]
    return [(row.table, row.row or f"{position}", row.column or "")]
