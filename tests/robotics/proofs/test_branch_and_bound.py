import itertools
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.robotics import MinimumTimeSpline
from repro.robotics.proofs import branch_and_bound
from repro.robotics.proofs.branch_and_bound import BOXES, NEAR, Bound, least_total, tightened
from repro.robotics.proofs.descent import descended, just_obeying
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Bend, Box, exact
from repro.robotics.proofs.linear_programmes import weighed
from tests.robotics.test_spline_motion import BACKWARDS, PROBLEM

Vector = NDArray[np.float64]
HEAVY = replace(PROBLEM, acceleration=(0.2, 0.3))
START = just_obeying(HEAVY, np.ones(3))
WIDE: Box = ((Fraction(0), Fraction(40)),) * 3
shares = st.floats(0.05, 1.0)


def bound(problem: MinimumTimeSpline) -> Bound:
    starts = just_obeying(problem, np.ones((1, 3)))
    return least_total(problem, Limits(exact(problem), []), starts)


BOUND = bound(HEAVY)
FAST = float(BOUND.motion.sum()) * 1.05
TIGHT = tightened(Limits(exact(HEAVY), []), WIDE, Fraction(FAST)) or ()


def test_bound_is_near_a_motion_that_obeys() -> None:
    assert 0 <= 1 - float(BOUND.lower) / BOUND.motion.sum() <= NEAR
    assert max(HEAVY.peak_shares(BOUND.motion)) == pytest.approx(1, abs=1e-6)
    assert 1 < BOUND.boxes < BOXES


@given(st.tuples(shares, shares, shares))
def test_no_motion_that_obeys_beats_the_bound(direction: tuple[float, float, float]) -> None:
    motion = just_obeying(HEAVY, np.array(direction))

    assert motion.sum() >= float(BOUND.lower)


@given(st.tuples(shares, shares, shares))
def test_tightened_box_keeps_every_motion_that_is_fast_enough(
    direction: tuple[float, float, float],
) -> None:
    motion = just_obeying(HEAVY, np.array(direction)) * (1 + 1e-12)
    if not np.isfinite(motion).all():
        return
    for (low, high), duration in zip(TIGHT, motion, strict=True):
        assert motion.sum() > FAST or low <= duration <= high


def test_box_is_tightened_on_every_side() -> None:
    assert len(TIGHT) == 3
    for (low, high), (least, most) in zip(TIGHT, WIDE, strict=True):
        assert least < low < high < most


def test_box_without_a_motion_fast_enough_is_empty() -> None:
    assert tightened(Limits(exact(HEAVY), []), WIDE, Fraction(1)) is None


@given(
    st.lists(st.fractions(0, 100, max_denominator=1000), min_size=3, max_size=3),
    st.tuples(shares, shares, shares),
)
def test_any_weights_give_a_bound(weights: list[Fraction], at: tuple[float, float, float]) -> None:
    box: Box = ((Fraction(0), Fraction(1)),) * 3
    rows = [
        ((Fraction(1), Fraction(2), Fraction(-1)), Fraction(1)),
        ((Fraction(0), Fraction(1), Fraction(1)), Fraction(1, 2)),
        ((Fraction(-1), Fraction(1), Fraction(0)), Fraction(-1)),
    ]
    h = list(map(Fraction, at))
    obeys = all(sum(w * x for w, x in zip(row, h, strict=True)) >= least for row, least in rows)

    assert not obeys or sum(h) >= weighed((Fraction(1),) * 3, rows, weights, box)


def test_weights_that_add_up_to_the_objective_leave_nothing_to_the_box() -> None:
    box: Box = ((Fraction(0), Fraction(100)),) * 2
    rows = [((Fraction(1), Fraction(0)), Fraction(2)), ((Fraction(0), Fraction(1)), Fraction(3))]

    assert weighed((Fraction(1),) * 2, rows, [Fraction(1)] * 2, box) == 5


def test_search_goes_down_to_a_motion_that_no_small_change_makes_faster() -> None:
    limits = Limits(exact(HEAVY), [])
    rng = np.random.default_rng(1)

    best, holding = descended(HEAVY, limits, START)

    assert best.sum() < START.sum()
    near = best + 1e-3 * rng.normal(size=(500, 3))
    assert min(just_obeying(HEAVY, each).sum() for each in near) >= best.sum() - 1e-7
    assert any(isinstance(limit, Bend) for limit in holding)


def test_time_that_runs_backwards_never_arrives() -> None:
    assert np.isinf(just_obeying(HEAVY, BACKWARDS)).all()


def test_bound_holds_when_the_boxes_run_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(branch_and_bound, "BOXES", 2)
    early = bound(HEAVY)

    assert early.boxes == 2
    assert 0 < early.lower < BOUND.lower


def test_bound_is_the_lowest_of_boxes_that_are_closed_early(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(branch_and_bound, "NEAR", 0.05)
    loose = bound(HEAVY)

    assert loose.boxes < BOUND.boxes
    assert loose.motion.sum() * 0.95 <= loose.lower < BOUND.lower


def test_bound_is_that_of_a_grid_of_directions() -> None:
    scaled = replace(HEAVY, handling="time scaling")
    directions = np.array(list(itertools.product(np.linspace(0.2, 1.0, 41), repeat=3)))
    forwards = np.isfinite(scaled.peak_shares(directions)).all(axis=-1)
    grid = scaled.obeying(directions[forwards]).sum(axis=-1).min()

    assert float(BOUND.lower) <= grid <= 1.01 * float(BOUND.lower)
