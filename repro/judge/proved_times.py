"""Printed times beside what is proved of them: whether they can be had, and what is the least."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from repro.judge.certificates import Certificate
from repro.judge.judgement import Judgement
from repro.judge.times_found import ROUNDING
from repro.model.claims import Claim
from repro.model.experiment import Experiment
from repro.model.measures.measure import Statistic
from repro.model.tolerances import Interval
from repro.tables.published import UNITS

TOTAL = "total"  # what a motion calls its whole time


@dataclass(frozen=True, slots=True, kw_only=True)
class ProvedTime:
    """What is proved of one motion, beside the time that is printed of it; all times in s.

    `printed` is that of the proposed algorithm where there is one, else the least; it stands at
    position `finding`. `least` is the proved minimum under the printed limits, None where only a
    `bound` is known; `readings` are the minima under other readings of the motion. `attainable`
    says whether the printed time can be had, None where that is not decided or none is printed.
    `measured` is the interval of the re-run.
    """

    experiment: str
    problem: str
    certificate: str
    least: float | None
    bound: float | None
    readings: tuple[float, ...]
    algorithm: str = ""
    printed: float | None = None
    finding: int | None = None
    attainable: bool | None = None
    measured: Interval | None = None
    repeats: int = 0


def proved_times(judgement: Judgement) -> tuple[ProvedTime, ...]:
    """Return what is proved of each motion of the paper that has a bound."""
    return tuple(_proved_times(judgement))


def _proved_times(judgement: Judgement) -> Iterator[ProvedTime]:
    by_label = {each.problem: each for each in judgement.certificates}
    for experiment in judgement.paper.experiments:
        for problem in experiment.problems:
            label = f"{experiment.name}/{problem}"
            own = by_label.get(label)
            if own is not None and (own.minimum or own.lower_bound):
                others = [
                    c.minimum for c in by_label.values() if c.problem.startswith(f"{label}, ")
                ]
                proved = ProvedTime(
                    experiment=experiment.name,
                    problem=problem,
                    certificate=label,
                    least=own.minimum,
                    bound=own.lower_bound,
                    readings=tuple(sorted(each for each in others if each)),
                )
                yield _with_printed(judgement, experiment, own, proved)


def _with_printed(
    judgement: Judgement, experiment: Experiment, own: Certificate, proved: ProvedTime
) -> ProvedTime:
    times = printed_times(judgement, experiment.name, proved.problem)
    if not times:
        return proved
    position, claim = min(times, key=lambda each: _rank(experiment, each[1]))
    finding = judgement.findings[position]
    factor = UNITS[claim.printed.unit] / UNITS["s"]
    highest = (claim.printed.value + claim.printed.rounding) * factor
    attainable = own.minimum is not None and own.minimum * (1.0 - ROUNDING) <= highest
    excluded = own.lower_bound is not None and highest < own.lower_bound * (1.0 - ROUNDING)
    low, high = finding.measured or (0.0, 0.0)
    return replace(
        proved,
        algorithm=algorithm_of(claim),
        printed=claim.printed.value * factor,
        finding=position,
        attainable=attainable if attainable or excluded else None,
        measured=(low * factor, high * factor) if finding.measured else None,
        repeats=finding.repeats,
    )


def printed_times(judgement: Judgement, experiment: str, problem: str) -> list[tuple[int, Claim]]:
    """Return the claims that print a whole time of a motion, those of tables first, none twice."""
    found = [
        (position, claim)
        for position, claim in enumerate(judgement.paper.said)
        if isinstance(claim.measure, Statistic)
        and claim.measure.cell[:2] == (experiment, problem)
        and claim.measure.quantity == TOTAL
    ]
    first: dict[tuple[str, float], tuple[int, Claim]] = {}
    for position, claim in sorted(found, key=lambda each: each[1].place is None):
        first.setdefault((algorithm_of(claim), claim.printed.si), (position, claim))
    return list(first.values())


def algorithm_of(claim: Claim) -> str:
    """Return the algorithm whose statistic a claim prints."""
    return claim.measure.algorithm if isinstance(claim.measure, Statistic) else ""


def _rank(experiment: Experiment, claim: Claim) -> tuple[bool, float]:
    """Order times: the proposed algorithm's come first, then the least."""
    return algorithm_of(claim) != experiment.proposed, claim.printed.si
