import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.robotics.proofs.limit_rows import (
    Bend,
    Box,
    bend,
    cut,
    dot,
    exact,
    rounded_down,
    smallest,
)
from repro.robotics.spline_motion import motion
from tests.robotics.test_directed_spline import DIRECTED
from tests.robotics.test_spline_motion import PROBLEM

MODEL = exact(DIRECTED)
seconds = st.fractions(Fraction(1, 10), 10, max_denominator=100)
durations = st.lists(seconds, min_size=PROBLEM.segments, max_size=PROBLEM.segments)
places = st.fractions(0, 1, max_denominator=50)
joints = st.sampled_from(range(len(PROBLEM.velocity)))
spans = st.sampled_from(range(PROBLEM.segments))
signs = st.sampled_from([-1, 1])


def keeps(limit: Bend, h: list[Fraction]) -> bool:
    return dot(limit.slope, h) ** 3 >= dot(limit.turn, h)


@given(spans, joints, st.sampled_from([0, 1]), signs, durations)
def test_rows_are_the_velocity_and_acceleration_of_the_motion(
    span: int, joint: int, u: int, sign: int, h: list[Fraction]
) -> None:
    own = cut(MODEL, span, joint, Fraction(u))
    other = bend(MODEL, span, joint, Fraction(u), sign=sign)
    slope, turn = dot(other.slope, h), dot(other.turn, h)
    if slope < Fraction(1, 100):
        return
    with np.errstate(divide="ignore", invalid="ignore"):  # time may stand still at other instants
        found = [
            motion(PROBLEM, np.array(h, dtype=np.float64), derivative=k, samples=2)[1][2 * span + u]
            for k in (1, 2)
        ]

    speed = own.least * MODEL.velocity[joint][own.sign > 0] / dot(own.weights, h)
    bending = turn * MODEL.acceleration[joint][sign > 0] / slope**3
    assert float(speed) == pytest.approx(found[0][joint], rel=1e-9, abs=1e-9)
    # by doubles, terms that cancel are divided by slope³: at 0.0107 that was seen to leave 5e-9
    slack = 1e-9 + 5e-14 / float(slope) ** 3
    assert float(bending) == pytest.approx(found[1][joint], rel=1e-9, abs=slack)


@given(spans, joints, places, signs, durations, durations, st.data())
def test_what_obeys_in_a_box_fulfils_the_chord(
    span: int,
    joint: int,
    u: Fraction,
    sign: int,
    one: list[Fraction],
    other: list[Fraction],
    data: st.DataObject,
) -> None:
    limit = bend(MODEL, span, joint, u, sign=sign)
    box: Box = tuple((min(pair), max(pair)) for pair in zip(one, other, strict=True))
    h = [
        data.draw(st.fractions(*side, max_denominator=100)) if side[0] < side[1] else side[0]
        for side in box
    ]
    weights, least = limit.row(box)

    if dot(limit.slope, h) >= limit.least and keeps(limit, h):
        assert dot(weights, h) >= least


@given(spans, joints, places, signs, durations, durations)
def test_what_fulfils_the_tangent_obeys(
    span: int, joint: int, u: Fraction, sign: int, at: list[Fraction], h: list[Fraction]
) -> None:
    limit = bend(MODEL, span, joint, u, sign=sign)
    weights, least = limit.row(tuple((side, side) for side in at))

    if dot(limit.slope, h) >= 0 and dot(weights, h) >= least:
        assert keeps(limit, h)


def test_smallest_value_is_that_of_a_corner() -> None:
    box = ((Fraction(1), Fraction(2)), (Fraction(3), Fraction(5)))

    assert smallest([Fraction(2), Fraction(-1)], box) == 2 - 5


@given(st.fractions())
def test_number_is_rounded_to_a_double_below(number: Fraction) -> None:
    below = rounded_down(number)

    assert below <= number
    assert float(below) == below
    assert number - below <= 2 * Fraction(math.ulp(float(below)))
