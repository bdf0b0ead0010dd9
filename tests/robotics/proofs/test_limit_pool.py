from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from repro.robotics.proofs.jolts import Jolt, Limit, jolt
from repro.robotics.proofs.limit_pool import SAMPLES, Limits
from repro.robotics.proofs.limit_rows import Bend, Cut, Rationals, bend, cut, dot, exact
from tests.robotics.test_directed_spline import DIRECTED
from tests.robotics.test_spline_jerk import LIMITED

MODEL = exact(DIRECTED)
MISSED = 1e3 * (1 / SAMPLES**2) ** 2 / 8  # by the finer grid of a peak whose curvature is 10³
BOX = ((Fraction(1), Fraction(2)), (Fraction(3, 2), Fraction(5, 2)), (Fraction(1, 2), Fraction(3)))


def test_rows_in_doubles_are_the_exact_ones() -> None:
    limits = Limits(MODEL, [cut(MODEL, 1, 0, Fraction(1, 3))])

    weights, least, _ = limits.rows(np.array(BOX, dtype=np.float64))

    assert len(weights) == len(limits.known)
    for row, bound, limit in zip(weights, least, limits.known, strict=True):
        own = limit.row(BOX)
        assert row == pytest.approx(list(map(float, own[0])), rel=1e-9, abs=1e-9)
        assert bound == pytest.approx(float(own[1]), rel=1e-9, abs=1e-9)


def test_rows_stand_in_the_order_of_the_limits_those_of_the_jerk_between_others() -> None:
    limits = Limits(exact(LIMITED), [cut(MODEL, 1, 0, Fraction(1, 3))])
    for u in (Fraction(1, 3), Fraction(2, 3)):
        limits.add_jolt(1, 1, u, -1, ratio=0.5)
        limits.add_jolt(1, 1, u, 1, ratio=0.5)
        limits.add(1, 1, u, 1)

    weights, least, _ = limits.rows(np.array(BOX, dtype=np.float64))

    for row, bound, limit in zip(weights, least, limits.known, strict=True):
        own = limit.row(BOX)
        assert row == pytest.approx(list(map(float, own[0])), rel=1e-9, abs=1e-9)
        assert bound == pytest.approx(float(own[1]), rel=1e-9, abs=1e-9)


def test_limit_of_the_jerk_is_added_once_for_each_ratio_where_that_plays_a_part() -> None:
    limits = Limits(exact(LIMITED), [])
    place = (1, 0, Fraction(1, 2))
    rising = jolt(limits.model, *place, sign=1, ratio=0.0).share > 0
    convex, concave = (1, -1) if rising else (-1, 1)

    assert limits.add_jolt(*place, convex, ratio=0.25)
    assert not limits.add_jolt(*place, convex, ratio=0.25)
    assert limits.add_jolt(*place, convex, ratio=0.5)
    assert limits.add_jolt(*place, concave, ratio=0.25)
    assert not limits.add_jolt(*place, concave, ratio=0.5)


def test_limit_is_added_once() -> None:
    limits = Limits(MODEL, [])
    before = len(limits.known)

    assert limits.add(0, 1, Fraction(1, 7), -1)
    assert not limits.add(0, 1, Fraction(1, 7), -1)
    assert len(limits.known) == before + 1


def excess(limit: Limit, durations: Rationals) -> float:
    """Return by which share a limit is broken."""
    if isinstance(limit, Jolt):
        slope, rate = dot(limit.slope, durations), dot(limit.rate, durations)
        jerk = dot(limit.turn, durations) + limit.share * rate**2 / slope
        return float(jerk / slope**4 - 1)
    if isinstance(limit, Cut):
        return float(limit.least / dot(limit.weights, durations) - 1)
    return float(dot(limit.turn, durations) / dot(limit.slope, durations) ** 3 - 1)


def test_added_limits_are_the_worst_of_their_span_and_joint() -> None:
    model = exact(LIMITED)
    limits, durations = Limits(model, []), (Fraction(3), Fraction(1), Fraction(2))
    start = len(limits.known)
    every = [Fraction(k, 300) for k in range(301)]

    added = limits.add_worst(np.array(durations, dtype=np.float64))

    fresh = limits.known[start:]
    assert added == len(fresh) > 0
    assert {type(each) for each in fresh} == {Cut, Bend, Jolt}
    for each in fresh:
        at = excess(each, durations)
        if isinstance(each, Cut):
            others: list[Limit] = [cut(MODEL, each.span, each.joint, u) for u in every]
        elif isinstance(each, Jolt):
            place, sign = (each.span, each.joint), each.sign
            others = [jolt(model, *place, u, sign=sign, ratio=0.0) for u in every]
        else:
            others = [bend(MODEL, each.span, each.joint, u, sign=each.sign) for u in every]
        assert at > 0
        assert at >= max(excess(other, durations) for other in others) - MISSED


def test_limits_on_the_side_that_a_motion_keeps_are_not_added() -> None:
    lopsided = replace(DIRECTED, velocity=((-99.0, 0.1),) * 2, acceleration=((-99.0, 0.1),) * 2)
    limits = Limits(exact(lopsided), [])
    start = len(limits.known)

    limits.add_worst(np.array([2.0, 4.0, 3.0]))

    fresh = limits.known[start:]
    assert {type(each) for each in fresh} == {Cut, Bend}
    assert {each.sign for each in fresh} == {1}


def test_motion_that_obeys_adds_nothing() -> None:
    limits = Limits(MODEL, [])

    assert limits.add_worst(np.full(3, 50.0)) == 0
