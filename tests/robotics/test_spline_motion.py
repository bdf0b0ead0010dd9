import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError
from repro.robotics import MinimumTimeSpline
from repro.robotics.spline_motion import motion

Vector = NDArray[np.float64]
PROBLEM = MinimumTimeSpline(
    nodes=((0.0, 1.0), (1.5, 0.2), (-0.5, 0.6), (0.7, -1.0)),
    velocity=(1.0, 0.8),
    acceleration=(2.0, 3.0),
    durations=(0.1, 9.0),
)
SLOW, QUICK = np.array([4.0, 5.0, 4.5]), np.array([0.5, 0.6, 0.4])
BACKWARDS = np.array([0.1, 9.0, 0.1])
SCALED = replace(PROBLEM, handling="time scaling")


def cost(problem: MinimumTimeSpline, durations: Vector) -> float:
    return float(ready(problem.kernel, COST)(durations, problem.data))


def test_motion_passes_its_nodes_when_the_durations_say() -> None:
    times, angles = motion(PROBLEM, SLOW, derivative=0, samples=11)

    assert times[::11] == pytest.approx([0.0, 4.0, 9.0])
    assert angles[::11] == pytest.approx(np.array(PROBLEM.nodes[:-1]))
    assert (times[-1], *angles[-1]) == pytest.approx((13.5, *PROBLEM.nodes[-1]))


@pytest.mark.parametrize("derivative", [1, 2, 3])
def test_derivatives_in_time_are_those_of_finite_differences(derivative: int) -> None:
    samples = 4001
    times, below = motion(PROBLEM, SLOW, derivative=derivative - 1, samples=samples)
    _, values = motion(PROBLEM, SLOW, derivative=derivative, samples=samples)
    segment = slice(samples, 2 * samples)  # the jerk jumps where segments meet

    found = np.gradient(below[segment], times[segment], axis=0)

    assert found[5:-5] == pytest.approx(values[segment][5:-5], abs=1e-4)


def test_shares_are_the_peaks_of_dense_samples_over_the_limits() -> None:
    peaks = [
        (abs(motion(PROBLEM, SLOW, derivative=m, samples=5001)[1]) / PROBLEM.limits[m - 1]).max()
        for m in (1, 2)
    ]

    assert PROBLEM.peak_shares(SLOW) == pytest.approx(peaks, rel=1e-6)


@pytest.mark.parametrize("factor", [0.5, 3.0])
def test_time_scaled_divides_velocity_by_the_scale_and_acceleration_by_its_square(
    factor: float,
) -> None:
    fast, hard = PROBLEM.peak_shares(QUICK)

    assert PROBLEM.peak_shares(factor * QUICK) == pytest.approx(
        [fast / factor, hard / factor**2], rel=1e-12
    )


def test_straight_line_in_time_has_the_mean_velocity_everywhere() -> None:
    line = replace(PROBLEM, nodes=((0.0, 0.0), (3.0, -1.0)), ends="natural", time_ends="natural")

    shares = line.peak_shares(np.array([2.0]))

    assert shares == pytest.approx([1.5, 0.0], abs=1e-12)


def test_motion_that_obeys_is_counted_as_it_is() -> None:
    assert (PROBLEM.peak_shares(SLOW) < 1).all()
    assert PROBLEM.obeying(SLOW).tolist() == SLOW.tolist()
    assert cost(PROBLEM, SLOW) == SLOW.sum() == PROBLEM.quantity("total", SLOW)


def test_motion_that_breaks_a_limit_is_counted_as_slowed_until_it_just_obeys() -> None:
    slowed = PROBLEM.obeying(QUICK)

    assert PROBLEM.peak_shares(slowed).max() == pytest.approx(1.0)
    assert slowed / QUICK == pytest.approx(slowed[0] / QUICK[0])
    assert PROBLEM.quantity("total", QUICK) == pytest.approx(slowed.sum())
    assert PROBLEM.quantity("duration 2", QUICK) == slowed[1]


def test_every_motion_that_obeys_comes_before_one_that_does_not() -> None:
    longest = np.full(3, 9.0)

    assert cost(PROBLEM, longest) == 27.0
    assert 27.0 < cost(PROBLEM, QUICK) < cost(PROBLEM, 0.5 * QUICK)


@pytest.mark.parametrize("problem", [PROBLEM, SCALED])
def test_durations_with_which_time_runs_backwards_come_last_and_are_finite(
    problem: MinimumTimeSpline,
) -> None:
    further = np.array([0.1, 9.5, 0.1])

    assert cost(problem, 1e-6 * QUICK) < cost(problem, BACKWARDS) < cost(problem, further) < 1e10
    assert problem.peak_shares(BACKWARDS).tolist() == [math.inf, math.inf]


@pytest.mark.parametrize("durations", [SLOW, QUICK])
def test_time_scaling_counts_every_motion_with_the_time_at_which_it_just_obeys(
    durations: Vector,
) -> None:
    found = cost(SCALED, durations)

    assert found == pytest.approx(SCALED.quantity("total", durations))
    assert found == pytest.approx(cost(SCALED, 3.0 * durations))
    assert SCALED.peak_shares(SCALED.obeying(durations)).max() == pytest.approx(1.0)


def test_shares_are_told_in_percent_and_speeds_at_the_ends_in_radians() -> None:
    _, speeds = motion(PROBLEM, SLOW, derivative=1, samples=3)

    assert PROBLEM.quantity("velocity share", SLOW) == 100 * PROBLEM.peak_shares(SLOW)[0]
    assert PROBLEM.quantity("acceleration share", SLOW) == 100 * PROBLEM.peak_shares(SLOW)[1]
    assert PROBLEM.quantity("speed at the ends", SLOW) == abs(speeds[[0, -1]]).max()


def test_quantities_keep_the_shape_of_the_points() -> None:
    points = np.stack([[SLOW, QUICK], [QUICK, SLOW]])

    for name in ("total", "duration 1", "velocity share", "speed at the ends"):
        found = PROBLEM.quantity(name, points)
        assert found.shape == (2, 2)
        assert found[0, 1] == found[1, 0] == PROBLEM.quantity(name, QUICK)


def test_unknown_quantity_is_named_with_the_known_ones() -> None:
    with pytest.raises(DeclarationError, match="'length'; it has total, duration 1, duration 2"):
        PROBLEM.quantity("length", SLOW)


def test_motion_at_rest_at_its_ends_starts_and_stops_slowly() -> None:
    still = replace(PROBLEM, ends="still")

    assert still.quantity("speed at the ends", SLOW) == pytest.approx(0.0, abs=1e-12)
    assert PROBLEM.quantity("speed at the ends", SLOW) > 0.1


@pytest.mark.parametrize(
    "changed", [{"velocity": (1.0,)}, {"nodes": ((0.0, 1.0), (2.0,))}, {"nodes": ((0.0, 1.0),)}]
)
def test_limits_and_nodes_of_other_joints_are_refused(changed: dict[str, object]) -> None:
    with pytest.raises(DeclarationError, match=r"number of joints|two or more"):
        replace(PROBLEM, **changed)  # type: ignore[arg-type]
