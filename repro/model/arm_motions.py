"""The motions of an arm as numbers: their durations, their course, and their exact peaks."""

import numpy as np
from numpy.typing import NDArray

from repro.model.figures import ArmMotion
from repro.robotics import MinimumTime, MinimumTimeSpline, rest_to_rest, spline_motion
from repro.robotics.proofs.spline_minimum import prove
from repro.robotics.shown_motion import ShowsMotion, moved, stops

Vector = NDArray[np.float64]
FINE = 2001  # samples of a segment from which a peak is read where no formula gives it


def durations_of(chosen: ArmMotion) -> tuple[float, ...]:
    """Return the durations of the segments in s, those of the proved optimum where none are set.

    Raises NotProvedError where there is no proof.
    """
    problem = chosen.problem
    if isinstance(problem, MinimumTime):
        return chosen.durations or tuple(map(float, problem.shortest()))
    if isinstance(problem, MinimumTimeSpline):
        return chosen.durations or tuple(map(float, prove(problem).durations))
    if isinstance(problem, ShowsMotion):
        return tuple(map(float, problem.durations(np.array(chosen.durations))))
    return (problem[0].duration,)


def course(chosen: ArmMotion, *, derivative: int, samples: int) -> tuple[Vector, Vector]:
    """Return times (n,) in s and a derivative of the angles (n, joints), SI units.

    Each segment has `samples` points; derivative 0 is the angle, 3 the jerk.
    """
    problem, durations = chosen.problem, np.array(durations_of(chosen))
    if isinstance(problem, MinimumTimeSpline):
        return spline_motion.motion(problem, durations, derivative=derivative, samples=samples)
    if isinstance(problem, MinimumTime):
        return moved(problem, durations, derivative=derivative, samples=samples)
    if isinstance(problem, ShowsMotion):
        point = np.array(chosen.durations)
        return moved(problem, point, derivative=derivative, samples=samples)
    share, duration = np.linspace(0.0, 1.0, samples), problem[0].duration
    values = [
        (fit.start if derivative == 0 else 0.0)
        + (fit.end - fit.start) * fit.law.sample(share, derivative) / duration**derivative
        for fit in problem
    ]
    return share * duration, np.transpose(values)


def led_through(chosen: ArmMotion) -> Vector:
    """Return the angles through which a motion is led, start and goal among them, in rad."""
    problem = chosen.problem
    if isinstance(problem, MinimumTime):
        return np.array(problem.waypoints)
    if isinstance(problem, MinimumTimeSpline):
        return np.array(problem.nodes)
    if isinstance(problem, ShowsMotion):
        return stops(problem, np.array(chosen.durations))
    return np.array([[fit.start for fit in problem], [fit.end for fit in problem]])


def limits_of(chosen: ArmMotion) -> Vector | None:
    """Return the limits on velocity, acceleration and, if any, jerk (kinds, joints); or None."""
    limits = getattr(chosen.problem, "limits", None)
    return None if limits is None else np.asarray(limits, dtype=np.float64)


def peaks(chosen: ArmMotion, derivative: int) -> Vector:
    """Return each joint's greatest velocity (1) or acceleration (2), exact up to rounding, SI.

    Of a problem of one's own it is read from samples.
    """
    problem, durations = chosen.problem, durations_of(chosen)
    if isinstance(problem, MinimumTime):
        return rest_to_rest.peaks(problem, durations, derivative)
    if isinstance(problem, MinimumTimeSpline):
        return spline_motion.peaks(problem, np.array(durations), derivative)
    if isinstance(problem, ShowsMotion):
        return _sampled_peaks(chosen, derivative)
    ways = np.array([abs(fit.end - fit.start) for fit in problem])
    return np.asarray(ways * problem[0].law.peak_factor(derivative) / durations[0] ** derivative)


def _sampled_peaks(chosen: ArmMotion, derivative: int) -> Vector:
    _, values = course(chosen, derivative=derivative, samples=FINE)
    return np.asarray(np.abs(values).max(axis=0))
