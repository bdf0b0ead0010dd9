import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from repro.errors import ReproError
from repro.robotics import MinimumTime, PolynomialMotion, RestToRestLaw
from repro.robotics.polynomial_motion import extremes, motion, shapes
from repro.robotics.proofs.least_time import least_time
from repro.robotics.proofs.polynomial_minimum import polynomial_minimum
from repro.robotics.proofs.proved import FREE, LeastTime
from repro.robotics.proofs.watch import ENDLESS, Watch
from tests.budgets import examples
from tests.robotics.proofs.test_least_time import ticking
from tests.robotics.test_rest_to_rest import problems

TWO = PolynomialMotion(
    waypoints=((0.0, 0.0), (1.0, -2.0), (1.5, 0.0)),
    degree=5,
    velocity=((-1.0, 1.0), (-2.0, 2.0)),
    acceleration=((-2.0, 2.0), (-3.0, 3.0)),
    durations=(0.01, 100.0),
)
SPEEDS = st.tuples(st.floats(-0.9, 0.9), st.floats(-1.9, 1.9))


def proved(problem: PolynomialMotion, watch: Watch = ENDLESS) -> LeastTime:
    return polynomial_minimum(problem, ("rad",) * problem.joints, watch)


def pairs(limits: tuple[float, ...]) -> tuple[tuple[float, float], ...]:
    return tuple((-limit, limit) for limit in limits)


@settings(max_examples=examples(20))
@given(problems())
def test_motion_from_rest_to_rest_takes_what_the_closed_form_says(problem: MinimumTime) -> None:
    assert isinstance(problem.law, RestToRestLaw)
    general = PolynomialMotion(
        waypoints=problem.waypoints,
        degree=problem.law.degree,
        velocity=pairs(problem.velocity),
        acceleration=pairs(problem.acceleration),
        jerk=pairs(problem.jerk) if problem.jerk else None,
        durations=problem.durations,
    )
    assert proved(general).minimum == pytest.approx(least_time(problem).minimum, rel=1e-8)


@given(SPEEDS, SPEEDS, st.sampled_from([3, 5, 7]))
def test_what_is_shown_obeys_and_what_is_a_little_shorter_does_not(
    start: tuple[float, float], end: tuple[float, float], degree: int
) -> None:
    problem = replace(TWO, start=start, end=end, degree=degree)
    found = proved(problem)
    assume(found.minimum is not None)

    assert problem.obeys(np.array(found.at))
    for segment in range(2):
        shorter = np.array(found.at)
        shorter[segment] *= 1 - 1e-6
        assert not problem.obeys(shorter)


@settings(max_examples=examples(20))
@given(SPEEDS, SPEEDS, st.floats(0.02, 0.999))
def test_no_duration_below_the_bound_obeys(
    start: tuple[float, float], end: tuple[float, float], share: float
) -> None:
    problem = replace(TWO, start=start, end=end)
    found = proved(problem)
    assume(found.at)

    for segment in range(2):
        shorter = np.array(found.at)
        shorter[segment] *= share
        assert not problem.obeys(shorter)


def test_motion_starts_and_ends_as_fast_as_it_is_told() -> None:
    problem = replace(TWO, start=(0.5, -1.0), end=(0.0, 1.5), degree=7)
    at = np.array(proved(problem).at)

    speeds = motion(problem, at, derivative=1, samples=5)[1]
    places = motion(problem, at, derivative=0, samples=5)[1]

    assert speeds[[0, -1]] == pytest.approx(np.array([[0.5, -1.0], [0.0, 1.5]]), abs=1e-9)
    assert speeds[[4, 5]] == pytest.approx(np.zeros((2, 2)), abs=1e-9)
    assert places[[0, 4, 5, -1]] == pytest.approx(np.array(TWO.waypoints)[[0, 1, 1, 2]], abs=1e-9)


