from dataclasses import replace

import numpy as np
import pytest

from repro.robotics import DirectedSpline, MinimumTimeSpline, cubic
from repro.robotics.own_motion import OwnMotion, increasing, joints_of, points_of, sampled
from tests.robotics.proofs.test_polynomial_minimum import TWO as POLYNOMIAL
from tests.robotics.test_rest_to_rest import TWO

SPLINE = MinimumTimeSpline(
    nodes=TWO.waypoints, velocity=TWO.velocity, acceleration=TWO.acceleration, durations=(0.1, 9.0)
)
DIRECTED = DirectedSpline(
    nodes=TWO.waypoints,
    velocity=((-1.0, 2.0),) * 2,
    acceleration=((-3.0, 2.0),) * 2,
    durations=(0.1, 9.0),
)


@pytest.mark.parametrize("problem", [TWO, replace(TWO, law=cubic), POLYNOMIAL, SPLINE, DIRECTED])
def test_every_kind_of_motion_goes_through_its_waypoints(problem: OwnMotion) -> None:
    times, places = sampled(problem, np.array([2.0, 3.0]), derivative=0, samples=7)
    kept = increasing(times)

    assert joints_of(problem) == 2
    assert points_of(problem) == TWO.waypoints
    assert (np.diff(times[kept]) > 0.1).all()
    assert len(kept) == 13
    assert places[kept[[0, 6, 12]]] == pytest.approx(np.array(TWO.waypoints), abs=1e-12)


def test_of_two_samples_at_a_waypoint_the_one_of_the_next_segment_stays() -> None:
    times = np.array([0.0, 1.0, 1.0, 2.0, 2.0 + 1e-16, 3.0])

    assert increasing(times).tolist() == [0, 2, 4, 5]
