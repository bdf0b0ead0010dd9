import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.compiled import COST, ready
from repro.errors import InputError
from repro.functions import FUNCTIONS, Function, classical
from tests.twins.functions import FORMULAS

# What float64 leaves at a minimiser; the others are exact there.
FLOORS = {
    "ackley": 8.9e-16,  # 4.4e-16 where exp(1) is rounded correctly, else 8.9e-16
    "penalized_1": 1.6e-32,  # sin(pi) is 1.2e-16, not 0; n = 30
    "penalized_2": 1.4e-32,
    "foxholes": 9e-16,  # 4.4e-16 here: 25 terms are summed
    "branin": 1.8e-15,  # one unit in the last place of 10, a term of it
    "hartmann_3": 9e-16,  # two units in the last place
    "shekel_5": 3.6e-15,  # two units in the last place
    "shekel_7": 3.6e-15,
    "shekel_10": 3.6e-15,
    "hartmann_6": 1.8e-15,  # four units
    "schwefel_2_26": 6e-12,  # three units of 12569
    "kowalik": 2e-18,  # thirty units: differences of numbers to 0.2, squared and summed
    "six_hump_camel": 5e-16,  # one unit in the last place of 2, a term of it
}
# How far below the minimum rounding may take a value; those that end in 0 stay above it.
ROUNDING = {
    "foxholes": 3e-15,  # 25 terms of order 1
    "branin": 1e-14,  # 10 - 9.6
    "goldstein_price": 1e-12,  # 30 - 27, from a factor 9 on a sum of numbers near 50
    "hartmann_3": 4e-15,
    "shekel_5": 2e-14,
    "shekel_7": 2e-14,
    "shekel_10": 2e-14,
    "hartmann_6": 4e-15,
    "schwefel_2_26": 1e-11,
    "kowalik": 1e-17,
    "six_hump_camel": 2e-15,
}
SQUARES = {
    **dict.fromkeys(("sphere", "schwefel_1_2", "schwefel_2_21"), 100.0),
    **dict.fromkeys(("schwefel_2_22", "alpine_1"), 10.0),
    **dict.fromkeys(("penalized_1", "penalized_2"), 50.0),
    "rosenbrock": 30.0,
    "rastrigin": 5.12,
    "ackley": 32.0,
    "foxholes": 65.536,
    "goldstein_price": 2.0,
    **dict.fromkeys(("step", "step_floor"), 100.0),
    "quartic_noise": 1.28,
    "schwefel_2_26": 500.0,
    "griewank": 600.0,
    **dict.fromkeys(("kowalik", "six_hump_camel"), 5.0),
}
UNIT = st.floats(min_value=0.0, max_value=1.0)
FREE = [f for f in FUNCTIONS.values() if f.fixed_dimension is None]
FIXED = [f for f in FUNCTIONS.values() if f.fixed_dimension is not None]

each_function = pytest.mark.parametrize("function", FUNCTIONS.values(), ids=list(FUNCTIONS))


def dimension_of(function: Function) -> int:
    return function.fixed_dimension or 30


def test_there_are_the_classical_functions_alpine_and_the_rounded_step() -> None:
    assert len(FUNCTIONS) == 23 + 2
    assert set(FUNCTIONS) == set(FORMULAS)
    assert all(name == function.name for name, function in FUNCTIONS.items())


def test_classical_functions_are_numbered_as_their_source_numbers_them() -> None:
    numbered = classical(7)

    assert list(numbered) == [f"F{k}" for k in range(1, 24)]
    assert {7} == {p.dimension for p in numbered.values() if not p.function.fixed_dimension}
    for name, problem in numbered.items():
        assert name.lower() in problem.function.source.split(", ")


@each_function
def test_value_at_the_minimiser_is_the_minimum(function: Function) -> None:
    problem = function.problem(dimension_of(function))
    value = function(function.minimiser(problem.dimension))

    assert abs(value - problem.minimum) <= FLOORS.get(function.name, 0.0)


