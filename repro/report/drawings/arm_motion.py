"""An arm's motions, sampled: what the view of the robot and its still show."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.model.figures import Arm, ArmMotion
from repro.robotics import MinimumTime, MinimumTimeSpline, PathFitting
from repro.robotics.proofs.spline_minimum import prove
from repro.robotics.rest_to_rest import motion
from repro.robotics.shown_motion import ShowsMotion, stops
from repro.robotics.skeleton import Skeleton, skeleton
from repro.robotics.spline_motion import motion as spline_motion

Vector = NDArray[np.float64]
SAMPLES = 200  # of a motion at most: a page stays small and no step is seen


@dataclass(frozen=True, slots=True, kw_only=True)
class Moving:
    """One motion of an arm: its postures at `times` (n,) in s, and the `durations` in s."""

    name: str
    durations: tuple[float, ...]
    times: Vector
    postures: tuple[Skeleton, ...]

    @property
    def total(self) -> float:
        """Time of the whole motion in s."""
        return float(self.times[-1])

    @property
    def tool(self) -> Vector:
        """Places of the tool, shape (n, 3), in m."""
        return np.array([posture.corners[-1] for posture in self.postures])

    @property
    def length(self) -> float:
        """How far the tool travels, in m, along the chords between the samples."""
        return float(np.linalg.norm(np.diff(self.tool, axis=0), axis=1).sum())


def moving(arm: Arm) -> tuple[Moving, ...]:
    """Return every motion of the figure, sampled; NotProvedError where an optimum is not proved."""
    return tuple(_moving(arm, motion) for motion in arm.motions)


def waypoints(arm: Arm) -> tuple[Skeleton, ...]:
    """Return the postures through which the first motion is led, start and goal among them."""
    problem = arm.motions[0].problem
    if isinstance(problem, MinimumTime):
        angles = problem.waypoints
    elif isinstance(problem, MinimumTimeSpline):
        angles = problem.nodes
    elif isinstance(problem, ShowsMotion):
        angles = tuple(map(tuple, stops(problem, np.array(arm.motions[0].durations))))
    else:
        angles = tuple(zip(*((fit.start, fit.end) for fit in problem), strict=True))
    return tuple(skeleton(arm.dh, q, arm.convention) for q in angles)


def _moving(arm: Arm, chosen: ArmMotion) -> Moving:
    durations, times, angles = _sampled(chosen)
    postures = tuple(skeleton(arm.dh, q, arm.convention) for q in angles)
    return Moving(name=chosen.name, durations=durations, times=times, postures=postures)


def _sampled(chosen: ArmMotion) -> tuple[tuple[float, ...], Vector, Vector]:
    """Return durations, times (n,) and angles (n, joints)."""
    problem = chosen.problem
    if isinstance(problem, MinimumTime):
        durations = chosen.durations or tuple(map(float, problem.shortest()))
        samples = SAMPLES // problem.segments
        found = motion(problem, np.array(durations), derivative=0, samples=samples)
        return durations, *found
    if isinstance(problem, MinimumTimeSpline):
        durations = chosen.durations or tuple(map(float, prove(problem).durations))
        samples = SAMPLES // problem.segments
        found = spline_motion(problem, np.array(durations), derivative=0, samples=samples)
        return durations, *found
    if isinstance(problem, ShowsMotion):
        return _of_point(problem, chosen)
    return _along_paths(problem)


def _of_point(problem: ShowsMotion, chosen: ArmMotion) -> tuple[tuple[float, ...], Vector, Vector]:
    point = np.array(chosen.durations)
    durations = tuple(map(float, problem.durations(point)))
    samples = SAMPLES // len(durations)
    return durations, *problem.motion(point, derivative=0, samples=samples)


def _along_paths(fits: Sequence[PathFitting]) -> tuple[tuple[float, ...], Vector, Vector]:
    duration = fits[0].duration
    share = np.linspace(0.0, 1.0, SAMPLES)
    angles = [fit.start + (fit.end - fit.start) * fit.law.sample(share) for fit in fits]
    return (duration,), share * duration, np.transpose(angles)
