import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import make_interp_spline

from repro.robotics import MinimumTime, quintic, septic
from repro.robotics.piecewise import PiecewiseMotion, passing_through, resting_at
from repro.robotics.rest_to_rest import peaks

WAYPOINTS = ((0.0, 3.0), (1.0, 2.0), (1.5, -1.0), (4.0, -2.0))
DURATIONS = (0.7, 0.4, 1.1)


def at(motion: PiecewiseMotion, segment: int, share: float, derivative: int) -> list[float]:
    scale = motion.durations[segment] ** derivative
    return [float(c.deriv(derivative)(share)) / scale for c in motion.curves[segment]]


@pytest.mark.parametrize("degree", [3, 5, 7])
def test_motion_through_waypoints_is_the_spline_that_scipy_interpolates(degree: int) -> None:
    motion = passing_through(WAYPOINTS, DURATIONS, degree=degree)
    ends = [(m, np.zeros(2)) for m in range(1, (degree + 1) // 2)]
    times = np.concatenate([[0.0], np.cumsum(DURATIONS)])
    spline = make_interp_spline(times, np.array(WAYPOINTS), k=degree, bc_type=(ends, ends))

    for segment, share in ((0, 0.2), (1, 0.9), (2, 0.5)):
        for m in range(4 if degree > 3 else 3):
            expected = spline(times[segment] + share * DURATIONS[segment], nu=m)
            assert at(motion, segment, share, m) == pytest.approx(expected, rel=1e-6, abs=1e-6)


def test_motion_through_waypoints_joins_them_smoothly_and_rests_at_its_ends() -> None:
    motion = passing_through(WAYPOINTS, DURATIONS, degree=7)

    for m in range(7):
        for k in (0, 1):
            assert at(motion, k, 1.0, m) == pytest.approx(at(motion, k + 1, 0.0, m), rel=1e-6)
    for m in (1, 2, 3):
        assert at(motion, 0, 0.0, m) == pytest.approx([0.0, 0.0], abs=1e-9)
        assert at(motion, 2, 1.0, m) == pytest.approx([0.0, 0.0], abs=1e-6)


def test_spline_without_a_waypoint_between_is_the_rest_to_rest_law() -> None:
    ends = (WAYPOINTS[0], WAYPOINTS[-1])
    through = passing_through(ends, (2.0,), degree=7)
    resting = resting_at(ends, (2.0,), law=septic)

    for curve, expected in zip(through.curves[0], resting.curves[0], strict=True):
        assert curve.coef == pytest.approx(expected.coef, abs=1e-9)


@pytest.mark.parametrize("derivative", [1, 2, 3])
def test_peaks_of_a_resting_motion_are_those_of_the_closed_form(derivative: int) -> None:
    problem = MinimumTime(
        waypoints=WAYPOINTS,
        law=quintic,
        velocity=(1.0, 1.0),
        acceleration=(1.0, 1.0),
        durations=(0.1, 1.0),
    )
    motion = resting_at(WAYPOINTS, DURATIONS, law=quintic)

    assert motion.peaks(derivative) == pytest.approx(peaks(problem, DURATIONS, derivative))


@given(st.floats(0.1, 10.0))
def test_slower_motion_has_lower_peaks_by_powers_of_the_factor(factor: float) -> None:
    motion = passing_through(WAYPOINTS, DURATIONS, degree=5)
    slower = passing_through(WAYPOINTS, [factor * d for d in DURATIONS], degree=5)

    for m in (1, 2, 3):
        assert slower.peaks(m) == pytest.approx(motion.peaks(m) / factor**m)


def test_reversals_are_counted_across_segments() -> None:
    zigzag = ((0.0, 0.0), (1.0, 1.0), (0.5, 2.0), (3.0, 3.0))

    assert resting_at(zigzag, (1.0, 1.0, 1.0), law=septic).reversals() == 2
    assert resting_at(zigzag[:2], (1.0,), law=septic).reversals() == 0
    assert resting_at(((0.0,), (0.0,), (1.0,)), (1.0, 1.0), law=septic).reversals() == 0


def test_motion_that_must_hurry_in_the_middle_overshoots() -> None:
    line = ((0.0,), (1.0,), (2.0,), (3.0,))

    assert passing_through(line, (3.0, 1.0, 3.0), degree=7).reversals() == 0
    assert passing_through(line, (0.2, 3.0, 0.2), degree=7).reversals() == 2