@each_function
@pytest.mark.parametrize("place", ["origin", "lower corner", "upper corner", "interior"])
def test_value_elsewhere_is_that_of_the_printed_formula(function: Function, place: str) -> None:
    bounds = function.problem(function.fixed_dimension or 7).bounds
    share = np.random.default_rng(5).random(len(bounds))
    x = {
        "origin": np.zeros(len(bounds)),
        "lower corner": bounds[:, 0],
        "upper corner": bounds[:, 1],
        "interior": bounds[:, 0] + share * (bounds[:, 1] - bounds[:, 0]),
    }[place]

    # sums round differently in another order; the factors of Goldstein-Price amplify it
    expected = pytest.approx(FORMULAS[function.name](x.tolist()), rel=1e-13, abs=1e-15)
    assert function(x) == expected


@pytest.mark.parametrize(
    ("name", "at", "value"),
    [
        ("rosenbrock", 0.0, 29.0),
        ("penalized_1", 0.0, 1.668971097219577),
        ("penalized_2", 0.0, 3.0),
        ("foxholes", -32.0, 0.998003838818649),
        ("ackley", 32.0, 20.0 + math.e - 20.0 * math.exp(-6.4) - math.e),
        ("schwefel_1_2", 1.0, 30 * 31 * 61 / 6),  # the sum of squares up to 30
        ("schwefel_2_22", 2.0, 60.0 + 2.0**30),
        ("step", 0.0, 7.5),
        ("step_floor", 0.49, 0.0),
        ("step_floor", -1.5, 30.0),
        ("quartic_noise", 1.0, 465.0),  # the sum up to 30
        ("schwefel_2_26", (math.pi / 2) ** 2, -30 * (math.pi / 2) ** 2),
        ("griewank", 0.0, 0.0),
        ("six_hump_camel", 1.0, 4.0 - 2.1 + 1.0 / 3.0 + 1.0),
    ],
)
def test_value_on_the_diagonal_is_known(name: str, at: float, value: float) -> None:
    function = FUNCTIONS[name]

    result = function(np.full(dimension_of(function), at))

    assert result == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("x", [(-math.pi, 12.275), (math.pi, 2.275), (3 * math.pi, 2.475)])
def test_branin_attains_its_minimum_at_three_points(x: tuple[float, float]) -> None:
    branin = FUNCTIONS["branin"]

    assert branin(np.array(x)) == pytest.approx(branin.minimum, abs=1e-14)  # 10 - 9.6 rounds


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_camel_attains_its_minimum_at_two_points(side: float) -> None:
    camel = FUNCTIONS["six_hump_camel"]

    assert camel(side * camel.minimiser()) == pytest.approx(camel.minimum, abs=5e-16)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("schwefel_2_26", -12569.486618173012),
        ("kowalik", 0.0003074859878056),
        ("six_hump_camel", -1.0316284534898774),
        ("hartmann_6", -3.3219951715842421),
        ("shekel_7", -10.402940566818661),
        ("shekel_10", -10.536409816692044),
    ],
)
def test_minimum_is_that_of_an_independent_search_in_many_digits(name: str, value: float) -> None:
    assert FUNCTIONS[name].problem(dimension_of(FUNCTIONS[name])).minimum == pytest.approx(
        value, rel=1e-14
    )


def test_a_sum_over_coordinates_has_a_minimum_for_every_dimension() -> None:
    schwefel = FUNCTIONS["schwefel_2_26"]

    for n in (1, 2, 30):
        minimum = schwefel.problem(n).minimum
        assert minimum == pytest.approx(-418.9828872724337 * n, rel=1e-15)
        assert schwefel(schwefel.minimiser(n)) == pytest.approx(minimum, rel=1e-15)


@pytest.mark.parametrize("sine_zero", [-9.3246105396078, -3.0414252324282, 6.1830178860180])
def test_alpine_has_minima_where_the_sine_is_minus_a_tenth(sine_zero: float) -> None:
    value = FUNCTIONS["alpine_1"](np.full(30, sine_zero))

    assert value < 30 * 10 * 1e-13  # slope below 10 times the rounding of 13 decimals


@each_function
@given(data=st.data())
def test_nothing_in_the_box_is_below_the_minimum(function: Function, data: st.DataObject) -> None:
    n = function.fixed_dimension or data.draw(st.integers(1, 6))
    share = np.array(data.draw(st.lists(UNIT, min_size=n, max_size=n)))
    problem = function.problem(n)
    x = problem.bounds[:, 0] + share * (problem.bounds[:, 1] - problem.bounds[:, 0])

    assert function(x) >= problem.minimum - ROUNDING.get(function.name, 0.0)


