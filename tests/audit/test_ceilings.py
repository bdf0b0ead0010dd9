import math
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.audit.blocks import bounds_of
from repro.functions import FUNCTIONS
from tests.summaries import audited, most, scientific, summary

CEILINGS = {n: f.known.ceiling for n, f in FUNCTIONS.items() if f.known.ceiling}
LEAST_OF_ALL_SPACE = [n for n, f in FUNCTIONS.items() if f.known.least_of_all_space]


def dimension(name: str) -> int:
    return FUNCTIONS[name].fixed_dimension or 30


@pytest.mark.parametrize("name", CEILINGS)
@given(seed=st.integers(0, 2**32 - 1), edges=st.floats(0.0, 1.0))
def test_no_point_of_the_box_lies_above_the_ceiling(name: str, seed: int, edges: float) -> None:
    bounds = FUNCTIONS[name].problem(dimension(name)).bounds
    rng = np.random.default_rng(seed)
    inside, at_an_edge = rng.random(len(bounds)), rng.random(len(bounds)) < edges
    shares = np.where(at_an_edge, inside.round(), inside)
    point = bounds[:, 0] + shares * (bounds[:, 1] - bounds[:, 0])
    assert FUNCTIONS[name](point) <= most(name) * (1 + 1e-12)


REACHED = ("sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21", "step", "step_floor")


@pytest.mark.parametrize("name", REACHED)
def test_a_corner_of_the_box_reaches_the_ceiling(name: str) -> None:
    corner = FUNCTIONS[name].problem(30).bounds[:, 1]
    assert FUNCTIONS[name](corner) == pytest.approx(most(name), rel=1e-12)


def test_every_function_but_one_with_poles_has_a_ceiling() -> None:
    pole = np.array([1.0, 0.0, 0.0, -(2.0**-8)])  # b² - 2^-8 is 0 for the b of 1 / 16

    assert FUNCTIONS["kowalik"](pole) == math.inf
    assert CEILINGS.keys() == FUNCTIONS.keys() - {"kowalik"}


@pytest.mark.parametrize("name", sorted(LEAST_OF_ALL_SPACE))
@given(seed=st.integers(0, 2**32 - 1), reach=st.floats(1.0, 4.0))
def test_no_point_outside_the_box_lies_below_the_least_of_all_space(
    name: str, seed: int, reach: float
) -> None:
    problem = FUNCTIONS[name].problem(FUNCTIONS[name].fixed_dimension or 3)
    low, high = problem.bounds.T
    around = np.random.default_rng(seed).uniform(-reach, reach, len(low))
    point = (low + high) / 2 + around * (high - low) / 2

    assert FUNCTIONS[name](point) >= problem.minimum - 1e-12


def test_outside_its_box_a_sum_of_sines_falls_below_its_minimum() -> None:
    schwefel = FUNCTIONS["schwefel_2_26"].problem(1)

    assert schwefel.function(np.array([(8.5 * np.pi) ** 2])) < schwefel.minimum
    assert bounds_of(schwefel).only_in_box


def test_bounds_of_a_sum_over_coordinates_follow_the_dimension() -> None:
    few, many = (bounds_of(FUNCTIONS["schwefel_2_26"].problem(n)) for n in (3, 30))

    assert many.minimum == pytest.approx(10 * few.minimum)
    assert many.minimum - many.floor_in_singles == pytest.approx(
        10 * (few.minimum - few.floor_in_singles)
    )


def test_ceiling_of_the_camel_is_reached_in_two_corners() -> None:
    assert CEILINGS["six_hump_camel"](2) == Fraction(38525, 6)
    for side in (5.0, -5.0):
        value = FUNCTIONS["six_hump_camel"](np.full(2, side))
        assert value == pytest.approx(38525 / 6, rel=1e-15)


def test_ceiling_of_the_quartic_leaves_room_for_its_noise() -> None:
    corner = FUNCTIONS["quartic_noise"](np.full(30, 1.28))

    assert most("quartic_noise") - corner == pytest.approx(FUNCTIONS["quartic_noise"].noise)


@pytest.mark.parametrize(("name", "within"), [("penalized_1", 1e-4), ("penalized_2", 1e-4)])
def test_a_corner_of_the_box_comes_close_to_the_ceiling(name: str, within: float) -> None:
    corner = FUNCTIONS[name].problem(30).bounds[:, 0]
    corners = (FUNCTIONS[name](corner), FUNCTIONS[name](-corner))

    assert max(corners) == pytest.approx(most(name), rel=within)
    assert max(corners) < most(name)


@given(st.floats(-5.0, 10.0), st.floats(-5.0, 15.0))
def test_ceiling_of_branin_holds_on_both_boxes_in_use(u: float, v: float) -> None:
    assert FUNCTIONS["branin"](np.array([u, v])) <= most("branin")


def test_ceiling_of_branin_is_nearly_reached_in_a_corner() -> None:
    assert FUNCTIONS["branin"](np.array([-5.0, -5.0])) == pytest.approx(most("branin"), rel=1e-4)


