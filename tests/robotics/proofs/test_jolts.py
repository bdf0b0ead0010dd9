from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from repro.robotics.proofs.jolts import DIGITS, Jolt, doubles, jolt, jolt_rows
from repro.robotics.proofs.limit_rows import Box, dot, exact
from repro.robotics.spline_motion import motion
from tests.robotics.proofs.test_limit_rows import durations, joints, places, seconds, signs, spans
from tests.robotics.test_spline_jerk import LIMITED
from tests.robotics.test_spline_motion import BACKWARDS, PROBLEM

MODEL = exact(LIMITED)
ratios = st.floats(-20.0, 20.0)
room = st.sampled_from([0, 1, 10**-1, 10**-3]).map(Fraction)  # shares of a duration


def broken(limit: Jolt, h: list[Fraction]) -> Fraction:
    """Return by how much a jerk is beyond its limit, times dt/du⁵ over the limit."""
    slope, rate = dot(limit.slope, h), dot(limit.rate, h)
    return dot(limit.turn, h) * slope + limit.share * rate**2 - slope**5


@given(spans, joints, st.sampled_from([0, 1]), signs, durations)
def test_limit_is_the_jerk_of_the_motion(
    span: int, joint: int, u: int, sign: int, h: list[Fraction]
) -> None:
    limit = jolt(MODEL, span, joint, Fraction(u), sign=sign, ratio=0.0)
    slope = dot(limit.slope, h)
    assume(slope > Fraction(1, 10))
    with np.errstate(all="ignore"):  # time may stand still at other instants
        times = np.array(h, dtype=np.float64)
        _, found = motion(PROBLEM, times, derivative=3, samples=2)

    share = float((broken(limit, h) + slope**5) / slope**5)
    assert MODEL.jerk is not None
    asked = share * float(MODEL.jerk[joint][sign > 0])
    assert asked == pytest.approx(found[2 * span + u][joint], rel=1e-9, abs=1e-8)


def just_slow_enough(limit: Jolt, h: list[Fraction]) -> list[Fraction]:
    """Return a motion scaled until it just obeys the limit, and the velocity limits there."""
    slope = dot(limit.slope, h)
    assume(slope > Fraction(1, 10))
    share = float(broken(limit, h) / slope**5 + 1)
    scale = max(limit.least / slope, Fraction(max(share, 0.0) ** (1 / 3) * (1 + 1e-12)))
    assume(scale > 0)
    return [scale * each for each in h]


@settings(suppress_health_check=[HealthCheck.filter_too_much])
@given(spans, joints, places, signs, ratios, durations, st.lists(room, min_size=6, max_size=6))
def test_what_just_obeys_in_a_box_fulfils_the_row(
    span: int,
    joint: int,
    u: Fraction,
    sign: int,
    ratio: float,
    direction: list[Fraction],
    sides: list[Fraction],
) -> None:
    limit = jolt(MODEL, span, joint, u, sign=sign, ratio=ratio)
    h = just_slow_enough(limit, direction)
    around = zip(h, sides[:3], sides[3:], strict=True)
    box: Box = tuple((each / (1 + below), each * (1 + above)) for each, below, above in around)
    assert broken(limit, h) <= 0
    weights, least = limit.row(box)

    assert dot(weights, h) >= least


@given(spans, joints, places, signs, durations)
def test_row_of_one_motion_holds_for_it_just_where_it_obeys(
    span: int, joint: int, u: Fraction, sign: int, h: list[Fraction]
) -> None:
    slopes = jolt(MODEL, span, joint, u, sign=sign, ratio=0.0)
    slope = dot(slopes.slope, h)
    assume(slope > Fraction(1, 10) and slope >= slopes.least)
    ratio = float(dot(slopes.rate, h) / slope)
    limit = jolt(MODEL, span, joint, u, sign=sign, ratio=ratio)
    weights, least = limit.row(tuple((each, each) for each in h))
    room = dot(weights, h) - least

    # but for the digits that the ratio loses, and those of sides that are rounded outwards
    lost = abs(limit.share) * slope / DIGITS**2 + Fraction(1, 10**9)
    assert abs(room + broken(limit, h) / slope) <= lost


@settings(suppress_health_check=[HealthCheck.filter_too_much])
@given(spans, joints, places, ratios, durations, st.lists(seconds, min_size=3, max_size=3))
def test_what_a_row_loses_falls_with_the_square_of_the_box(
    span: int,
    joint: int,
    u: Fraction,
    ratio: float,
    low: list[Fraction],
    width: list[Fraction],
) -> None:
    both = (jolt(MODEL, span, joint, u, sign=sign, ratio=ratio) for sign in (-1, 1))
    limit = min(both, key=lambda each: each.share)
    lost = []
    for part in (10**3, 10**4):
        box: Box = tuple((a, a + w / part) for a, w in zip(low, width, strict=True))
        middle = [sum(side, Fraction(0)) / 2 for side in box]
        slope = dot(limit.slope, middle)
        assume(slope > Fraction(1, 10) and slope >= limit.least)
        weights, least = limit.row(box)
        lost.append(dot(weights, middle) - least + broken(limit, middle) / slope)

    assert lost[0] > -Fraction(1, 10**9)
    assert lost[1] <= lost[0] / 50 + Fraction(1, 10**9)


@given(spans, joints, places, signs, ratios, durations, durations)
def test_rows_in_doubles_are_the_exact_ones(
    span: int,
    joint: int,
    u: Fraction,
    sign: int,
    ratio: float,
    one: list[Fraction],
    other: list[Fraction],
) -> None:
    limit = jolt(MODEL, span, joint, u, sign=sign, ratio=ratio)
    box: Box = tuple((min(pair), max(pair)) for pair in zip(one, other, strict=True))
    weights, least = limit.row(box)
    found = jolt_rows([doubles(limit)], np.array(box, dtype=np.float64))

    size = max(map(abs, (*weights, least, Fraction(1))))
    assert found[0][0] == pytest.approx(list(map(float, weights)), abs=1e-9 * float(size))
    assert found[1][0] == pytest.approx(float(least), abs=1e-9 * float(size))
    assert (found[2] >= 0.0).all()


def test_limit_asks_nothing_of_a_box_in_which_time_may_stand_still() -> None:
    falling = [jolt(MODEL, 1, 0, Fraction(1, 2), sign=sign, ratio=0.0) for sign in (-1, 1)]
    (limit,) = (each for each in falling if each.share < 0)
    box: Box = ((Fraction(0), Fraction(10**9)),) * 3

    assert limit.row(box) == ((Fraction(0),) * 3, Fraction(0))
    assert not jolt_rows([doubles(limit)], np.array(box, dtype=np.float64))[0].any()


def test_limit_asks_nothing_where_time_runs_backwards_and_velocities_are_free() -> None:
    model = exact(replace(LIMITED, velocity=((-1e90, 1e90),) * 2))
    box: Box = tuple((Fraction(h), Fraction(h)) for h in BACKWARDS.tolist())
    behind = [
        limit
        for span, sixteenth, sign in product(range(3), range(1, 16), (-1, 1))
        for limit in [jolt(model, span, 0, Fraction(sixteenth, 16), sign=sign, ratio=0.0)]
        if limit.share < 0 and dot(limit.slope, [low for low, _ in box]) < 0
    ]
    assert behind

    weights, least, _ = jolt_rows(list(map(doubles, behind)), np.array(box, dtype=np.float64))

    assert not weights.any()
    assert not least.any()
    assert {limit.row(box) for limit in behind} == {((Fraction(0),) * 3, Fraction(0))}
