from dataclasses import replace

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from repro.robotics.spline_jerk import sharpest
from repro.robotics.spline_limits import turning
from repro.robotics.spline_motion import motion
from tests.robotics.test_directed_spline import DIRECTED
from tests.robotics.test_spline_motion import QUICK, SLOW

Vector = NDArray[np.float64]
LIMITED = replace(DIRECTED, jerk=((-3.0, 1.0), (-2.0, 5.0)))
FINE = np.linspace(0.0, 1.0, 20_001)


def span(seed: int) -> tuple[Vector, Vector]:
    """Return dq/du and dt/du of a span, the second above 0.1 and now and then steep."""
    rng = np.random.default_rng(seed)
    s = rng.normal(size=3) * (1.0, rng.choice([0.0, 1.0, 5.0]), rng.choice([0.0, 1.0, 5.0]))
    s[0] += 0.1 - Polynomial(s)(FINE).min()
    return rng.normal(size=3) * rng.integers(0, 2, 3), s


def jerk(p: Vector, s: Vector, u: Vector) -> Vector:
    """Return the jerk by the rule of the quotient, one division by dt/du for each derivative."""
    first, slope = Polynomial(p), Polynomial(s)
    bend = first.deriv() * slope - first * slope.deriv()
    second = bend.deriv()(u) / slope(u) ** 3 - 3.0 * bend(u) * slope.deriv()(u) / slope(u) ** 4
    return np.asarray(second / slope(u))


@pytest.mark.parametrize("seed", range(200))
def test_extremes_of_the_jerk_are_those_of_dense_samples(seed: int) -> None:
    p, s = span(seed)
    values = jerk(p, s, FINE)
    low, high = sharpest(*turning(*p, *s), *s)
    size = abs(values).max()

    assert low <= values.min() + 1e-12 * size
    assert high >= values.max() - 1e-12 * size
    assert low == pytest.approx(values.min(), rel=1e-12, abs=1e-5 * size)
    assert high == pytest.approx(values.max(), rel=1e-12, abs=1e-5 * size)


def test_extremes_of_a_curve_done_by_hand_are_exact() -> None:
    # q = u³, t = u + u³/3: the jerk 6(1 - 5u²)/(1 + u²)⁵ is greatest at 0, least where u² = 1/2
    low, high = sharpest(*turning(0.0, 0.0, 3.0, 1.0, 0.0, 1.0), 1.0, 0.0, 1.0)

    assert high == 6.0
    assert low == pytest.approx(-32 / 27, rel=1e-15)


@pytest.mark.parametrize("durations", [SLOW, QUICK])
def test_share_of_a_jerk_limit_is_that_of_the_motion_on_its_side(durations: Vector) -> None:
    _, values = motion(DIRECTED.widest, durations, derivative=3, samples=5001)
    low, high = np.array(LIMITED.jerk).T
    expected = np.maximum(values / low, values / high).max()

    found = LIMITED.peak_shares(durations)

    assert found[:2].tolist() == DIRECTED.peak_shares(durations).tolist()
    assert expected * (1 - 1e-12) <= found[2] <= expected * (1 + 1e-5)
    assert LIMITED.obeys(durations) == bool((found <= 1.0).all())
