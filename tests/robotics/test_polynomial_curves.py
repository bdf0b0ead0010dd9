import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import Polynomial

from repro.robotics import RestToRestLaw, cubic, quintic, septic
from repro.robotics.polynomial_curves import QUANTITIES, derivative, values

NUMBER = st.floats(-9.0, 9.0)
ANY_CURVE = st.lists(NUMBER, min_size=6, max_size=6).map(np.array)
DURATION = 1.7


def unit_move(law: RestToRestLaw) -> np.ndarray:
    return np.asarray(law.polynomial.coef, dtype=np.float64)


@given(curve=ANY_CURVE)
def test_values_and_derivatives_are_those_of_numpy(curve: np.ndarray) -> None:
    times = np.linspace(0.0, DURATION, 7)
    for order in range(6):
        expected = Polynomial(curve).deriv(order)(times) if order else Polynomial(curve)(times)
        assert values(derivative(curve, order), times) == pytest.approx(expected, abs=1e-9)


@given(curve=ANY_CURVE)
def test_peak_range_and_integral_of_the_jerk_are_those_of_fine_sampling(curve: np.ndarray) -> None:
    times = np.linspace(0.0, DURATION, 4001)
    jerk = Polynomial(curve).deriv(3)(times)
    scale = float(np.abs(jerk).max()) + 1e-9
    found = {name: float(QUANTITIES[name](curve, DURATION)) for name in QUANTITIES}

    # between two samples a parabola of this size rises by less than 1e-6 of it
    assert found["peak jerk"] == pytest.approx(scale, rel=1e-5, abs=1e-8)
    assert found["jerk range"] == pytest.approx(float(np.ptp(jerk)), rel=1e-5, abs=1e-5 * scale)
    assert found["squared jerk"] == pytest.approx(
        float(np.trapezoid(jerk**2, times)), rel=1e-4, abs=1e-9
    )


@pytest.mark.parametrize(("law", "peak", "squared"), [(cubic, 12.0, 144.0), (quintic, 60.0, 720.0)])
def test_jerk_of_a_unit_move_is_that_of_the_textbook(
    law: object, peak: float, squared: float
) -> None:
    curve = law.polynomial.coef  # type: ignore[attr-defined]

    assert QUANTITIES["peak jerk"](curve, 1.0) == pytest.approx(peak)
    assert QUANTITIES["squared jerk"](curve, 1.0) == pytest.approx(squared)


def test_jumps_are_what_a_law_leaves_at_its_ends() -> None:
    for law, rests in ((cubic, 1), (quintic, 2), (septic, 2)):
        curve = unit_move(law)
        names = ("velocity", "acceleration")[:rests]
        for name in names:
            for end in ("start", "end"):
                assert QUANTITIES[f"{end} {name}"](curve, 1.0) == pytest.approx(0.0, abs=1e-12)
    for end in ("start", "end"):
        assert QUANTITIES[f"{end} acceleration"](unit_move(cubic), 1.0) == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("turns", "reversals"),
    [
        ((), 0),
        ((0.5,), 1),
        ((0.2, 0.9), 2),
        ((0.2, 0.4, 0.6, 0.8), 4),
        ((0.5, 0.5), 0),
        ((2.0,), 0),
    ],
)
def test_reversals_are_the_places_where_the_velocity_changes_sign(
    turns: tuple[float, ...], reversals: int
) -> None:
    velocity = math.prod((Polynomial([-turn, 1.0]) for turn in turns), start=Polynomial([1.0]))
    curve = np.zeros(6)
    curve[: len(turns) + 2] = velocity.integ().coef

    assert QUANTITIES["reversals"](curve, 1.0) == reversals


def test_many_curves_are_measured_like_each_alone() -> None:
    curves = np.random.default_rng(2).normal(size=(2, 3, 6))

    for measure in QUANTITIES.values():
        together = measure(curves, DURATION)
        alone = [[float(measure(curve, DURATION)) for curve in row] for row in curves]
        assert together.tolist() == pytest.approx(np.array(alone), rel=1e-14)


def test_coefficient_that_rounding_swallows_changes_nothing() -> None:
    plain, swallowed = (np.array([0.0, 0, 0, 0, 1, last]) for last in (0.0, 5e-324))

    for measure in QUANTITIES.values():
        assert measure(swallowed, DURATION) == measure(plain, DURATION)


def test_standing_still_has_no_jumps_jerk_or_reversals() -> None:
    for measure in QUANTITIES.values():
        assert measure(np.array([0.4, 0, 0, 0, 0, 0]), 1.0) == 0.0
