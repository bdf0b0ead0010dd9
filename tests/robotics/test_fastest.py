import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import linprog

from repro.robotics import MinimumTime, RestToRestLaw, quintic, septic
from repro.robotics.fastest import fastest, fastest_joints

SIZES = st.floats(0.01, 100.0)
CASES = [
    (10.0, 1.0, 2.0, 5.0),  # all three limits are reached
    (1.0, 9.0, 2.0, 50.0),  # the velocity limit is not
    (1.0, 9.0, 9.0, 5.0),  # nor the acceleration limit
    (1.0, 0.3, 9.0, 0.5),  # velocity, but not acceleration
]


def longest_way(time: float, velocity: float, acceleration: float, jerk: float) -> float:
    """Return how far a joint comes from rest to rest with a jerk that is constant in 200 steps."""
    steps = 200
    h = time / steps
    ones = np.tril(np.ones((steps, steps)))
    a = h * ones
    before = np.vstack([np.zeros(steps), a[:-1]])
    v = ones @ (h * before + h**2 / 2 * np.eye(steps))
    faster = np.vstack([np.zeros(steps), v[:-1]])
    way = (h * faster + h**2 / 2 * before + h**3 / 6 * np.eye(steps)).sum(axis=0)
    found = linprog(
        -way,
        A_ub=np.vstack([a, -a, v, -v]),
        b_ub=np.repeat([acceleration, velocity], 2 * steps),
        A_eq=np.vstack([a[-1], v[-1]]),
        b_eq=[0.0, 0.0],
        bounds=(-jerk, jerk),
    )
    return float(-found.fun)


@pytest.mark.parametrize(("distance", "velocity", "acceleration", "jerk"), CASES)
def test_no_jerk_takes_a_joint_further_in_the_least_time(
    distance: float, velocity: float, acceleration: float, jerk: float
) -> None:
    time = fastest(distance, velocity=velocity, acceleration=acceleration, jerk=jerk)

    furthest = longest_way(time, velocity, acceleration, jerk)

    # 200 steps cannot switch at the best instants, and see the speed at their ends only
    assert 0.999 * distance <= furthest <= 1.0001 * distance


def test_least_times_of_known_profiles_are_met() -> None:
    free = {"velocity": 1e9, "acceleration": 1e9, "jerk": math.inf}

    assert fastest(8.0, **(free | {"acceleration": 2.0})) == pytest.approx(2 * math.sqrt(4.0))
    assert fastest(3.0, **(free | {"velocity": 2.0})) == pytest.approx(1.5)
    assert fastest(32.0, **(free | {"jerk": 1.0})) == pytest.approx(4 * 16 ** (1 / 3))
    assert fastest(0.0, **free) == 0.0
    assert fastest(0.0, velocity=1.0, acceleration=1.0, jerk=1.0) == 0.0


@given(SIZES, SIZES, SIZES, SIZES, st.floats(1.0, 5.0))
def test_least_time_scales_with_units_of_length_and_time(
    distance: float, velocity: float, acceleration: float, jerk: float, scale: float
) -> None:
    time = fastest(distance, velocity=velocity, acceleration=acceleration, jerk=jerk)
    slower = fastest(
        distance,
        velocity=velocity / scale,
        acceleration=acceleration / scale**2,
        jerk=jerk / scale**3,
    )
    longer = fastest(
        scale * distance,
        velocity=scale * velocity,
        acceleration=scale * acceleration,
        jerk=scale * jerk,
    )

    assert slower == pytest.approx(scale * time)
    assert longer == pytest.approx(time)


@given(SIZES, SIZES, SIZES, SIZES, st.sampled_from([quintic, septic]))
def test_no_polynomial_beats_the_least_time(
    distance: float, velocity: float, acceleration: float, jerk: float, law: RestToRestLaw
) -> None:
    # a quintic starts with a jump of jerk, which the least-time motion does too
    problem = MinimumTime(
        waypoints=((0.0,), (distance,)),
        law=law,
        velocity=(velocity,),
        acceleration=(acceleration,),
        jerk=(jerk,),
        durations=(0.1, 1.0),
    )

    assert fastest_joints(problem)[0] <= problem.shortest().sum() * (1 + 1e-9)


def test_least_time_is_that_of_each_joint_between_first_and_last_waypoint() -> None:
    problem = MinimumTime(
        waypoints=((0.0, 1.0), (5.0, 0.0), (2.0, 0.0)),
        law=septic,
        velocity=(1.0, 1e9),
        acceleration=(1e9, 4.0),
        durations=(0.1, 1.0),
    )

    assert fastest_joints(problem) == pytest.approx((2.0, 1.0))
