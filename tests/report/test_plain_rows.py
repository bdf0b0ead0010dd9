import json
from dataclasses import replace

import numpy as np
import pytest

from repro.judge.beside_baselines import (
    BudgetRow,
    ExperimentStandings,
    ProblemStandings,
    Standing,
)
from repro.judge.rank_tests import AlgorithmTests
from repro.report.plain_rows import rows_of_standings, rows_of_tests
from repro.statistics.friedman import Friedman
from tests.made_up import pages_of
from tests.small_papers import EXPERIMENT, Guessing


@pytest.fixture(scope="module")
def entry(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[dict[str, object]]]:
    found = json.loads(pages_of(tmp_path_factory.mktemp("doe"))["results.json"])["papers"][0]
    assert isinstance(found, dict)
    return found


def test_rows_of_tests_are_flat_and_have_the_same_names(
    entry: dict[str, list[dict[str, object]]],
) -> None:
    assert len({tuple(row) for row in entry["tests"]}) == 1
    assert not [v for row in entry["tests"] for v in row.values() if isinstance(v, list | dict)]


def test_each_rank_sum_test_has_its_p_values_and_the_chance_to_win_with_its_interval(
    entry: dict[str, list[dict[str, object]]],
) -> None:
    found = [row for row in entry["tests"] if row["test"] == "rank sum"]

    assert [
        (row["experiment"], row["problem"], row["algorithm"], row["against"]) for row in found
    ] == [
        ("test", "F1", "WOA", "PSO"),
        ("motion", "arm", "WOA", "PSO"),
    ]
    for row in found:
        low, wins, high, p, holm = (
            float(str(row[name])) for name in ("wins_low", "wins", "wins_high", "p", "holm")
        )
        assert 0.0 <= low <= wins <= high <= 1.0
        assert 0.0 <= p <= holm <= 1.0


def test_ranks_of_friedmans_test_are_a_row_for_each_algorithm() -> None:
    ranks = Friedman(ranks=(1.0, 2.5, 2.5), p=0.04, critical_difference=1.9, problems=2)
    experiment = replace(EXPERIMENT, algorithms=dict.fromkeys("abc", Guessing()), proposed="a")
    found = AlgorithmTests(experiment=experiment, tests=(), budgets={}, friedman=ranks)

    rows = rows_of_tests([found])

    assert [(row["test"], row["algorithm"], row["rank"]) for row in rows] == [
        ("Friedman", "a", 1.0),
        ("Friedman", "b", 2.5),
        ("Friedman", "c", 2.5),
    ]
    assert {(row["p"], row["critical_difference"], row["problems"]) for row in rows} == {
        (0.04, 1.9, 2)
    }


def test_standings_are_a_row_for_each_algorithm_on_each_problem_and_one_for_its_mean_rank() -> None:
    standing = Standing(
        algorithm="guess", kind="baseline", costs=np.array([1.0, 2.0, 6.0]), evaluations=20,
        seconds=0.5, distance=3.0, rank=1.0,
    )  # fmt: skip
    found = ExperimentStandings(
        experiment=EXPERIMENT,
        problems=(ProblemStandings(problem="bowl", minimum=None, rows=(standing,)),),
        budgets=(
            BudgetRow(
                algorithm="guess", evaluations=30, equal_evaluations=20, rank=1.5, equal_rank=2.0
            ),
        ),
    )

    on_problem, printed, equal = rows_of_standings([found])

    assert (on_problem["mean"], on_problem["median"], on_problem["runs"]) == (3.0, 2.0, 3)
    assert (on_problem["kind"], on_problem["distance"], on_problem["minimum"]) == (
        "baseline",
        3.0,
        None,
    )
    assert [
        (row["kind"], row["problem"], row["evaluations"], row["rank"]) for row in (printed, equal)
    ] == [
        ("printed protocol", None, 30, 1.5),
        ("equal evaluations", None, 20, 2.0),
    ]
    assert "seconds" not in on_problem  # equal runs give equal results
    assert on_problem.keys() == printed.keys() == equal.keys()
