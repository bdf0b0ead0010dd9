from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from repro.errors import DeclarationError
from repro.robotics.bsplines import Ends, control_weights, sample, solve, span_weights, spans

Vector = NDArray[np.float64]
ENDS: tuple[Ends, ...] = ("repeated", "natural", "still")
each_rule = pytest.mark.parametrize("ends", ENDS)


def nodes(count: int) -> Vector:
    return np.random.default_rng(count).normal(size=(count, 3))


@each_rule
@pytest.mark.parametrize("count", [2, 3, 6, 12])
def test_spline_passes_through_its_nodes(ends: Ends, count: int) -> None:
    points = nodes(count)

    ends_of_spans = sample(spans(points, ends), np.array([0.0, 1.0]))

    assert ends_of_spans[:, 0] == pytest.approx(points[:-1], abs=1e-14)
    assert ends_of_spans[:, 1] == pytest.approx(points[1:], abs=1e-14)


@each_rule
@pytest.mark.parametrize("derivative", [1, 2])
def test_derivatives_do_not_jump_at_a_node(ends: Ends, derivative: int) -> None:
    found = sample(spans(nodes(7), ends), np.array([0.0, 1.0]), derivative)

    assert found[:-1, 1] == pytest.approx(found[1:, 0], abs=1e-12)


@each_rule
@pytest.mark.parametrize("derivative", [1, 2, 3])
def test_derivatives_are_those_of_finite_differences(ends: Ends, derivative: int) -> None:
    step = 1e-5
    u = np.array([0.2, 0.5, 0.9])
    polynomials = spans(nodes(5), ends)

    lower, higher = (sample(polynomials, u + s, derivative - 1) for s in (-step, step))

    # central differences err by step² times the third derivative, and by rounding over the step
    assert sample(polynomials, u, derivative) == pytest.approx(
        (higher - lower) / (2 * step), abs=1e-8
    )


@pytest.mark.parametrize(("ends", "condition"), [("natural", "natural"), ("still", "clamped")])
def test_spline_is_the_cubic_one_of_scipy(ends: Ends, condition: str) -> None:
    points = nodes(6)
    peer = CubicSpline(np.arange(6), points, bc_type=condition)

    found = sample(spans(points, ends), np.linspace(0, 1, 11))

    assert found.reshape(-1, 3) == pytest.approx(
        peer(np.concatenate([k + np.linspace(0, 1, 11) for k in range(5)])), abs=1e-13
    )


@pytest.mark.parametrize(
    ("ends", "rule"), [("repeated", (1, -1, 0)), ("natural", (1, -2, 1)), ("still", (1, 0, -1))]
)
def test_control_points_keep_the_end_rule_exactly(ends: Ends, rule: tuple[int, ...]) -> None:
    weights = np.array(control_weights(5, ends))

    assert (np.array(rule) @ weights[:3] == 0).all()
    assert (np.array(rule) @ weights[:-4:-1] == 0).all()


@each_rule
def test_equal_nodes_give_a_constant_exactly(ends: Ends) -> None:
    for matrix in span_weights(6, ends):
        assert [sum(row, Fraction(0)) for row in matrix] == [1, 0, 0, 0]


def test_end_slope_of_repeated_control_points_is_half_of_their_step() -> None:
    weights = np.array(control_weights(6, "repeated"), dtype=np.float64)
    points = nodes(6)
    control = weights @ points

    slope = sample(spans(points, "repeated"), np.array([0.0]), 1)[0, 0]

    assert slope == pytest.approx((control[2] - control[1]) / 2)
    assert abs(slope).min() > 0.01  # not at rest


@pytest.mark.parametrize(("count", "ends"), [(1, "natural"), (0, "still"), (4, "open")])
def test_impossible_spline_is_refused_with_the_rules(count: int, ends: Ends) -> None:
    with pytest.raises(DeclarationError, match=f"{count} nodes .*'{ends}'.*repeated, natural"):
        control_weights(count, ends)


def test_linear_systems_are_solved_exactly_also_with_a_zero_on_the_diagonal() -> None:
    matrix = [[Fraction(0), Fraction(3)], [Fraction(7), Fraction(1, 3)]]

    assert solve(matrix, [[Fraction(1)], [Fraction(0)]]) == [[Fraction(-1, 63)], [Fraction(1, 3)]]


def test_singular_system_is_refused() -> None:
    with pytest.raises(ZeroDivisionError):
        solve([[Fraction(1), Fraction(2)], [Fraction(2), Fraction(4)]], [[Fraction(1)]] * 2)
