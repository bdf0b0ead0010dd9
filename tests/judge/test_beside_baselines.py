from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from repro.functions import FUNCTIONS
from repro.judge.beside_baselines import Standing, budget_rows, experiment_standings, mean_ranks
from repro.model.evidence import Cell, Runs
from repro.model.experiment import Experiment
from repro.optimisers import DE, WOA

EXPERIMENT = Experiment(
    name="search",
    where="p. 3",
    proposed="WOA",
    problems={
        "hump": FUNCTIONS["branin"].problem(),
        "ball": FUNCTIONS["sphere"].problem(dimension=2),
    },
    algorithms={"WOA": WOA(), "DE": DE()},
    population=10,
    iterations=20,
    runs=3,
)
EQUAL, BASELINES = "search [equal budget]", "search [compiled baselines]"


def runs(costs: Sequence[float], evaluations: int = 200) -> Runs:
    repeats = np.array([costs, np.add(costs, 100.0)])
    return Runs(
        costs=repeats,
        points=np.zeros((*repeats.shape, 2)),
        histories=repeats[..., None],
        evaluations=evaluations,
        seconds=0.25,
    )


def every_run() -> dict[Cell, Runs]:
    return {
        **{("search", p, "WOA"): runs([2.0, 3.0, 7.0]) for p in EXPERIMENT.problems},
        **{("search", p, "DE"): runs([1.0, 1.0, 1.0], 210) for p in EXPERIMENT.problems},
        **{(EQUAL, p, "DE"): runs([5.0, 5.0, 5.0]) for p in EXPERIMENT.problems},
        **{(BASELINES, p, "random search"): runs([9.0, 9.5]) for p in EXPERIMENT.problems},
    }


def ball(found: dict[Cell, Runs]) -> dict[tuple[str, str], Standing]:
    rows = experiment_standings(EXPERIMENT, found).problems[1].rows
    return {(row.algorithm, row.kind): row for row in rows}


def test_standing_is_that_of_the_first_repeat() -> None:
    row = ball(every_run())["WOA", "printed protocol"]

    assert (row.mean, row.median, row.evaluations, row.seconds) == (4.0, 3.0, 200, 0.25)
    assert row.distance == 4.0 - FUNCTIONS["sphere"].minimum


def test_rank_is_among_those_that_spend_the_same_budget() -> None:
    ranks = {place: row.rank for place, row in ball(every_run()).items()}

    assert ranks == {
        ("WOA", "printed protocol"): 1.0,
        ("DE", "printed protocol"): None,  # it would be first
        ("DE", "equal evaluations"): 2.0,
        ("random search", "baseline"): 3.0,
    }


def test_equal_means_share_their_rank() -> None:
    found = every_run() | {("search", "ball", "WOA"): runs([5.0, 5.0, 5.0])}

    ranks = {place: row.rank for place, row in ball(found).items()}

    assert ranks["WOA", "printed protocol"] == ranks["DE", "equal evaluations"] == 1.5


def test_what_was_not_run_is_left_out() -> None:
    assert experiment_standings(EXPERIMENT, {}).problems[0].rows == ()
    assert mean_ranks(experiment_standings(EXPERIMENT, {}).problems) == {}
    assert ball({("search", "ball", "WOA"): runs([1.0])}).keys() == {("WOA", "printed protocol")}


def test_mean_rank_needs_a_rank_on_every_problem() -> None:
    found = every_run()
    del found[BASELINES, "hump", "random search"]

    ranks = mean_ranks(experiment_standings(EXPERIMENT, found).problems)

    assert ranks == {("WOA", "printed protocol"): 1.0, ("DE", "equal evaluations"): 2.0}


def test_search_of_the_user_is_ranked_with_the_others() -> None:
    found = every_run() | {("search", "ball", "mine"): runs([0.5])}

    (_, problem) = experiment_standings(EXPERIMENT, found, yours=("mine",)).problems

    assert [(row.algorithm, row.rank) for row in problem.rows if row.kind == "yours"] == [
        ("mine", 1.0)
    ]


def test_ranking_as_printed_turns_at_equal_evaluations() -> None:
    rows = {row.algorithm: row for row in budget_rows(EXPERIMENT, every_run())}

    assert (rows["DE"].evaluations, rows["DE"].equal_evaluations) == (210, 200)
    assert (rows["DE"].rank, rows["DE"].equal_rank) == (1.0, 2.0)
    assert (rows["WOA"].rank, rows["WOA"].equal_rank) == (2.0, 1.0)


def test_rankings_are_not_compared_where_one_is_not_whole() -> None:
    found = every_run()
    del found[EQUAL, "hump", "DE"]

    assert budget_rows(EXPERIMENT, found) == ()
    assert budget_rows(replace(EXPERIMENT, algorithms={"WOA": WOA()}), every_run()) == ()
