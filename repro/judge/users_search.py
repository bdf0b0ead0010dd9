"""Where a user's search stands in one experiment of a paper, beside what is printed and run."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from repro.judge.beside_baselines import (
    ExperimentStandings,
    ProblemStandings,
    Standing,
    experiment_standings,
)
from repro.judge.certificates import Certificate
from repro.model.claims import CellClaim
from repro.model.evidence import Cell, Runs
from repro.model.experiment import Experiment
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.statistics.effect_size import win_probability
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.tables.published import Printed


@dataclass(frozen=True, slots=True, kw_only=True)
class UsersTest:
    """The rank-sum test of the user's search against another; Holm over the experiment."""

    problem: str
    own: Standing
    other: Standing
    p: float
    holm: float
    wins: float


@dataclass(frozen=True, slots=True, kw_only=True)
class UsersSearch:
    """The user's search in one experiment: standings, tests, and what the paper prints.

    `printed` holds, by problem, the printed mean of each algorithm.
    """

    standings: ExperimentStandings
    printed: Mapping[str, Mapping[str, Printed]]
    tests: tuple[UsersTest, ...]


def users_search(
    paper: Paper,
    experiment: Experiment,
    runs: Mapping[Cell, Runs],
    certificates: Sequence[Certificate],
    *,
    name: str,
) -> UsersSearch:
    """Return where the search of that name stands, as far as it and the others were run."""
    found = experiment_standings(experiment, runs, certificates, yours=(name,))
    return UsersSearch(
        standings=found,
        printed={p: printed_means(paper, experiment.name, p) for p in experiment.problems},
        tests=_tests(found.problems),
    )


def printed_means(paper: Paper, experiment: str, problem: str) -> Mapping[str, Printed]:
    """Return the mean, or only, cost or time that the paper prints, by algorithm."""
    found = {}
    for claim in paper.claims:
        measure = claim.measure
        if (
            isinstance(claim, CellClaim)
            and isinstance(measure, Statistic)
            and measure.cell[:2] == (experiment, problem)
            and measure.statistic in ("mean", "single")
            and measure.quantity in ("cost", "total")
        ):
            found[measure.algorithm] = claim.printed
    return found


def _tests(problems: Sequence[ProblemStandings]) -> tuple[UsersTest, ...]:
    pairs = [
        (standing.problem, own, other)
        for standing in problems
        for own in standing.rows
        for other in standing.rows
        if own.kind == "yours" and other.kind != "yours"
    ]
    p_values = np.array([rank_sum_p(own.costs, other.costs) for _, own, other in pairs])
    return tuple(
        UsersTest(
            problem=problem,
            own=own,
            other=other,
            p=float(p),
            holm=float(corrected),
            wins=win_probability(own.costs, other.costs),
        )
        for (problem, own, other), p, corrected in zip(pairs, p_values, holm(p_values), strict=True)
    )
