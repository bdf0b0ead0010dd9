"""The least time of splines whose jerk is limited, by hand and beside a plain search."""

import itertools
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize

import repro
from repro.robotics import DirectedSpline
from repro.robotics.bsplines import Ends
from repro.robotics.proofs.branch_and_bound import NEAR
from repro.robotics.proofs.descent import descended, just_obeying
from repro.robotics.proofs.jolts import Jolt
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import exact
from repro.robotics.proofs.proved import GAP
from repro.robotics.proofs.spline_minimum import _obeys, prove
from tests.robotics.proofs.test_directed_minimum import SCIPY, pairs, proved

Vector = NDArray[np.float64]
SEEDS = range(6)
shares = st.floats(0.05, 1.0)
LINE = DirectedSpline(
    nodes=((0.0,), (2.0,)),
    velocity=((-1.0, 1.5),),
    acceleration=((-2.0, 2.0),),
    jerk=((-3.0, 4.0),),
    durations=(0.01, 100.0),
    ends="still",
    time_ends="natural",
)


def problem(seed: int, segments: int = 2) -> DirectedSpline:
    rng = np.random.default_rng(seed)
    return DirectedSpline(
        nodes=rng.uniform(-2.0, 2.0, (segments + 1, 2)),  # type: ignore[arg-type] # arrays are taken
        velocity=pairs(rng, 4.0),
        acceleration=pairs(rng, 8.0),
        jerk=pairs(rng, 3.0),
        durations=(0.01, 100.0),
        ends="still" if seed % 2 else "natural",
        time_ends="natural",
    )


@pytest.mark.parametrize(
    ("jerk", "least"),
    [
        # between rests q = D(3u² - 2u³), t = hu: peaks 3D/2h, 6D/h² and 12D/h³, the last downwards
        (((-1.0, 0.01),), (12 * 2 / 1) ** (1 / 3)),
        (((-300.0, 0.01),), (6 * 2 / 2) ** (1 / 2)),
        (((-0.3, 4.0),), (12 * 2 / 0.3) ** (1 / 3)),
    ],
)
def test_straight_line_between_rests_takes_what_is_done_by_hand(
    jerk: tuple[tuple[float, float]], least: float
) -> None:
    found = repro.certify(replace(LINE, jerk=jerk))

    assert found.minimum == pytest.approx(least, rel=GAP)
    assert (found.lower_bound or 9e9) <= least <= (found.attained or 0.0)


@pytest.mark.parametrize("ends", ["repeated", "still", "natural"])
@pytest.mark.parametrize("jerk", [0.1, 10.0, 1e6])
def test_one_segment_takes_the_longest_that_one_of_its_limits_asks(ends: Ends, jerk: float) -> None:
    own = replace(problem(1, 1), ends=ends, time_ends="repeated", jerk=((-jerk, jerk),) * 2)
    velocity, acceleration, sharp = own.peak_shares(np.ones(1))
    least = max(velocity, np.sqrt(acceleration), np.cbrt(sharp))

    found = repro.certify(own)

    assert found.minimum == pytest.approx(least, rel=GAP)
    assert (found.lower_bound or 9e9) <= least * (1 + 1e-12)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("segments", [2, 3])
def test_minimum_is_proved_and_jerk_holds_it_up(seed: int, segments: int) -> None:
    own = problem(seed, segments)
    found, free = proved(own), proved(replace(own, jerk=None))

    assert found.minimum is not None
    assert found.minimum > 1.001 * (free.minimum or 9e9)
    assert any("jerk of joint " in place and "rad/s³" in place for place in found.binding)
    assert own.obeys(np.array(found.at))
    assert own.peak_shares(np.array(found.at))[2] == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("seed", SEEDS)
def test_jerk_limit_that_never_binds_changes_nothing(seed: int) -> None:
    own = replace(problem(seed), jerk=((-1e9, 1e9),) * 2)
    one, two = proved(own), proved(replace(own, jerk=None))

    assert one.minimum == pytest.approx(two.minimum, rel=2 * NEAR)
    assert one.lower_bound == pytest.approx(two.lower_bound, rel=2 * NEAR)
    assert not any("jerk" in place for place in one.binding)


def sampled(own: DirectedSpline, durations: Vector, samples: int = 25) -> Vector:
    """Return dt/du, and by how much of its limit each derivative stays below it."""
    knots = np.arange(len(own.nodes))
    u = np.concatenate([k + np.linspace(1e-9, 1.0 - 1e-9, samples) for k in knots[:-1]])
    angle = CubicSpline(knots, np.array(own.nodes), bc_type=SCIPY[own.ends])
    instants = np.concatenate([[0.0], durations.cumsum()])
    time = CubicSpline(knots, instants, bc_type=SCIPY[own.time_ends])
    q1, q2, q3 = (angle(u, m) for m in (1, 2, 3))
    t1, t2, t3 = (time(u, m)[:, None] for m in (1, 2, 3))
    bend = q2 * t1 - q1 * t2
    jolt = (q3 * t1 - q1 * t3) * t1 - 3.0 * bend * t2
    slope = np.maximum(t1, 1e-2)
    parts = [t1 - 1e-2]
    for values, limits, power in (
        (q1, own.velocity, 1),
        (bend, own.acceleration, 3),
        (jolt, own.jerk, 5),
    ):
        parts += [1.0 - values / limit / slope**power for limit in np.array(limits).T]
    return np.concatenate([part.ravel() for part in parts])


