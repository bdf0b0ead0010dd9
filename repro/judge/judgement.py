"""Everything that is concluded of one paper, as data: no text of a page, no file, no figure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from repro.audit import AuditRow, audit
from repro.judge.beside_baselines import ExperimentStandings, paper_standings
from repro.judge.centre_bias import CentreBias, centre_biases
from repro.judge.certificates import Certificate, certify
from repro.judge.deepening import Fetch, deepened
from repro.judge.findings import EvidenceUnder, Finding, findings_of
from repro.judge.other_readings import Print, fingerprints
from repro.judge.outside_box import OutsideBox, outside_boxes
from repro.judge.rank_tests import AlgorithmTests, algorithm_tests
from repro.judge.times_found import FoundTime, found_times
from repro.model.evidence import Evidence
from repro.model.paper import Paper
from repro.runs.raw_runs import RawCell
from repro.runs.studies import Study, kinds_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Judgement:
    """A paper, the evidence, and what follows from both.

    `findings` are those of its claims, in their order; `readings` the evidence under each other
    reading that was run, `prints` how near the columns are to each; `found_times` stand beside
    `certificates`. `besides` says in words what was run besides the protocol, other readings in
    `reading_repeats` repeats; `outside` are the searches that their source lets leave the box;
    `runs` is every finished run that was read, and `drawn_as` names the experiments that draw the
    random numbers of another.
    """

    paper: Paper
    evidence: Evidence
    findings: tuple[Finding, ...]
    readings: tuple[EvidenceUnder, ...]
    prints: tuple[Print, ...]
    audit: tuple[AuditRow, ...]
    certificates: tuple[Certificate, ...]
    found_times: tuple[tuple[FoundTime, ...], ...]
    tests: tuple[AlgorithmTests, ...]
    centre_biases: tuple[CentreBias, ...]
    standings: tuple[ExperimentStandings, ...]
    besides: tuple[str, ...] = ()
    reading_repeats: int = 0
    outside: tuple[OutsideBox, ...] = ()
    runs: tuple[RawCell, ...] = ()
    drawn_as: Mapping[str, str] = field(default_factory=dict)

    @property
    def repeats(self) -> int:
        """The most whole repeats of the protocol that any cell has."""
        return max((len(cell.costs) for cell in self.evidence.runs.values()), default=0)


def judge(
    paper: Paper,
    evidence: Evidence,
    studies: Sequence[Study] = (),
    fetch: Fetch = lambda _: {},
) -> Judgement:
    """Return what the evidence says of the paper; `studies` are what was to be run besides.

    `fetch` gives more runs of readings that seem to turn a verdict.
    """
    evidence, readings = deepened(paper, evidence, fetch)
    certificates = certify(paper)
    return Judgement(
        paper=paper,
        evidence=evidence,
        findings=findings_of(paper.said, evidence, readings),
        readings=readings,
        prints=fingerprints(paper.claims, evidence, readings),
        audit=audit(paper),
        certificates=certificates,
        found_times=tuple(found_times(certificate, evidence) for certificate in certificates),
        tests=algorithm_tests(paper, evidence),
        centre_biases=centre_biases(paper, evidence),
        standings=paper_standings(paper, evidence.runs, certificates),
        besides=kinds_of(studies, {name for name, *_ in evidence.runs}),
        outside=outside_boxes(paper, evidence),
        reading_repeats=max((s.repeats for s in studies if s.kind == "reading"), default=0),
    )
