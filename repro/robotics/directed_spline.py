"""Splines whose limits differ by direction, and those whose jerk is limited."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.errors import InputError
from repro.robotics.bsplines import Ends, spans
from repro.robotics.motion_checks import Rows, as_doubles, check_motion, limit_pairs
from repro.robotics.spline_jerk import sharpest
from repro.robotics.spline_limits import extremes, least, turning
from repro.robotics.spline_motion import MinimumTimeSpline, slope_weights

Vector = NDArray[np.float64]


@jit
def _peak_shares(slopes, steps, limits):
    """Return the greatest shares of the limits of each kind of each motion (n, kinds).

    `slopes` (n, spans, 3) and `steps` (spans, joints, 3) are dt/du and dq/du as coefficients of 1,
    u, u²; `limits` (kinds, joints, 2) have lowest and highest of velocity, acceleration and, as the
    third if at all, jerk.
    """
    peaks = np.full((len(slopes), len(limits)), np.inf)
    for i in range(len(slopes)):
        fast = hard = sharp = 0.0
        for span in range(len(steps)):
            s0, s1, s2 = slopes[i, span]
            if not least(s0, s1, s2) > 0.0:
                fast = hard = sharp = np.inf
                break
            for j in range(steps.shape[1]):
                p0, p1, p2 = steps[span, j]
                low, high = extremes(p0, p1, p2, s0, s1, s2, 1)
                fast = max(fast, low / limits[0, j, 0], high / limits[0, j, 1])
                n0, n1, n2 = turning(p0, p1, p2, s0, s1, s2)
                low, high = extremes(n0, n1, n2, s0, s1, s2, 3)
                hard = max(hard, low / limits[1, j, 0], high / limits[1, j, 1])
                if len(limits) == 3:
                    low, high = sharpest(n0, n1, n2, s0, s1, s2)
                    sharp = max(sharp, low / limits[2, j, 0], high / limits[2, j, 1])
        peaks[i, 0], peaks[i, 1] = fast, hard
        peaks[i, 2:] = sharp
    return peaks


@dataclass(frozen=True, slots=True, kw_only=True)
class DirectedSpline:
    """A MinimumTimeSpline whose limits have a (lowest, highest) per joint.

    The lowest is below 0, the highest above it. `jerk` may be limited, too, in rad/s³; all else is
    as it is there.
    """

    nodes: Rows
    velocity: Rows
    acceleration: Rows
    jerk: Rows | None = None
    durations: tuple[float, float]
    ends: Ends = "repeated"
    time_ends: Ends = "repeated"

    def __post_init__(self) -> None:
        """Raise DeclarationError for nodes, limits, durations or words that cannot be."""
        for name in ("velocity", "acceleration"):
            object.__setattr__(self, name, limit_pairs(getattr(self, name), called=name))
        widest = self.widest
        for name in ("nodes", "durations"):
            object.__setattr__(self, name, getattr(widest, name))
        if self.jerk is not None:
            pairs = limit_pairs(self.jerk, called="jerk")
            object.__setattr__(self, "jerk", pairs)
            most = [max(-low, high) for low, high in pairs]
            check_motion(self.nodes, {"jerk": most}, self.durations, called="nodes")

    @property
    def widest(self) -> MinimumTimeSpline:
        """The spline whose limits in both directions are the wider one, with any jerk."""
        return MinimumTimeSpline(
            nodes=self.nodes,
            velocity=tuple(max(-low, high) for low, high in self.velocity),
            acceleration=tuple(max(-low, high) for low, high in self.acceleration),
            durations=self.durations,
            ends=self.ends,
            time_ends=self.time_ends,
        )

    @property
    def segments(self) -> int:
        """Number of durations to choose."""
        return len(self.nodes) - 1

    def peak_shares(self, points: Vector) -> Vector:
        """Return the peaks of motions (…, segments) as shares of the limits, shape (…, 2 or 3).

        Of velocity, acceleration and jerk where it is limited, each by the limit in its direction;
        infinite where time runs backwards.
        """
        points = as_doubles(points, called="durations")
        if points.shape[-1:] != (self.segments,):
            message = f"durations of shape {points.shape}: the last side must be {self.segments}"
            raise InputError(message)
        weights = np.array(slope_weights(self.segments, self.time_ends), dtype=np.float64)
        slopes = points.reshape(-1, self.segments) @ weights.transpose(0, 2, 1)
        steps = spans(self.nodes, self.ends)[:, 1:] * np.array([1.0, 2.0, 3.0])[:, None]
        peaks: Vector = _peak_shares(
            np.ascontiguousarray(slopes.transpose(1, 0, 2)),
            np.ascontiguousarray(steps.transpose(0, 2, 1)),
            np.array([self.velocity, self.acceleration, *([self.jerk] if self.jerk else [])]),
        )
        return peaks.reshape(*points.shape[:-1], peaks.shape[-1])

    def obeys(self, durations: Vector) -> bool:
        """Return whether a motion keeps every limit, in doubles."""
        return bool((self.peak_shares(durations) <= 1.0).all())


Spline = MinimumTimeSpline | DirectedSpline
Limits = tuple[float | tuple[float, ...], ...]  # of either kind of spline, per joint


def jerk_of(problem: Spline) -> Rows | None:
    """Return the limits of the jerk, None where it is free."""
    return problem.jerk if isinstance(problem, DirectedSpline) else None


def sides(limits: Limits) -> Rows:
    """Return the (lowest, highest) of each joint."""
    return tuple(pair if isinstance(pair, tuple) else (-pair, pair) for pair in limits)


def times(limits: Limits, factor: float) -> Limits:
    """Return every limit times a factor, in the shape that it has."""
    return tuple(
        tuple(limit * factor for limit in pair) if isinstance(pair, tuple) else pair * factor
        for pair in limits
    )
