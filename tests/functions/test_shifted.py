from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.errors import InputError
from repro.functions import FUNCTIONS, Function
from repro.functions.shifted import ShiftedProblem
from repro.optimisers import DE, WOA
from repro.runs.moved_optima import SHARES
from repro.runs.plan import plan
from tests.small_papers import EXPERIMENT, PAPER
from tests.twins.functions import FORMULAS

# The largest value below which two roundings of one coordinate may differ: the shifted minimiser
# is rounded once when the shift is added and once when it is taken off again.
ROUNDING = {"rosenbrock": 1e-25, "penalized_1": 1e-28, "penalized_2": 1e-28}
UNIT = st.floats(min_value=0.0, max_value=1.0)

each_function = pytest.mark.parametrize("function", FUNCTIONS.values(), ids=list(FUNCTIONS))
each_share = pytest.mark.parametrize("share", SHARES)


def moved(function: Function, share: float, dimension: int = 6) -> ShiftedProblem:
    problem = function.problem(function.fixed_dimension or dimension)
    return ShiftedProblem(problem=problem, share=share)


@each_function
@each_share
def test_value_at_the_shifted_minimiser_is_the_minimum(function: Function, share: float) -> None:
    problem = moved(function, share, dimension=30)

    assert problem(problem.minimiser) == pytest.approx(
        problem.problem.minimum, rel=1e-14, abs=ROUNDING.get(function.name, 1e-15)
    )


@each_function
@given(points=st.lists(UNIT, min_size=6, max_size=6))
def test_no_shift_gives_the_plain_value_bit_for_bit(
    function: Function, points: list[float]
) -> None:
    problem = moved(function, 0.0)
    low, high = problem.bounds.T
    x = low + np.array(points[: len(low)]) * (high - low)

    assert problem(x) == function(x)


@each_function
@given(points=st.lists(UNIT, min_size=6, max_size=6), share=st.sampled_from(SHARES))
def test_a_shifted_value_is_the_plain_one_of_the_point_moved_back(
    function: Function, points: list[float], share: float
) -> None:
    problem = moved(function, share)
    low, high = problem.bounds.T
    x = low + np.array(points[: len(low)]) * (high - low)

    assert problem(x) == function(x - problem.shift)
    # 1e-9 because cancellation amplifies the rounding of the sums, which have another order
    expected = FORMULAS[function.name]((x - problem.shift).tolist())
    assert problem(x) == pytest.approx(expected, rel=1e-9, abs=1e-12)


@each_function
@each_share
def test_every_coordinate_moves_by_half_of_the_share_to_all_of_it(
    function: Function, share: float
) -> None:
    problem = moved(function, share, dimension=40)
    low, high = problem.bounds.T
    steps = np.abs(problem.shift) / ((high - low) / 2)

    assert (steps >= share / 2).all()
    assert (steps <= share).all()
    assert len(set(steps)) == len(steps)


@pytest.mark.parametrize("dimension", [30, 40])
def test_shifts_go_to_both_sides_along_one_ray(dimension: int) -> None:
    small, large = (moved(FUNCTIONS["sphere"], share, dimension).shift for share in (0.1, 0.4))

    assert np.abs(np.sign(small).sum()) < dimension / 2
    assert large == pytest.approx(4 * small, rel=1e-15)


def test_a_search_on_a_problem_that_stays_in_place_runs_the_same_bits() -> None:
    plain = FUNCTIONS["ackley"].problem(5)
    results = [
        WOA().minimise(problem, population=6, iterations=30, rng=np.random.default_rng(1))
        for problem in (plain, ShiftedProblem(problem=plain, share=0.0))
    ]

    assert results[0].history.tobytes() == results[1].history.tobytes()


def test_the_search_finds_the_optimum_where_it_went() -> None:
    problem = moved(FUNCTIONS["sphere"], 0.4, dimension=3)
    found = DE().minimise(problem, population=20, iterations=200, rng=np.random.default_rng(1))

    assert found.x == pytest.approx(problem.minimiser, abs=1e-6)


def test_two_problems_hold_their_own_points() -> None:
    problem = moved(FUNCTIONS["sphere"], 0.2)

    assert not np.shares_memory(problem.data, problem.data)


@pytest.mark.parametrize("share", [-0.1, 1.0, float("nan")])
def test_a_shift_out_of_the_box_is_refused(share: float) -> None:
    with pytest.raises(InputError, match="share of the half width"):
        moved(FUNCTIONS["sphere"], share)


def test_a_point_of_another_dimension_is_refused() -> None:
    with pytest.raises(InputError, match=r"shape \(6,\)"):
        moved(FUNCTIONS["sphere"], 0.2)(np.zeros(7))


def test_a_run_depends_on_the_source_of_the_function_that_is_moved() -> None:
    kernel = moved(FUNCTIONS["branin"], 0.2).kernel

    assert kernel.__module__ == FUNCTIONS["branin"].kernel.__module__ == "repro.functions.fixed"


def test_another_shift_is_another_task() -> None:
    keys = set()
    for share in (0.0, 0.1, 0.2):
        problems = {"F": moved(FUNCTIONS["sphere"], share)}
        experiment = replace(EXPERIMENT, problems=problems)
        paper = replace(PAPER, experiments=(experiment,), results=(), claims=())
        keys.add(plan([paper], 1)[0].key)

    assert len(keys) == 3