def test_limit_in_one_direction_holds_back_that_direction_alone() -> None:
    slow = replace(TWO, velocity=((-1.0, 1.0), (-0.5, 2.0)))
    found, free = proved(slow), proved(TWO)

    assert found.at[0] == pytest.approx(2.0 * 15 / 8 / 0.5, rel=1e-8)
    assert found.at[1] == free.at[1]
    assert found.binding[0] == "segment 1: velocity of joint 2 (limit -0.5 rad/s)"


def test_jerk_of_a_quintic_is_greater_at_its_ends_than_in_its_middle() -> None:
    # s''' goes from 60 to -30 and back: a joint that moves back meets the lower limit at its ends
    one = replace(
        TWO, waypoints=((0.0, 0.0), (-1.0, 1e-9)), velocity=((-99.0, 99.0),) * 2,
        acceleration=((-999.0, 999.0),) * 2, jerk=((-60.0, 30.0),) * 2,
    )  # fmt: skip
    assert proved(one).minimum == pytest.approx(1.0, rel=1e-8)


def test_range_that_a_moving_start_overshoots_is_kept_or_said() -> None:
    kept = replace(TWO, start=(-0.5, 0.0), range=((-0.5, 2.0), (-9.0, 9.0)))
    left = replace(kept, range=((-1e-3, 2.0), (-9.0, 9.0)))

    low = extremes(kept, 0, 0, 0, proved(kept).at[0])[0]
    assert -0.5 <= low < -0.01
    found = proved(left)
    assert (found.minimum, found.at) == (None, ())
    assert "range of joint 1" in found.explanation


@pytest.mark.parametrize("degree", [11, 21, 31, 51])
def test_polynomials_of_any_odd_degree_are_proved(degree: int) -> None:
    k = (degree - 1) // 2
    peak = float(shapes(degree)[0][k + 1]) * (k + 1) / 4.0**k  # s' has its peak at 1/2
    one = replace(
        TWO, degree=degree, waypoints=((0.0, 0.0), (1.0, 0.5)),
        acceleration=((-1e6, 1e6),) * 2, velocity=((-1.0, 1.0),) * 2,
    )  # fmt: skip

    found = proved(one)

    assert found.minimum == pytest.approx(peak, rel=1e-7)
    assert found.gap is not None
    assert found.gap < 1e-6


@settings(max_examples=examples(10), deadline=None)
@given(st.floats(-15.0, 15.0), SPEEDS, st.sampled_from([FREE, TWO.durations]))
def test_limits_scaled_by_powers_of_c_scale_times_by_its_inverse(
    power: float, start: tuple[float, float], box: tuple[float, float]
) -> None:
    by = 10.0**power

    def slowed(limits: tuple[tuple[float, ...], ...], m: int) -> tuple[tuple[float, ...], ...]:
        return tuple(tuple(value / by**m for value in pair) for pair in limits)

    jerk = ((-9.0, 9.0), (-9.0, 8.0))
    moving = replace(TWO, start=start, jerk=jerk, durations=box)
    scaled = replace(
        moving,
        velocity=slowed(moving.velocity, 1),
        acceleration=slowed(moving.acceleration, 2),
        jerk=slowed(jerk, 3),
        start=tuple(speed / by for speed in start),
        durations=box if box == FREE else (box[0] * by, box[1] * by),
    )
    found, once = proved(scaled), proved(moving)

    assert found.minimum == pytest.approx(by * (once.minimum or 0.0), rel=1e-8)
    assert found.lower_bound == pytest.approx(by * (once.lower_bound or 0.0), rel=1e-8)


@pytest.mark.parametrize("limit", [1e-12, 1e-70])
def test_motion_that_takes_ages_is_proved_or_said_to_be_beyond_what_is_computed(
    limit: float,
) -> None:
    slow = replace(TWO, velocity=((-limit, limit),) * 2, durations=FREE)
    found = proved(slow)

    if limit == 1e-12:
        assert found.minimum == pytest.approx(4.0 / limit * 15 / 8, rel=1e-8)
        assert found.explanation == ""
    else:
        assert found.minimum is None
        assert found.explanation.startswith("No durations up to 1e+60 s obey: segment 1 (velocity")


