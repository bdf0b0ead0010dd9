"""The proposed algorithm against its rivals: by how much it is better, in print and in the runs."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from repro.judge.by_print import by_print, printed_evidence
from repro.judge.findings import LEVEL
from repro.judge.judgement import Judgement
from repro.judge.proved_times import printed_times
from repro.judge.rank_tests import AlgorithmTests
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.model.measures import ranks as rank_tests
from repro.model.measures.measure import Rank, Reduction, Statistic
from repro.model.tolerances import Interval
from repro.statistics.places import place
from repro.statistics.summary import mean
from repro.statistics.tables import quantile_interval


@dataclass(frozen=True, slots=True, kw_only=True)
class Rival:
    """By how many percent a motion of the proposed algorithm is shorter than its nearest rival's.

    The rival is the one with the least printed time. `printed` is what the printed times come to;
    `value` and `interval` what the runs give. `evaluations` are those of a run of the proposed
    algorithm and of the rival. `wins` is the chance that a run of the proposed one ends lower.
    `finding` is the position of a claim that measures the same, `cell` that of the printed time.
    """

    experiment: str
    problem: str
    proposed: str
    other: str
    printed: float | None
    value: float
    interval: Interval
    repeats: int
    evaluations: tuple[int, int]
    wins: float | None
    finding: int | None
    cell: int


@dataclass(frozen=True, slots=True, kw_only=True)
class FirstPlaces:
    """On how many problems the proposed algorithm has the lowest mean cost of all that are run.

    `printed` is how many by the printed means, `value` in the first repeat, `interval` the fewest
    and the most of any repeat. Of `pairs` rank-sum tests against the others it ends lower in `wins`
    and higher in `losses` at the 5 % level by Holm. `evaluations` are those of a run of its own,
    and the most of any other.
    """

    experiment: str
    proposed: str
    algorithms: int
    problems: int
    printed: int | None
    value: int
    interval: tuple[int, int]
    repeats: int
    wins: int
    losses: int
    pairs: int
    evaluations: tuple[int, int]


def rivals_in_time(judgement: Judgement) -> tuple[Rival, ...]:
    """Return the comparison of each motion whose printed times tell the proposed from another."""
    return tuple(_rivals(judgement))


def _rivals(judgement: Judgement) -> Iterator[Rival]:
    printed = printed_evidence(judgement.paper)
    for tests in judgement.tests:
        experiment = tests.experiment
        for problem in experiment.problems:
            times = printed_times(judgement, experiment.name, problem)
            of: dict[str, tuple[int, Statistic]] = {}
            for position, claim in sorted(times, key=lambda each: each[1].printed.si):
                if isinstance(claim.measure, Statistic):
                    of.setdefault(claim.measure.algorithm, (position, claim.measure))
            cell, after = of.pop(experiment.proposed, (0, None))
            before = next((each for name, (_, each) in of.items() if name in tests.others), None)
            if after and before:
                rival = _rival(judgement, tests, (before, after), printed)
                yield replace(rival, cell=cell)


def _rival(
    judgement: Judgement,
    tests: AlgorithmTests,
    pair: tuple[Statistic, Statistic],
    printed: Evidence,
) -> Rival:
    before, after = pair
    reduction = Reduction(before=before, after=after)
    measured = reduction.measure(judgement.evidence)
    claims = enumerate(judgement.paper.said)
    return Rival(
        experiment=tests.experiment.name,
        problem=after.problem,
        proposed=after.algorithm,
        other=before.algorithm,
        printed=by_print(reduction, printed),
        value=measured.value,
        interval=quantile_interval(measured.draws, LEVEL),
        repeats=measured.repeats,
        evaluations=(tests.budgets[after.algorithm], tests.budgets[before.algorithm]),
        wins=next((t.wins for t in tests.tests
                   if (t.problem, t.against) == (after.problem, before.algorithm)), None),
        cell=0,
        finding=next((k for k, claim in claims if claim.measure == reduction), None),
    )  # fmt: skip


def first_places(judgement: Judgement) -> tuple[FirstPlaces, ...]:
    """Return how often the proposed algorithm is first, of each experiment where it has rivals."""
    printed = printed_evidence(judgement.paper)
    return tuple(
        _firsts(tests, judgement.evidence, printed) for tests in judgement.tests if tests.others
    )


def _firsts(tests: AlgorithmTests, evidence: Evidence, printed: Evidence) -> FirstPlaces:
    experiment = tests.experiment
    found = _first_by_repeat(experiment, evidence)
    ranks = [_printed_rank(experiment, problem, printed) for problem in experiment.problems]
    sure = [test for test in tests.tests if test.holm < rank_tests.LEVEL]
    return FirstPlaces(
        experiment=experiment.name,
        proposed=experiment.proposed,
        algorithms=len(experiment.algorithms),
        problems=len(experiment.problems),
        printed=sum(rank == 1 for rank in ranks) if None not in ranks else None,
        value=int(found[0]),
        interval=(int(found.min()), int(found.max())),
        repeats=len(found),
        wins=sum(test.wins > 0.5 for test in sure),
        losses=sum(test.wins < 0.5 for test in sure),
        pairs=len(tests.tests),
        evaluations=(
            tests.budgets[experiment.proposed],
            max(tests.budgets[name] for name in tests.others),
        ),
    )


def _first_by_repeat(experiment: Experiment, evidence: Evidence) -> NDArray[np.int64]:
    """Return on how many problems the proposed algorithm is first, of each repeat that all have."""
    names = tuple(experiment.algorithms)
    own = names.index(experiment.proposed)
    first = []
    for problem in experiment.problems:
        costs = [evidence.values((experiment.name, problem, name)) for name in names]
        common = min(map(len, costs))
        first.append(place([mean(each[:common]) for each in costs], own, "min") == 1)
    common = min(map(len, first))
    return np.asarray(np.sum([each[:common] for each in first], axis=0))


def _printed_rank(experiment: Experiment, problem: str, printed: Evidence) -> float | None:
    of = Statistic(
        experiment=experiment.name,
        problem=problem,
        algorithm=experiment.proposed,
        statistic="mean",
    )
    return by_print(Rank(of=of, among=tuple(experiment.algorithms)), printed)
