"""Where a user's search stands in one experiment of a paper, beside what is printed and run."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

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
from repro.runs.honesty import Warned
from repro.statistics.effect_size import win_probability
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.tables.published import Printed

EVEN = 0.5  # chance to win of two searches that are alike


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
    name: str | Sequence[str],
    against: Sequence[str] = (),
) -> UsersSearch:
    """Return where searches of these names stand, as far as they and the others were run.

    `against` are the others that are wanted; all where it is empty. One alone has no rank.
    """
    names = (name,) if isinstance(name, str) else tuple(name)
    cells = {cell: r for cell, r in runs.items() if not against or cell[2] in (*names, *against)}
    found = experiment_standings(experiment, cells, certificates, yours=names)
    found = replace(found, problems=tuple(map(_unranked_alone, found.problems)))
    return UsersSearch(
        standings=found,
        printed={p: printed_means(paper, experiment.name, p) for p in experiment.problems},
        tests=_tests(found.problems),
    )


def _unranked_alone(standing: ProblemStandings) -> ProblemStandings:
    """Return a standing without the rank of one alone, which says nothing."""
    if sum(row.rank is not None for row in standing.rows) != 1:
        return standing
    return replace(standing, rows=tuple(replace(row, rank=None) for row in standing.rows))


def mean_against_chance(test: UsersTest) -> bool:
    """Return whether the lower mean belongs to the search that seldom ends lower."""
    gap = test.own.mean - test.other.mean
    return (gap < 0.0 and test.wins < EVEN) or (gap > 0.0 and test.wins > EVEN)


def chance_warnings(found: Iterable[UsersSearch]) -> list[Warned]:
    """Return a warning for each pair on a problem that mean and chance to win order differently."""
    return [
        Warned(
            kind="mean against chance",
            says=f"{each.standings.experiment.name}/{test.problem}: by mean {test.own.algorithm} "
            f"({test.own.mean:.4g}) stands {_side(test)} {test.other.algorithm} "
            f"({test.other.mean:.4g}), and yet a run of it ends lower with chance {test.wins:.2f}",
        )
        for each in found
        for test in each.tests
        if mean_against_chance(test)
    ]


def _side(test: UsersTest) -> str:
    return "before" if test.own.mean < test.other.mean else "behind"


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
        if own.kind == "yours" and (other.kind != "yours" or own.algorithm < other.algorithm)
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
