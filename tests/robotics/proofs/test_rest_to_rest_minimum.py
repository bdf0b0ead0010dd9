from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from papers.liang2026 import FANUC
from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError
from repro.robotics import MinimumTime
from repro.robotics.fixed_penalties import cheapest
from repro.robotics.proofs.least_time import least_time
from repro.robotics.rest_to_rest import peaks
from tests.robotics.test_rest_to_rest import TWO, cost, problems


def test_shortest_motion_of_the_fanuc_obeys_its_own_limits() -> None:
    assert FANUC.kernel(FANUC.shortest(), FANUC.data) == pytest.approx(4.478245)


@given(problems())
def test_certified_optimum_obeys_in_doubles(problem: MinimumTime) -> None:
    found = least_time(problem)
    at = np.array(found.at)

    assert ready(problem.kernel, COST)(at, problem.data) == pytest.approx(at.sum(), rel=1e-15)
    assert problem.obeys(at)
    for m, limits in enumerate(problem.limits, start=1):
        assert (peaks(problem, found.at, m) <= limits).all()


@given(problems())
def test_what_is_shown_is_longer_than_the_bound_by_a_few_roundings(problem: MinimumTime) -> None:
    found = least_time(problem)

    assert found.minimum == found.attained
    assert found.lower_bound is not None
    assert found.attained is not None
    assert 0 < found.attained - found.lower_bound < 1e-14 * found.attained
    assert not problem.obeys(np.array(found.at) * (1 - 1e-14))


@given(problems(), st.tuples(*[st.floats(0.0, 9.0)] * 3))
def test_least_cost_under_fixed_penalties_is_what_its_durations_cost(
    problem: MinimumTime, penalties: tuple[float, float, float]
) -> None:
    priced = replace(problem, handling="fixed penalties", penalties=penalties)
    least = cheapest(priced)
    # a penalty is paid or not: at a duration that meets a limit nothing lies between
    assert cost(priced, least.durations) == pytest.approx(least.cost, rel=1e-14, abs=1e-14)


@given(problems(), st.floats(0.1, 9.0), st.floats(0.1, 9.0))
def test_minimum_is_that_of_the_durations_allowed(
    problem: MinimumTime, low: float, high: float
) -> None:
    assume(low <= high)
    boxed = replace(problem, durations=(low, high))
    needed = problem.shortest()
    found = least_time(boxed)

    assert found.box == (low, high)
    if (needed <= high).all():
        assert found.minimum == pytest.approx(np.maximum(needed, low).sum(), rel=1e-14)
        assert all(low <= duration <= high for duration in found.at)
    elif (needed > high * (1 + 1e-12)).any():
        assert (found.minimum, found.attained, found.at) == (None, None, ())
        assert "No durations from" in found.explanation


def test_box_that_makes_a_motion_longer_is_what_binds() -> None:
    found = least_time(replace(FANUC, durations=(3.0, 5.0)))

    assert found.minimum == 6.0
    assert found.at == (3.0, 3.0)
    assert found.binding[0] == "segment 1: shortest duration allowed (3 s)"


def test_box_that_no_motion_obeys_is_said_with_the_segment_and_its_limit() -> None:
    found = least_time(replace(FANUC, durations=(0.1, 1.0)))

    assert found.minimum is None
    assert found.lower_bound == pytest.approx(4.478245)
    assert found.explanation.startswith(
        "No durations from 0.1 to 1 s obey: segment 1 takes 2.59742 s or more (acceleration of "
        "joint 3 (limit 3.5 rad/s²)); segment 2 takes 1.88083 s or more"
    )


def test_bound_whatever_the_durations_knows_no_shortest_duration() -> None:
    own = replace(TWO, waypoints=((0.0, 0.0), (0.1, 0.0), (1.5, 0.0)), durations=(1.0, 1.2))
    free = least_time(replace(own, durations=(1e-3, 99.0)))
    found = least_time(own)

    assert found.lower_bound == free.lower_bound
    assert found.explanation.endswith(f"a motion that obeys takes {free.minimum:.6g} s or more.")


@pytest.mark.parametrize("power", range(-3, 6))
def test_fast_and_slow_motions_are_proved_alike(power: int) -> None:
    by = 10.0**power
    scaled = replace(
        TWO,
        velocity=tuple(limit / by for limit in TWO.velocity),
        acceleration=tuple(limit / by**2 for limit in TWO.acceleration),
        durations=(0.1 * by, 9.0 * by),
    )
    found, one = least_time(scaled), least_time(TWO)

    assert found.minimum == pytest.approx(by * (one.minimum or 0.0), rel=1e-14)
    assert found.gap is not None
    assert found.gap < 1e-14


def test_two_equal_waypoints_are_refused_before_anything_is_divided_by_their_distance() -> None:
    with pytest.raises(DeclarationError, match="waypoints 1 and 2 are equal"):
        replace(TWO, waypoints=((1.0, 2.0), (1.0, 2.0)))