@pytest.mark.parametrize("looks", [0, 1, 3, 10, 20, 30])
def test_proof_that_is_cut_short_shows_a_motion_beside_its_bound_and_no_minimum(looks: int) -> None:
    whole, cut = proved(TWO), proved(TWO, ticking(looks))

    assert cut.minimum is None
    assert cut.lower_bound == whole.lower_bound
    assert cut.attained == pytest.approx(whole.attained, rel=1e-6)
    assert TWO.obeys(np.array(cut.at))
    assert (cut.gap or 1.0) < 1e-6
    assert re.fullmatch(
        "The time was over before (segment 2 was|segments 1, 2 were) proved; that the motion "
        "obeys there is checked in doubles alone.",
        cut.explanation,
    )


def test_proof_with_time_enough_ends_as_one_without_a_clock() -> None:
    assert proved(TWO, ticking(9999)) == proved(TWO)


def test_box_that_nothing_obeys_is_said_where_the_time_is_over_too() -> None:
    assert proved(replace(TWO, durations=(0.01, 1.0)), ticking(0)).attained is None


def test_box_of_durations_is_obeyed_or_said() -> None:
    boxed, narrow = replace(TWO, durations=(9.0, 10.0)), replace(TWO, durations=(0.01, 1.0))

    assert proved(boxed).at == (9.0, 9.0)
    assert proved(boxed).binding[0] == "segment 1: shortest duration allowed (9 s)"
    assert proved(narrow).minimum is None
    assert proved(narrow).explanation.startswith("No durations from 0.01 to 1 s obey: segment 1")


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"velocity": ((1.0, 2.0),) * 2}, "velocity of joint 1: .* lowest < 0 < highest"),
        ({"velocity": ((-1.0, 1.0),)}, "2 joints need 2 pairs"),
        ({"range": ((2.0, 1.0),) * 2}, "range of joint 1: .* lowest < highest"),
        ({"range": ((-1.0, 1.2), (-9.0, 9.0))}, "joint 1 of number 3 is 1.5, outside its range"),
        ({"start": (3.0, 0.0)}, "start velocity of joint 1 is 3.0, outside its limits"),
        ({"end": (0.0,)}, "end velocity: 2 joints need 2, not 1"),
        ({"degree": 4}, "degree 4"),
        ({"waypoints": ((0.0, 0.0),)}, "two or more, not 1"),
    ],
)
def test_what_no_motion_has_is_refused(changed: dict[str, object], fault: str) -> None:
    with pytest.raises(ReproError, match=fault):
        replace(TWO, **changed)  # type: ignore[arg-type]


@pytest.mark.parametrize(("degree", "near"), [(5, 2e-5), (7, 2e-4), (11, 2e-3), (13, 1e-6)])
def test_motion_that_starts_at_its_limit_takes_until_it_no_longer_gains_speed(
    degree: int, near: float
) -> None:
    """By hand, degree 5: T·v is T·v0 + τ²·(30 D - 18 T·v0) + …, so that T >= 5 D / (3 v0)."""
    own = PolynomialMotion(
        waypoints=((0.0,), (90.0,)), degree=degree, velocity=((-180.0, 180.0),),
        acceleration=((-1000.0, 1000.0),), start=(180.0,), durations=FREE,
    )  # fmt: skip

    found = proved(own)

    assert found.lower_bound is not None
    assert found.lower_bound <= degree / (degree + 1) <= (found.attained or 0.0)
    assert found.attained == pytest.approx(found.lower_bound, rel=near)


@pytest.mark.parametrize("limit", [1e-85, 1e-92])
def test_root_that_doubles_do_not_hold_is_approached(limit: float) -> None:
    """From 1e-60 s on, a jerk needs 1e43 s or more: the cube of their ratio is no double."""
    own = PolynomialMotion(
        waypoints=((0.0,), (1e45,)), degree=5, velocity=((-1e90, 1e90),),
        acceleration=((-1e90, 1e90),), jerk=((-limit, limit),), durations=FREE,
    )  # fmt: skip
    expected = (60 * 1e45 / limit) ** (1 / 3)

    assert proved(own).minimum == pytest.approx(expected, rel=1e-5)
