"""Motions of several joints made of one polynomial per joint and segment.

Either at rest at every waypoint, or through the waypoints without stopping: the spline of an odd
degree 2k + 1 whose derivatives up to the order 2k are continuous and whose first k derivatives
are zero at both ends (C. de Boor, A Practical Guide to Splines, Springer 1978, chapter XIII).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from repro.robotics.polynomials import RestToRestLaw

Vector = NDArray[np.float64]
_REAL = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class PiecewiseMotion:
    """`curves` has one polynomial per (segment, joint), in a time that runs from 0 to 1 there.

    `durations` are those of the segments, in s; angles are in rad.
    """

    curves: tuple[tuple[Polynomial, ...], ...]
    durations: tuple[float, ...]

    def peaks(self, derivative: int) -> Vector:
        """Return each joint's greatest |derivative| over the motion, in rad/s^derivative."""
        each = [
            [np.abs(_extremes(c.deriv(derivative))).max() / duration**derivative for c in segment]
            for segment, duration in zip(self.curves, self.durations, strict=True)
        ]
        return np.asarray(np.max(each, axis=0))

    def reversals(self) -> int:
        """Return the greatest number of times that one joint turns back."""
        return max(
            _sign_changes([value for curve in joint for value in _extremes(curve)])
            for joint in zip(*self.curves, strict=True)
        )


def _extremes(curve: Polynomial) -> Vector:
    """Return the values at the ends and at every turning point between, in order of time."""
    turns = curve.deriv().roots() if curve.degree() > 1 else np.zeros(0)
    real = turns.real[abs(turns.imag) < _REAL]
    inside = np.sort(real[(real > 0.0) & (real < 1.0)])
    return np.asarray(curve(np.concatenate([[0.0], inside, [1.0]])))


def _sign_changes(values: Sequence[float]) -> int:
    steps = np.diff(values)
    signs = np.sign(steps[abs(steps) > _REAL * (np.ptp(values) or 1.0)])
    return int(np.count_nonzero(np.diff(signs)))


def resting_at(
    waypoints: Sequence[Sequence[float]], durations: Sequence[float], *, law: RestToRestLaw
) -> PiecewiseMotion:
    """Return the motion that rests at every waypoint; waypoints (points, joints) in rad."""
    points = np.array(waypoints)
    curves = tuple(
        tuple(start + (end - start) * law.polynomial for start, end in zip(*ends, strict=True))
        for ends in pairwise(points)
    )
    return PiecewiseMotion(curves=curves, durations=tuple(durations))


def passing_through(
    waypoints: Sequence[Sequence[float]], durations: Sequence[float], *, degree: int
) -> PiecewiseMotion:
    """Return the motion through the waypoints that rests at the first and the last alone."""
    from scipy.interpolate import make_interp_spline  # noqa: PLC0415 (slow to load)

    times = np.cumsum([0.0, *durations])
    rest = [(m, np.zeros(len(waypoints[0]))) for m in range(1, (degree + 1) // 2)]
    spline = make_interp_spline(times, np.array(waypoints), k=degree, bc_type=(rest, rest))
    # Taylor's coefficients at the start of each segment, in its own time; by segment and power
    stretch = np.asarray(durations)[:, None]
    pieces = np.stack(
        [spline(times[:-1], nu=m) * stretch**m / math.factorial(m) for m in range(degree + 1)],
        axis=1,
    )
    curves = tuple(tuple(Polynomial(joint) for joint in segment.T) for segment in pieces)
    return PiecewiseMotion(curves=curves, durations=tuple(durations))
