"""What can be said of polynomial curves given by coefficients of 1, t, t², … from 0 to a time.

Coefficients have shape (…, n), so that many curves are measured at once; SI units.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


def derivative(curves: Vector, order: int = 1) -> Vector:
    """Return the coefficients of the derivative of that order, shape (…, n - order or 1)."""
    found = np.asarray(curves, dtype=np.float64)
    for _ in range(order):
        powers = np.arange(1, found.shape[-1])
        found = found[..., 1:] * powers if len(powers) else np.zeros_like(found)
    return found


def values(curves: Vector, times: Vector) -> Vector:
    """Return the values at `times` (k,), shape (…, k)."""
    coefficients = np.asarray(curves, dtype=np.float64)
    found = np.zeros((*coefficients.shape[:-1], len(times)))
    for j in reversed(range(coefficients.shape[-1])):
        found = found * times + coefficients[..., j, None]
    return found


def start_velocity(curves: Vector, duration: float) -> Vector:
    """Return |velocity| at time 0: the jump from rest."""
    return _end(derivative(curves), duration, 0)


def end_velocity(curves: Vector, duration: float) -> Vector:
    """Return |velocity| at the end: the jump to rest."""
    return _end(derivative(curves), duration, 1)


def start_acceleration(curves: Vector, duration: float) -> Vector:
    """Return |acceleration| at time 0: the jump from rest."""
    return _end(derivative(curves, 2), duration, 0)


def end_acceleration(curves: Vector, duration: float) -> Vector:
    """Return |acceleration| at the end: the jump to rest."""
    return _end(derivative(curves, 2), duration, 1)


def peak_jerk(curves: Vector, duration: float) -> Vector:
    """Return the greatest |jerk| between the ends, which count."""
    jerk = derivative(curves, 3)
    return _each(lambda curve: float(np.abs(_turning_values(curve, duration)).max()), jerk)


def jerk_range(curves: Vector, duration: float) -> Vector:
    """Return greatest less least jerk: 0 where the acceleration is a straight line."""
    jerk = derivative(curves, 3)
    return _each(lambda curve: float(np.ptp(_turning_values(curve, duration))), jerk)


def squared_jerk(curves: Vector, duration: float) -> Vector:
    """Return the integral of the squared jerk from 0 to the end."""
    jerk = derivative(curves, 3)
    powers = np.arange(jerk.shape[-1])
    exponents = powers[:, None] + powers + 1
    products = duration**exponents / exponents
    return np.asarray(np.einsum("...i,ij,...j->...", jerk, products, jerk))


def reversals(curves: Vector, duration: float) -> Vector:
    """Return how often the velocity changes its sign between the ends."""
    return _each(lambda curve: _sign_changes(_turning_values(curve, duration)), derivative(curves))


QUANTITIES: Mapping[str, Callable[[Vector, float], Vector]] = MappingProxyType(
    {
        "start velocity": start_velocity,
        "end velocity": end_velocity,
        "start acceleration": start_acceleration,
        "end acceleration": end_acceleration,
        "peak jerk": peak_jerk,
        "jerk range": jerk_range,
        "squared jerk": squared_jerk,
        "reversals": reversals,
    }
)
"""By name: (curves (…, n), duration in s) to values of shape (…)."""


def _end(curves: Vector, duration: float, which: int) -> Vector:
    return np.asarray(np.abs(values(curves, np.array([0.0, duration]))[..., which]))


def _turning_values(curve: Vector, duration: float) -> Vector:
    """Return the values of one curve (n,) at 0, where it turns, and at the end, in this order.

    Between two of them the curve rises or falls, so they hold its extremes and its sign changes.
    """
    slope = derivative(curve)
    shares = slope * duration ** np.arange(len(slope))  # of the slope at the end, term by term
    # terms that rounding swallows would make roots that overflow
    shares = np.trim_zeros(np.where(abs(shares) > 1e-16 * abs(shares).max(), shares, 0.0), "b")
    # the real part of a pair is kept, too: one time more between 0 and the end does no harm
    turns = np.polynomial.Polynomial(shares).roots().real if len(shares) > 1 else np.zeros(0)
    inside = np.sort(turns[(turns > 0.0) & (turns < 1.0)])
    return values(curve, duration * np.concatenate([[0.0], inside, [1.0]]))


def _sign_changes(series: Vector) -> float:
    signs = np.sign(series[series != 0.0])
    return float(np.count_nonzero(signs[1:] != signs[:-1]))


def _each(measure: Callable[[Vector], float], curves: Vector) -> Vector:
    flat = curves.reshape(-1, curves.shape[-1])
    return np.array([measure(curve) for curve in flat]).reshape(curves.shape[:-1])