Grid = dict[tuple[int, int], Fraction]  # coefficients of u^i v^j


def times(first: Grid, second: Grid) -> Grid:
    total: Grid = {}
    for (i, j), a in first.items():
        for (k, m), b in second.items():
            total[i + k, j + m] = total.get((i + k, j + m), Fraction(0)) + a * b
    return {powers: entry for powers, entry in total.items() if entry}


def polynomial(*entries: int) -> Grid:
    """Return the quadratic with coefficients of 1, u, u², v, uv, v²."""
    powers = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (0, 2)]
    return dict(zip(powers, map(Fraction, entries), strict=True))


def plus(first: Grid, constant: int) -> Grid:
    return first | {(0, 0): first.get((0, 0), Fraction(0)) + constant}


def goldstein_price() -> Grid:
    near = times(polynomial(1, 1, 0, 1, 0, 0), polynomial(1, 1, 0, 1, 0, 0))
    far = times(polynomial(0, 2, 0, -3, 0, 0), polynomial(0, 2, 0, -3, 0, 0))
    first = times(near, polynomial(19, -14, 3, -14, 6, 3))
    return times(plus(first, 1), plus(times(far, polynomial(18, -32, 12, 48, -36, 27)), 30))


def bernstein(coefficients: Grid, degree: int = 8) -> list[list[Fraction]]:
    """Return the Bernstein coefficients on [-2, 2]², rows in u, columns in v."""
    conversion = [
        [
            sum(
                (
                    Fraction(math.comb(i, k), math.comb(degree, k))
                    * (4**k)
                    * math.comb(power, k)
                    * Fraction(-2) ** (power - k)
                    for k in range(min(i, power) + 1)
                ),
                Fraction(0),
            )
            for i in range(degree + 1)
        ]
        for power in range(degree + 1)
    ]
    return [
        [
            sum(
                (c * conversion[i][a] * conversion[j][b] for (i, j), c in coefficients.items()),
                Fraction(0),
            )
            for b in range(degree + 1)
        ]
        for a in range(degree + 1)
    ]


def halves(row: list[Fraction]) -> tuple[list[Fraction], list[Fraction]]:
    """Return the Bernstein coefficients on both halves (de Casteljau)."""
    left, right = [row[0]], [row[-1]]
    while len(row) > 1:
        row = [(a + b) / 2 for a, b in pairwise(row)]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def below(grid: list[list[Fraction]], limit: Fraction, depth: int) -> bool:
    """Return whether the polynomial is proved to stay below the limit."""
    if max(map(max, grid)) < limit:
        return True
    if depth == 0:
        return False
    parts = zip(*(halves(row) for row in grid), strict=True)  # halved in v, next time in u
    return all(
        below([list(row) for row in zip(*part, strict=True)], limit, depth - 1) for part in parts
    )


def test_ceiling_of_goldstein_price_is_proved_by_bernstein_coefficients() -> None:
    grid = bernstein(goldstein_price())
    ceiling = CEILINGS["goldstein_price"](2)

    at = np.array([-1.73737254, 2.0])
    peak = FUNCTIONS["goldstein_price"](at)

    assert float(grid[0][0]) == FUNCTIONS["goldstein_price"](np.array([-2.0, -2.0]))
    assert float(grid[0][8]) == FUNCTIONS["goldstein_price"](np.array([-2.0, 2.0]))
    assert below(grid, ceiling, depth=30)
    assert not below(grid, Fraction(peak), depth=12)
    assert float(ceiling) - 1 < peak < ceiling


def test_box_wider_than_the_ceiling_is_proved_on_has_none() -> None:
    own = FUNCTIONS["sphere"].problem(30)
    wide = replace(FUNCTIONS["sphere"], box=((-200.0, 200.0),))
    narrow = replace(FUNCTIONS["sphere"], box=((-50.0, 100.0),))

    assert bounds_of(own).ceiling is not None
    assert bounds_of(wide.problem(30)).ceiling is None
    assert bounds_of(narrow.problem(30)).ceiling == bounds_of(own).ceiling


def test_runs_that_end_on_the_ceiling_are_possible() -> None:
    sample = np.array([-10.0] * 7 + [0.0] * 3)
    block = {name: scientific(summary(sample)[name]) for name in ("mean", "std")}
    assert audited(block, n=10, function="shekel_5") == {}


def test_a_std_that_needs_runs_above_the_ceiling_is_impossible() -> None:
    sample = np.array([-10.0] * 9 + [10.0])
    block = {name: scientific(summary(sample)[name]) for name in ("mean", "std")}
    row = audited(block, n=10, function="shekel_5")["std-bound"]
    assert "no value above 0, which Shekel, 5 wells never exceeds" in row.explanation


def test_a_ceiling_that_the_mean_keeps_out_of_reach_is_not_named() -> None:
    row = audited({"mean": "1.000×10^-5", "std": "1.000×10^-3"}, n=10)["std-bound"]
    assert "never exceeds" not in row.explanation