@pytest.mark.parametrize("seed", SEEDS)
def test_no_search_of_scipy_beats_the_bound_and_one_comes_near_the_motion(seed: int) -> None:
    own = problem(seed, 2 + seed % 2)
    found = proved(own)
    assert found.minimum is not None
    assert found.lower_bound is not None
    assert sampled(own, np.array(found.at), 2001).min() > 0.0

    rng = np.random.default_rng(seed)
    starts = just_obeying(own, rng.dirichlet(np.full(own.segments, 3.0), 6))
    ends = [
        minimize(
            lambda x: x.sum(),
            start,
            method="SLSQP",
            bounds=[(1e-2, 100.0)] * own.segments,
            constraints={"type": "ineq", "fun": lambda x: sampled(own, x)},
            options={"maxiter": 200, "ftol": 1e-9},
        ).x
        for start in starts[np.isfinite(starts).all(axis=1)]
    ]
    # what breaks a limit by a little between samples is slowed until it obeys
    times = [just_obeying(own, x).sum() for x in ends]

    assert min(times) >= found.lower_bound
    assert min(times) == pytest.approx(found.minimum, rel=1e-3)


PROBLEM = problem(3, 3)
PROOF = prove(PROBLEM)


@given(st.tuples(shares, shares, shares))
def test_no_motion_that_obeys_beats_the_bound(direction: tuple[float, float, float]) -> None:
    motion = just_obeying(PROBLEM, np.array(direction))

    assert motion.sum() >= float(PROOF.lower_bound)


def test_search_goes_down_to_a_motion_that_no_small_change_makes_faster() -> None:
    start = just_obeying(PROBLEM, np.ones(3))
    best, holding = descended(PROBLEM, Limits(exact(PROBLEM), []), start)
    near = best + 1e-3 * np.random.default_rng(1).normal(size=(500, 3))

    assert best.sum() < start.sum()
    assert just_obeying(PROBLEM, near).sum(axis=1).min() >= best.sum() * (1 - 1e-6)
    assert any(isinstance(limit, Jolt) for limit in holding)


def test_motion_that_breaks_the_jerk_limit_alone_is_not_proved() -> None:
    sharp = replace(PROBLEM, velocity=((-99.0, 99.0),) * 2, acceleration=((-99.0, 99.0),) * 2)
    durations = prove(sharp).durations
    shorter = tuple(h * Fraction(999, 1000) for h in durations)

    assert _obeys(exact(sharp), durations)
    assert not _obeys(exact(sharp), shorter)
    assert _obeys(exact(replace(sharp, jerk=None)), shorter)


def swapped(limits: tuple[tuple[float, ...], ...] | None) -> tuple[tuple[float, ...], ...]:
    return tuple((-high, -low) for low, high in limits or ())


def mirrored(own: DirectedSpline) -> DirectedSpline:
    return replace(
        own,
        nodes=tuple(tuple(-angle for angle in node) for node in own.nodes),
        velocity=swapped(own.velocity),
        acceleration=swapped(own.acceleration),
        jerk=swapped(own.jerk),
    )


def backwards(own: DirectedSpline) -> DirectedSpline:
    # an odd derivative changes its sign with the direction of time, as -q does
    return replace(
        own, nodes=own.nodes[::-1], velocity=swapped(own.velocity), jerk=swapped(own.jerk)
    )


@pytest.mark.parametrize("turned", [mirrored, backwards])
@pytest.mark.parametrize("seed", SEEDS)
def test_motion_mirrored_or_run_backwards_takes_the_same_time(
    seed: int, turned: Callable[[DirectedSpline], DirectedSpline]
) -> None:
    own = problem(seed)
    one, two = proved(own), repro.certify(turned(own))

    assert one.minimum == pytest.approx(two.minimum, rel=GAP)


@pytest.mark.parametrize("longer", [1e-3, 1e5])
def test_short_and_long_motions_are_proved_alike(longer: float) -> None:
    own = problem(1, 3)
    limits = {
        kind: tuple((low / longer**power, high / longer**power) for low, high in getattr(own, kind))
        for power, kind in enumerate(("velocity", "acceleration", "jerk"), start=1)
    }
    box = (own.durations[0] * longer, own.durations[1] * longer)
    one, two = proved(own), repro.certify(replace(own, **limits, durations=box))  # type: ignore[arg-type]

    assert one.minimum is not None
    assert two.minimum == pytest.approx(longer * one.minimum, rel=GAP)


@pytest.mark.parametrize(("side", "seed"), list(itertools.product((0, 1), SEEDS)))
def test_a_tighter_jerk_limit_never_makes_a_motion_faster(side: int, seed: int) -> None:
    own = problem(seed)
    tighter = [list(pair) for pair in own.jerk or ()]
    for pair in tighter:
        pair[side] *= 0.6
    before, after = proved(own), repro.certify(replace(own, jerk=tighter))  # type: ignore[arg-type]

    assert after.minimum is not None
    assert after.minimum >= (before.lower_bound or 9e9)


def test_proof_that_is_cut_short_has_a_bound_and_a_motion() -> None:
    cut = repro.certify(PROBLEM, seconds=0)

    assert cut.minimum is None
    assert 0 < (cut.lower_bound or 0) < (cut.attained or 0)
    assert PROBLEM.obeys(np.array(cut.at))
    assert "a jerk " in cut.explanation
