"""The least time of splines whose limits differ by direction, and a plain search beside it."""

from dataclasses import replace
from functools import cache
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

import repro
from repro.robotics import DirectedSpline

Vector = NDArray[np.float64]
SEEDS = range(6)
proved = cache(repro.certify)
"""What several tests compare with is proved once."""
SCIPY = {"natural": "natural", "still": "clamped"}  # what it calls these ends


def pairs(rng: np.random.Generator, most: float) -> tuple[tuple[float, float], ...]:
    return tuple((-low, high) for low, high in rng.uniform(0.2 * most, most, (2, 2)).tolist())


def problem(seed: int) -> DirectedSpline:
    rng = np.random.default_rng(seed)
    return DirectedSpline(
        nodes=rng.uniform(-2.0, 2.0, (3 + seed % 2, 2)),  # type: ignore[arg-type] # arrays are taken
        velocity=pairs(rng, 2.0),
        acceleration=pairs(rng, 4.0 if seed % 3 else 40.0),
        durations=(0.01, 100.0),
        ends="still" if seed % 2 else "natural",
        time_ends="natural",
    )


def swapped(limits: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    return tuple((-high, -low) for low, high in limits)


def slowed(own: DirectedSpline, directions: Vector) -> Vector:
    """Return the total times (n,) of durations (n, segments) scaled until samples just obey."""
    u = np.linspace(0.0, own.segments, 200 * own.segments + 1)
    knots = np.arange(len(own.nodes))
    angle = CubicSpline(knots, np.array(own.nodes), bc_type=SCIPY[own.ends])
    instants = np.concatenate([np.zeros((1, len(directions))), directions.cumsum(axis=1).T])
    time = CubicSpline(knots, instants, bc_type=SCIPY[own.time_ends])
    q1, q2 = (angle(u, m)[:, None] for m in (1, 2))
    t1, t2 = (time(u, m)[..., None] for m in (1, 2))
    forwards = (t1 > 1e-6).all(axis=(0, 2))
    t1 = np.where(t1 > 0.0, t1, 1.0)
    scale = np.zeros(len(directions))
    for values, limits, order in (
        (q1 / t1, own.velocity, 1),
        ((q2 * t1 - q1 * t2) / t1**3, own.acceleration, 2),
    ):
        share = np.maximum(*(values / limit for limit in np.array(limits).T)).max(axis=(0, 2))
        scale = np.maximum(scale, share ** (1 / order))
    return np.where(forwards, directions.sum(axis=1) * scale, np.inf)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_direction_of_a_grid_beats_the_proved_minimum_and_one_comes_near(seed: int) -> None:
    own = problem(seed)
    found = proved(own)
    assert found.minimum is not None

    sides = np.linspace(0.04, 1.0, 60 if own.segments == 3 else 600)
    tried = np.array([(1.0, *rest) for rest in product(sides, repeat=own.segments - 1)])
    tried = np.vstack([np.roll(tried, k, axis=1) for k in range(own.segments)])
    best = min(slowed(own, part).min() for part in np.array_split(tried, 40))
    at = np.array([found.at])

    assert slowed(own, at)[0] <= found.minimum
    assert found.minimum * (1 - 1e-3) <= best <= found.minimum * 1.02


@pytest.mark.parametrize("seed", SEEDS)
def test_limits_alike_in_both_directions_take_the_time_of_one_limit(seed: int) -> None:
    widest = problem(seed).widest
    alike = DirectedSpline(
        nodes=widest.nodes,
        velocity=tuple((-limit, limit) for limit in widest.velocity),
        acceleration=tuple((-limit, limit) for limit in widest.acceleration),
        durations=widest.durations,
        ends=widest.ends,
        time_ends=widest.time_ends,
    )
    one, two = repro.certify(widest), repro.certify(alike)

    assert one.minimum == pytest.approx(two.minimum, rel=1e-9)
    assert one.binding == two.binding


@pytest.mark.parametrize("seed", SEEDS)
def test_mirrored_motion_with_swapped_limits_takes_the_same_time(seed: int) -> None:
    own = problem(seed)
    mirrored = replace(
        own,
        nodes=tuple(tuple(-angle for angle in node) for node in own.nodes),
        velocity=swapped(own.velocity),
        acceleration=swapped(own.acceleration),
    )
    one, two = proved(own), repro.certify(mirrored)

    assert one.minimum == pytest.approx(two.minimum, rel=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_motion_run_backwards_with_swapped_velocities_takes_the_same_time(seed: int) -> None:
    own = problem(seed)
    back = replace(own, nodes=own.nodes[::-1], velocity=swapped(own.velocity))
    one, two = proved(own), repro.certify(back)

    assert one.minimum == pytest.approx(two.minimum, rel=5e-6)


@pytest.mark.parametrize(("kind", "side"), list(product(("velocity", "acceleration"), (0, 1))))
def test_a_tighter_limit_on_one_side_never_makes_a_motion_faster(kind: str, side: int) -> None:
    longer = 0
    for seed in SEEDS:
        own = problem(seed)
        limits = [list(pair) for pair in getattr(own, kind)]
        for pair in limits:
            pair[side] *= 0.6
        before, after = proved(own), repro.certify(replace(own, **{kind: limits}))  # type: ignore[arg-type]
        assert before.lower_bound is not None
        assert after.minimum is not None
        assert after.minimum >= before.lower_bound
        longer += after.minimum > 1.001 * before.lower_bound
    assert longer


def test_limit_that_binds_is_named_with_its_direction() -> None:
    line = DirectedSpline(
        nodes=((0.0,), (-3.0,)),
        velocity=((-0.5, 2.0),),
        acceleration=((-9.0, 9.0),),
        durations=(0.01, 100.0),
        ends="natural",
        time_ends="natural",
    )
    down = repro.certify(line)
    up = repro.certify(replace(line, nodes=((-3.0,), (0.0,))))

    assert down.minimum == pytest.approx(6.0, rel=1e-6)
    assert up.minimum == pytest.approx(1.5, rel=1e-6)
    assert "(limit -0.5 rad/s)" in down.binding[0]
    assert "(limit 2 rad/s)" in up.binding[0]
