import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.robotics.spline_limits import (
    extremes,
    fastest,
    hardest,
    largest_turning,
    least,
    roots,
    turning,
)

Vector = NDArray[np.float64]
Triple = tuple[float, float, float]
U = np.linspace(0.0, 1.0, 20001)
COEFFICIENTS = st.tuples(*[st.floats(-3, 3, width=32)] * 3)
POSITIVE = st.tuples(*[st.floats(0.125, 2, width=32)] * 3)  # Bernstein coefficients


def power(bernstein: Triple) -> Triple:
    first, middle, last = bernstein
    return first, 2.0 * (middle - first), first - 2.0 * middle + last


def at(c: tuple[float, ...], u: Vector) -> Vector:
    return np.asarray(np.polyval(c[::-1], u), dtype=np.float64)


@given(COEFFICIENTS)
def test_least_value_of_a_quadratic_is_that_of_dense_samples(p: Triple) -> None:
    sampled = at(p, U).min()

    # between samples a quadratic falls by at most its bend times the step squared over 8
    assert sampled - 1e-8 <= least(*p) <= sampled + 1e-12


@given(COEFFICIENTS, POSITIVE)
def test_fastest_is_the_greatest_of_dense_samples(p: Triple, bernstein: Triple) -> None:
    s = power(bernstein)
    sampled = abs(at(p, U) / at(s, U)).max()

    found = fastest(*p, *s)

    assert found >= sampled * (1 - 1e-12)
    assert found <= sampled * (1 + 1e-4) + 1e-6


@given(COEFFICIENTS, POSITIVE)
def test_hardest_is_the_greatest_of_dense_samples(p: Triple, bernstein: Triple) -> None:
    s = power(bernstein)
    bend = turning(*p, *s)
    sampled = abs(at(bend, U) / at(s, U) ** 3).max()

    found = hardest(*bend, *s)

    assert found >= sampled * (1 - 1e-9)
    assert found <= sampled * (1 + 1e-4) + 1e-6


@given(COEFFICIENTS, POSITIVE, st.sampled_from([1, 3]))
def test_extremes_are_those_of_dense_samples(p: Triple, bernstein: Triple, order: int) -> None:
    s = power(bernstein)
    sampled = at(p, U) / at(s, U) ** order

    low, high = extremes(*p, *s, order)

    size = abs(sampled).max()
    assert low - 1e-9 * size <= sampled.min() <= low + 1e-4 * size + 1e-6
    assert high + 1e-9 * size >= sampled.max() >= high - 1e-4 * size - 1e-6


@given(COEFFICIENTS, POSITIVE)
def test_turning_is_the_numerator_of_the_derivative(p: Triple, bernstein: Triple) -> None:
    s = power(bernstein)
    slope_of_p, slope_of_s = (np.polyval(np.polyder(c[::-1]), U) for c in (p, s))

    expected = slope_of_p * at(s, U) - at(p, U) * slope_of_s

    # pytest.approx would look at the 20001 numbers one by one
    np.testing.assert_allclose(at(turning(*p, *s), U), expected, rtol=1e-6, atol=1e-10)


@pytest.mark.parametrize(
    ("c", "real"),
    [
        ((0.5, -1.5, 1.0), [0.5, 1.0]),
        ((-0.25, 1.0, 0.0), [0.25]),
        ((0.0, 0.0, 2.0), [0.0]),
        ((1.0, 0.0, 1.0), []),
        ((3.0, 0.0, 0.0), []),
        ((-1e-9, 1.0, 1e-9), [1e-9]),
    ],
)
def test_roots_of_a_quadratic_are_those_in_reach(c: Triple, real: list[float]) -> None:
    found = sorted(u for u in roots(*c) if 0.0 <= u <= 1.0)

    assert sorted(set(found)) == pytest.approx(real, rel=1e-12)


@given(COEFFICIENTS)
def test_bound_of_a_quadratic_is_no_lower_than_any_of_its_values(n: Triple) -> None:
    assert largest_turning(*n) >= abs(at(n, U)).max() - 1e-12


def test_hardest_finds_a_narrow_peak_between_samples() -> None:
    # N/s³ peaks where s is least, at u = 0.43217, within 1e-3 of it
    s = power_around(0.43217, 1e-3)

    found = hardest(1.0, 0.0, 0.0, *s)

    assert found == pytest.approx(1e-3**-6, rel=1e-9)


def power_around(centre: float, width: float) -> Triple:
    """Return the coefficients of (u - centre)² + width²."""
    return centre**2 + width**2, -2.0 * centre, 1.0