@each_function
@given(data=st.data())
def test_nothing_near_the_minimiser_is_below_the_minimum(
    function: Function, data: st.DataObject
) -> None:
    n = function.fixed_dimension or data.draw(st.integers(1, 6))
    direction = np.array(data.draw(st.lists(UNIT, min_size=n, max_size=n))) - 0.5
    reach = 10.0 ** -data.draw(st.integers(0, 12))
    x = function.minimiser(n) + reach * direction

    assert function(x) >= function.problem(n).minimum - ROUNDING.get(function.name, 0.0)


@pytest.mark.parametrize(("name", "reach"), SQUARES.items())
def test_box_around_the_origin_reaches_as_far_as_is_printed(name: str, reach: float) -> None:
    assert {(-reach, reach)} == set(FUNCTIONS[name].box)


def test_boxes_elsewhere_are_the_printed_ones() -> None:
    assert FUNCTIONS["branin"].box == ((-5.0, 10.0), (0.0, 15.0))
    assert FUNCTIONS["hartmann_3"].box == ((0.0, 1.0),) * 3
    assert FUNCTIONS["hartmann_6"].box == ((0.0, 1.0),) * 6
    for name in ("shekel_5", "shekel_7", "shekel_10"):
        assert FUNCTIONS[name].box == ((0.0, 10.0),) * 4


@pytest.mark.parametrize("function", FREE, ids=lambda f: f.name)
def test_problem_repeats_the_box_in_every_dimension(function: Function) -> None:
    problem = function.problem(dimension=7)

    assert problem.bounds.tolist() == [list(function.box[0])] * 7


@pytest.mark.parametrize(
    "name", ["rastrigin", "ackley", "penalized_1", "penalized_2", "schwefel_2_26", "griewank"]
)
def test_value_does_not_depend_on_what_the_room_holds(name: str) -> None:
    problem = FUNCTIONS[name].problem(7)
    x, room = np.random.default_rng(1).uniform(-5.0, 5.0, 7), problem.data
    cost = ready(problem.kernel, COST)

    assert len(room) == problem.scratch == 7
    assert cost(x, room) == cost(x, room) == cost(x, np.full(7, np.nan)) == FUNCTIONS[name](x)
    assert problem.data is not problem.data  # two threads may not share it


@pytest.mark.parametrize("function", FIXED, ids=lambda f: f.name)
def test_problem_of_a_fixed_function_needs_no_dimension(function: Function) -> None:
    problem = function.problem()

    assert problem.dimension == function.fixed_dimension
    assert problem.bounds.tolist() == [list(pair) for pair in function.box]


@pytest.mark.parametrize("function", FIXED, ids=lambda f: f.name)
def test_wrong_dimension_is_refused_with_the_right_one(function: Function) -> None:
    wrong = dimension_of(function) + 1

    with pytest.raises(InputError, match=f"{wrong} is impossible.* {function.fixed_dimension}$"):
        function.problem(wrong)
    with pytest.raises(InputError, match=f"{wrong} is impossible.* {function.fixed_dimension}$"):
        function(np.zeros(wrong))


@pytest.mark.parametrize("function", FREE, ids=lambda f: f.name)
def test_missing_or_empty_dimension_is_refused_with_what_is_allowed(function: Function) -> None:
    with pytest.raises(InputError, match=r"give dimension=30"):
        function.problem()
    with pytest.raises(InputError, match=r"0 is impossible.* 1 or more$"):
        function.minimiser(0)


@pytest.mark.parametrize("x", [np.zeros((2, 30)), np.zeros((1, 2, 3))])
def test_several_points_at_once_are_refused(x: NDArray[np.float64]) -> None:
    with pytest.raises(InputError, match=r"one point of shape \(n,\)"):
        FUNCTIONS["sphere"](x)


def test_all_of_the_classical_23_functions_are_there() -> None:
    classical = (
        *("sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21", "rosenbrock", "step"),
        *("quartic_noise", "schwefel_2_26", "rastrigin", "ackley", "griewank", "penalized_1"),
        *("penalized_2", "foxholes", "kowalik", "six_hump_camel", "branin", "goldstein_price"),
        *("hartmann_3", "hartmann_6", "shekel_5", "shekel_7", "shekel_10"),
    )

    assert len(classical) == 23
    assert set(classical) <= set(FUNCTIONS)
