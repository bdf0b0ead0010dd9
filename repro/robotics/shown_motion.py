"""What a drawing asks of a motion problem, whoever wrote it."""

from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from repro.robotics.rest_to_rest import MinimumTime, motion, peak

Vector = NDArray[np.float64]
FINE = 2001  # samples of a segment from which a peak is read where no formula gives it


@runtime_checkable
class ShowsMotion(Protocol):
    """A problem of one's own whose points are motions of joints, so that they can be drawn."""

    @property
    def limits(self) -> Vector:
        """Limits on velocity, acceleration and jerk (3, joints), infinite where there is none."""

    def durations(self, point: Vector) -> Vector:
        """Return how long each segment takes in the motion that a point stands for, in s."""

    def motion(self, point: Vector, *, derivative: int, samples: int) -> tuple[Vector, Vector]:
        """Return times (n,) in s and a derivative of the angles (n, joints), in rad/s^derivative.

        Derivative 0 is the angle, 3 the jerk; `samples` are for each segment.
        """


Moving = MinimumTime | ShowsMotion


def lasting(problem: Moving, point: Vector) -> Vector:
    """Return the duration of each segment of the motion that a point stands for, in s."""
    return point if isinstance(problem, MinimumTime) else np.asarray(problem.durations(point))


def moved(
    problem: Moving, point: Vector, *, derivative: int, samples: int
) -> tuple[Vector, Vector]:
    """Return times (n,) and a derivative of the angles (n, joints) of the motion, SI units."""
    if isinstance(problem, MinimumTime):
        return motion(problem, point, derivative=derivative, samples=samples)
    return problem.motion(point, derivative=derivative, samples=samples)


def stops(problem: Moving, point: Vector) -> Vector:
    """Return the angles at both ends and between segments, shape (segments + 1, joints), in rad."""
    if isinstance(problem, MinimumTime):
        return np.array(problem.waypoints)
    _, angles = problem.motion(point, derivative=0, samples=2)
    return np.vstack([angles[::2], angles[-1:]])


def highest(problem: Moving, point: Vector, derivative: int) -> float:
    """Return the largest value that any joint reaches: by formula, or as finely sampled."""
    if isinstance(problem, MinimumTime):
        return peak(problem, tuple(point), derivative)
    _, values = problem.motion(point, derivative=derivative, samples=FINE)
    return float(np.abs(values).max())


def shortest(problem: Moving) -> Vector | None:
    """Return the durations of the proved optimum; None where nothing is proved of the problem."""
    return problem.shortest() if isinstance(problem, MinimumTime) else None
