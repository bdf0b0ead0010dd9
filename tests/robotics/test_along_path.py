import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.robotics.along_path import slowing

Vector = NDArray[np.float64]
GRID = np.linspace(0.0, 1.0, 11)


def slowed(
    path: np.polynomial.Polynomial, speeds: Vector, velocity: float, acceleration: float
) -> float:
    slope, bend = (path.deriv(m)(GRID)[:, None] for m in (1, 2))
    return slowing(
        GRID, speeds, slope, bend,
        velocity=np.array([velocity]), acceleration=np.array([acceleration]),
    )  # fmt: skip


def test_motion_that_obeys_is_not_slowed() -> None:
    line = np.polynomial.Polynomial([0.0, 2.0])

    assert slowed(line, np.ones(11), 2.0, 1.0) == pytest.approx(1.0)


def test_velocity_too_high_slows_by_its_share_and_acceleration_by_the_root_of_it() -> None:
    line, curve = np.polynomial.Polynomial([0.0, 2.0]), np.polynomial.Polynomial([0.0, 0.0, 4.5])

    assert slowed(line, np.ones(11), 0.5, 1.0) == pytest.approx(4.0)
    assert slowed(curve, np.ones(11), 99.0, 1.0) == pytest.approx(3.0)


@given(
    st.lists(st.floats(-3, 3), min_size=4, max_size=4),
    st.lists(st.floats(0.1, 3), min_size=11, max_size=11),
)
def test_slowed_motion_obeys_wherever_it_is_sampled(
    coefficients: list[float], speeds: list[float]
) -> None:
    path, speed = np.polynomial.Polynomial(coefficients), np.array(speeds)
    by = slowed(path, speed, 1.0, 1.0)
    s = np.linspace(0.0, 1.0, 1001)[:-1]
    piece = np.minimum((s * 10).astype(int), 9)
    gained = (np.diff(speed**2) / 0.1 / 2)[piece]
    square = (speed**2)[piece] + 2 * gained * (s - GRID[piece])

    assert (np.abs(path.deriv()(s)) * np.sqrt(square) / by).max() <= 1 + 1e-9
    hard = path.deriv(2)(s) * square + path.deriv()(s) * gained
    assert (np.abs(hard) / by**2).max() <= 1 + 1e-9
