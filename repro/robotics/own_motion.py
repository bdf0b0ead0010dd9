"""The motion problems whose least time can be proved, sampled alike."""

import numpy as np
from numpy.typing import NDArray

from repro.robotics import polynomial_motion, rest_to_rest, spline_motion
from repro.robotics.directed_spline import DirectedSpline
from repro.robotics.motion_checks import Rows
from repro.robotics.polynomial_motion import PolynomialMotion
from repro.robotics.rest_to_rest import MinimumTime
from repro.robotics.spline_motion import MinimumTimeSpline

Vector = NDArray[np.float64]
OwnMotion = MinimumTime | MinimumTimeSpline | DirectedSpline | PolynomialMotion
APART = 1e-9  # of the mean step: instants that are nearer are one, but for rounding


def joints_of(problem: OwnMotion) -> int:
    """Return the number of joints."""
    return problem.joints if isinstance(problem, PolynomialMotion) else len(problem.velocity)


def points_of(problem: OwnMotion) -> Rows:
    """Return the waypoints (points, joints)."""
    if isinstance(problem, MinimumTime | PolynomialMotion):
        return problem.waypoints
    return problem.nodes


def sampled(
    problem: OwnMotion, durations: Vector, *, derivative: int, samples: int
) -> tuple[Vector, Vector]:
    """Return times (n,) in s and a derivative of the joints (n, joints), in the problem's units.

    Each segment has `samples` of them, its ends among them; at an inner waypoint both stand.
    """
    if isinstance(problem, PolynomialMotion):
        return polynomial_motion.motion(problem, durations, derivative=derivative, samples=samples)
    if isinstance(problem, MinimumTime):
        return rest_to_rest.motion(problem, durations, derivative=derivative, samples=samples)
    spline = problem.widest if isinstance(problem, DirectedSpline) else problem
    with np.errstate(all="ignore"):  # a jerk that is not asked for may be no double
        return spline_motion.motion(spline, durations, derivative=derivative, samples=samples)


def increasing(times: Vector) -> NDArray[np.intp]:
    """Return which samples to keep so that every instant is later than the one before.

    Of samples at one instant the last stays: with what comes after the waypoint.
    """
    least = APART * (times[-1] - times[0]) / len(times)
    later = np.append(np.diff(times) > least, values=True)
    return np.flatnonzero(later)
