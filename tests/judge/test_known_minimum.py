from dataclasses import replace

import numpy as np
import pytest

from papers.liang2026 import MOTION
from papers.mousa2023 import FIT
from papers.syji import PRINTED, RESTING
from repro.functions import FUNCTIONS, BoxProblem
from repro.judge.certificates import Certificate
from repro.judge.known_minimum import KnownMinimum, known_minimum
from repro.optimisers import GWO
from tests.small_problems import small


def certificate(minimum: float | None) -> Certificate:
    return Certificate(
        paper="doe2021", problem="motion/arm", minimum=minimum, lower_bound=1.0, attained=2.0,
        method="by hand", at=(), binding=(), printed=(),
    )  # fmt: skip


def test_benchmark_function_has_its_true_minimum() -> None:
    known = known_minimum("benchmark/F", FUNCTIONS["shekel_5"].problem())

    assert known
    assert known.value == FUNCTIONS["shekel_5"].minimum


def test_motion_has_the_proved_bound_of_its_own_certificate() -> None:
    known = known_minimum("motion/arm", RESTING, [certificate(1.5)])

    assert known
    assert (known.value, known.how) == (1.0, "certified optimum")
    assert known_minimum("motion/other", RESTING, [certificate(1.5)]) is None
    assert known_minimum("motion/arm", RESTING, [certificate(None)]) is None


def test_motion_whose_penalty_may_be_cheaper_than_obeying_has_none() -> None:
    problem = replace(next(iter(MOTION.problems.values())), handling="penalty")

    assert known_minimum("motion/arm", problem, [certificate(1.5)]) is None


@pytest.mark.parametrize("problem", [PRINTED, FIT.problems["joint 1"]], ids=["motion", "path"])
def test_no_search_goes_below_a_minimum_that_is_computed(problem: object) -> None:
    known = known_minimum("motion/arm", problem)

    found = GWO().minimise(
        problem,  # type: ignore[arg-type]
        population=30,
        iterations=500,
        rng=np.random.default_rng(1),
    )
    assert known
    assert known.value - 1e-9 <= found.cost


def test_fixed_penalties_have_the_fitness_that_a_search_comes_near_to() -> None:
    known = known_minimum("motion/arm", PRINTED)

    found = GWO().minimise(PRINTED, population=30, iterations=500, rng=np.random.default_rng(1))
    assert known
    assert found.cost == pytest.approx(known.value, rel=0.1)


def test_problem_of_a_stranger_has_no_known_minimum() -> None:
    assert known_minimum("search/slope", small("slope")) is None


def test_minimum_of_a_cost_of_ones_own_is_the_declared_one_where_there_is_one() -> None:
    declared = BoxProblem(cost=sum, box=[(0, 1)], minimum=0.0)

    assert known_minimum("own/p", declared) == KnownMinimum(value=0.0, how="as declared")
    assert known_minimum("own/p", BoxProblem(cost=sum, box=[(0, 1)])) is None
