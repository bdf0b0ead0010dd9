"""Minimum time along a B-spline in time and angle, under limits on every joint.

Angle and time are both uniform cubic B-splines in one parameter u: the angles through the nodes,
the time through the instants at which the nodes are passed. So the velocity is q'/t' and the
acceleration (q''t' - q't'')/t'³, primes standing for d/du.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.errors import DeclarationError, InputError
from repro.robotics.bsplines import Ends, Matrix, sample, span_weights, spans
from repro.robotics.motion_checks import (
    as_doubles,
    check_motion,
    check_word,
    checked_durations,
    numbers,
    rows,
)
from repro.robotics.spline_limits import fastest, hardest, largest_turning, least, turning

Vector = NDArray[np.float64]
Handling = Literal["feasibility first", "time scaling"]
_HEADER = 4
_NEVER = 1e9  # s: longer than any motion; where time runs backwards there is no motion at all


@jit
def _slopes(x, data):
    """Return dt/du of each span as coefficients of 1, u, u², shape (segments, 3)."""
    segments = len(x)
    slopes = np.zeros((segments, 3))
    place = _HEADER
    for span in range(segments):
        for power in range(3):
            for k in range(segments):
                slopes[span, power] += data[place] * x[k]
                place += 1
    return slopes


@jit
def _backwards(slopes):
    """Return how far dt/du falls below 0, summed over the spans; -1 where it is positive."""
    total = 0.0
    positive = True
    for span in range(len(slopes)):
        low = least(slopes[span, 0], slopes[span, 1], slopes[span, 2])
        positive = positive and low > 0.0
        total += max(0.0, -low)
    return -1.0 if positive else total


@jit
def _shares(slopes, data, threshold):
    """Return the greatest shares of a velocity and an acceleration limit, and the summed excess.

    An acceleration that is proved to stay below `threshold` times its limit is not looked into.
    """
    segments, joints = len(slopes), int(data[1])
    limits = _HEADER + 3 * segments * segments
    place = limits + 2 * joints
    fast = hard = excess = 0.0
    for span in range(segments):
        s0, s1, s2 = slopes[span]
        low = least(s0, s1, s2)
        for j in range(joints):
            p0, p1, p2 = data[place], data[place + 1], data[place + 2]
            place += 3
            share = fastest(p0, p1, p2, s0, s1, s2) / data[limits + j]
            fast = max(fast, share)
            excess += max(0.0, share - 1.0)
            n0, n1, n2 = turning(p0, p1, p2, s0, s1, s2)
            limit = data[limits + joints + j]
            if largest_turning(n0, n1, n2) > threshold * limit * low * low * low:
                share = hardest(n0, n1, n2, s0, s1, s2) / limit
                hard = max(hard, share)
                excess += max(0.0, share - 1.0)
    return fast, hard, excess


@jit
def _cost(x, data):
    slopes = _slopes(x, data)
    backwards = _backwards(slopes)
    if backwards >= 0.0:
        return _NEVER + backwards
    total = x.sum()
    if data[2] == 1.0:
        fast, hard, _ = _shares(slopes, data, 0.0)
        return min(_NEVER, total * max(fast, np.sqrt(hard)))
    _, _, excess = _shares(slopes, data, 1.0)
    if excess == 0.0:
        return total
    return min(_NEVER, data[3] + excess)  # behind every motion that obeys, ordered by excess


@jit
def _peak_shares(points, data):
    """Return the greatest shares of a velocity and an acceleration limit of each point (n, 2)."""
    peaks = np.full((len(points), 2), np.inf)
    for i in range(len(points)):
        slopes = _slopes(points[i], data)
        if _backwards(slopes) < 0.0:
            peaks[i, 0], peaks[i, 1], _ = _shares(slopes, data, 0.0)
    return peaks


@cache
def slope_weights(segments: int, ends: Ends) -> tuple[Matrix, ...]:
    """Return the exact matrix (3, segments) of each span, from durations to dt/du."""
    return tuple(
        tuple(
            tuple((k + 1) * sum(matrix[k + 1][i + 1 :], Fraction(0)) for i in range(segments))
            for k in range(3)
        )
        for matrix in span_weights(segments + 1, ends)
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class MinimumTimeSpline:
    """Choose the duration of each segment so that the sum is least and every limit is kept.

    `nodes` (points, joints) in rad; `velocity` and `acceleration` are limits per joint in rad/s
    and rad/s²; `durations` are the (shortest, longest) that a search may try, in s; `ends` and
    `time_ends` are the rules for the end control points of angles and time. `handling` says what
    a search is told of a motion that breaks a limit: "feasibility first" ranks it behind every
    motion that obeys (K. Deb, Computer Methods in Applied Mechanics and Engineering 186 (2000)
    311-338); with "time scaling" every motion counts with the time that it takes when it is slowed
    or sped up as a whole until it just obeys. Where time runs backwards there is no motion, which
    ranks last.
    """

    nodes: tuple[tuple[float, ...], ...]
    velocity: tuple[float, ...]
    acceleration: tuple[float, ...]
    durations: tuple[float, float]
    ends: Ends = "repeated"
    time_ends: Ends = "repeated"
    handling: Handling = "feasibility first"

    def __post_init__(self) -> None:
        """Raise DeclarationError for nodes, limits, durations or words that cannot be.

        Arrays and lists are taken where tuples are meant.
        """
        object.__setattr__(self, "nodes", rows(self.nodes, called="nodes"))
        for name in ("velocity", "acceleration", "durations"):
            object.__setattr__(self, name, numbers(getattr(self, name), called=name))
        kinds = {"velocity": self.velocity, "acceleration": self.acceleration}
        check_motion(self.nodes, kinds, self.durations, called="nodes")
        for name, known in (("ends", Ends), ("time_ends", Ends), ("handling", Handling)):
            check_word(getattr(self, name), get_args(known), called=name)

    @property
    def segments(self) -> int:
        """Number of durations to choose."""
        return len(self.nodes) - 1

    @property
    def limits(self) -> Vector:
        """Limits on velocity and acceleration, shape (2, joints)."""
        return np.array([self.velocity, self.acceleration])

    @property
    def bounds(self) -> Vector:
        """Shortest and longest duration of each segment, shape (segments, 2), in s."""
        return np.tile(np.array(self.durations), (self.segments, 1))

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """Compiled cost in s."""
        return _cost

    @property
    def data(self) -> Vector:
        """Everything that the compiled cost needs, in one vector."""
        handling = get_args(Handling).index(self.handling)
        header = (self.segments, len(self.velocity), handling, self.segments * self.durations[1])
        time = np.array(slope_weights(self.segments, self.time_ends), dtype=np.float64)
        angle = spans(self.nodes, self.ends)[:, 1:] * np.array([1.0, 2.0, 3.0])[:, None]
        parts = (header, time.ravel(), self.limits.ravel(), angle.transpose(0, 2, 1).ravel())
        return np.concatenate(parts)

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return tuple(getattr(self, name) for name in self.__slots__)

    def peak_shares(self, points: Vector) -> Vector:
        """Return the peaks of motions (…, segments) as shares of the limits, shape (…, 2).

        The first is the greatest velocity of any joint over its limit, the second the same of the
        acceleration; infinite where time runs backwards.
        """
        points = as_doubles(points, called="durations")
        if points.shape[-1:] != (self.segments,):
            message = f"durations of shape {points.shape}: the last side must be {self.segments}"
            raise InputError(message)
        flat = np.ascontiguousarray(np.reshape(points, (-1, self.segments)))
        peaks: Vector = _peak_shares(flat, self.data)
        return peaks.reshape(*points.shape[:-1], 2)

    def obeys(self, durations: Vector) -> bool:
        """Return whether a motion keeps every limit, in doubles and as a search is told."""
        return bool((self.peak_shares(durations) <= 1.0).all())

    def obeying(self, points: Vector) -> Vector:
        """Return motions slowed as a whole, as little as makes them obey; shape as given, in s.

        Time scaled by c divides velocities by c and accelerations by c². With "time scaling" a
        motion with slack is sped up as well.
        """
        peaks = self.peak_shares(points)
        scale = np.maximum(peaks[..., 0], np.sqrt(peaks[..., 1]))
        if self.handling != "time scaling":
            scale = np.maximum(scale, 1.0)
        return np.asarray(points * scale[..., None])

    def quantity(self, name: str, points: Vector) -> Vector:
        """Return a quantity of motions `points` (…, segments), shape (…).

        "total" and "duration k" in s; "velocity share" and "acceleration share" at the peak, in
        percent of the limit; "speed at the ends", of the fastest joint at start or end, in rad/s.
        A motion that breaks a limit counts as slowed until it obeys.
        """
        durations = self.obeying(points)
        known = {"total": durations.sum(axis=-1)}
        known |= {f"duration {k + 1}": durations[..., k] for k in range(self.segments)}
        if name in known:
            return np.asarray(known[name])
        if name in (kinds := ("velocity share", "acceleration share")):
            return np.asarray(100.0 * self.peak_shares(durations)[..., kinds.index(name)])
        if name == "speed at the ends":
            return _speed_at_ends(self, durations)
        others = ", ".join((*known, *kinds, "speed at the ends"))
        message = f"a spline motion has no quantity {name!r}; it has {others}"
        raise DeclarationError(message)


def _speed_at_ends(problem: MinimumTimeSpline, durations: Vector) -> Vector:
    flat = durations.reshape(-1, problem.segments)
    speeds = [abs(motion(problem, h, derivative=1, samples=2)[1][[0, -1]]).max() for h in flat]
    return np.array(speeds).reshape(durations.shape[:-1])


def peaks(problem: MinimumTimeSpline, durations: Vector, derivative: int) -> Vector:
    """Return each joint's greatest velocity (1) or acceleration (2), (joints,), SI units.

    Nothing is sampled; infinite where time runs backwards.
    """
    steps = spans(problem.nodes, problem.ends)[:, 1:] * np.array([1.0, 2.0, 3.0])[:, None]
    data = problem.data
    slopes = _slopes(np.asarray(durations, dtype=np.float64), data)
    if _backwards(slopes) >= 0.0:
        return np.full(steps.shape[-1], np.inf)
    found = np.zeros(steps.shape[-1])
    for s, p in zip(slopes, steps, strict=True):
        for joint, (p0, p1, p2) in enumerate(p.T):
            if derivative == 1:
                value = fastest(p0, p1, p2, *s)
            else:
                value = hardest(*turning(p0, p1, p2, *s), *s)
            found[joint] = max(found[joint], value)
    return found


def motion(
    problem: MinimumTimeSpline, durations: Vector, *, derivative: int, samples: int
) -> tuple[Vector, Vector]:
    """Return times (n,) and joint values (n, joints) of the whole motion, SI units.

    Each segment has `samples` points, equally spaced in u; derivatives go up to 3, the jerk.
    """
    durations = checked_durations(durations, problem.segments)
    u = np.linspace(0.0, 1.0, samples)
    angle = spans(problem.nodes, problem.ends)
    time = spans(np.concatenate([[0.0], np.cumsum(durations)]), problem.time_ends)[..., None]
    q, q1, q2, q3 = (sample(angle, u, m) for m in range(4))
    t, t1, t2, t3 = (sample(time, u, m) for m in range(4))
    N, N1 = q2 * t1 - q1 * t2, q3 * t1 - q1 * t3
    values = (q, q1 / t1, N / t1**3, (N1 * t1 - 3 * N * t2) / t1**5)[derivative]
    return t.ravel(), values.reshape(-1, values.shape[-1])
