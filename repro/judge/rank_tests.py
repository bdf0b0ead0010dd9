"""Tests of the proposed algorithm against the others, and ranks of all, on the first repeat."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from repro.determinism.seeds import generator
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.statistics.effect_size import win_interval, win_probability
from repro.statistics.friedman import Friedman, friedman
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.statistics.summary import mean


@dataclass(frozen=True, slots=True, kw_only=True)
class RankSumTest:
    """The proposed algorithm against another on one problem.

    `p` is two-sided, `holm` is corrected for all tests of the experiment; `wins` is the chance that
    a run of the proposed algorithm ends lower (A12), with its bootstrap `interval`.
    """

    problem: str
    against: str
    p: float
    holm: float
    wins: float
    interval: tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class AlgorithmTests:
    """Everything that is tested of the algorithms of one experiment.

    `budgets` are the evaluations of a run by algorithm. `friedman` ranks the algorithms, in their
    order, by mean cost, where there are three or more and two problems or more.
    """

    experiment: Experiment
    tests: tuple[RankSumTest, ...]
    budgets: Mapping[str, int]
    friedman: Friedman | None

    @property
    def others(self) -> tuple[str, ...]:
        """The algorithms that the proposed one is tested against; none where it is not run."""
        return rivals(self.experiment)


def rivals(experiment: Experiment) -> tuple[str, ...]:
    """Return the algorithms that the proposed one is tested against; none where it is not run."""
    own = experiment.proposed
    return tuple(name for name in experiment.algorithms if experiment.runs_proposed and name != own)


def algorithm_tests(paper: Paper, evidence: Evidence) -> tuple[AlgorithmTests, ...]:
    """Return the tests of every experiment of the paper whose runs are all there."""
    return tuple(
        _tests(experiment, evidence)
        for experiment in paper.experiments
        if all(
            (experiment.name, problem, algorithm) in evidence.runs
            for problem in experiment.problems
            for algorithm in experiment.algorithms
        )
    )


def _tests(experiment: Experiment, evidence: Evidence) -> AlgorithmTests:
    first = next(iter(experiment.problems))
    return AlgorithmTests(
        experiment=experiment,
        tests=_rank_sum_tests(experiment, evidence),
        budgets={
            name: evidence.runs[experiment.name, first, name].evaluations
            for name in experiment.algorithms
        },
        friedman=_friedman(experiment, evidence),
    )


def _rank_sum_tests(experiment: Experiment, evidence: Evidence) -> tuple[RankSumTest, ...]:
    pairs = [(problem, other) for problem in experiment.problems for other in rivals(experiment)]
    samples = [
        tuple(
            evidence.values((experiment.name, problem, name))[0]
            for name in (experiment.proposed, other)
        )
        for problem, other in pairs
    ]
    p_values = np.array([rank_sum_p(*sample) for sample in samples])
    return tuple(
        RankSumTest(
            problem=problem,
            against=other,
            p=float(p),
            holm=float(corrected),
            wins=win_probability(*sample),
            interval=win_interval(
                *sample, rng=generator("wins", evidence.key, experiment.name, problem, other)
            ),
        )
        for (problem, other), sample, p, corrected in zip(
            pairs, samples, p_values, holm(p_values), strict=True
        )
    )


def _friedman(experiment: Experiment, evidence: Evidence) -> Friedman | None:
    names = tuple(experiment.algorithms)
    if len(names) < 3 or len(experiment.problems) < 2:
        return None
    means = [
        [mean(evidence.values((experiment.name, problem, name))[0]) for name in names]
        for problem in experiment.problems
    ]
    return friedman(np.array(means))
