"""Minimum time through waypoints, at rest at each of them, under limits on every joint.

A joint that moves D in time T along a rest-to-rest law peaks at f_m · D / T^m in its m-th
derivative, so whether a motion obeys its limits is decided exactly, without sampling.
"""

from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.errors import DeclarationError
from repro.robotics.law import Law, check_law
from repro.robotics.motion_checks import (
    check_motion,
    check_word,
    checked_durations,
    number,
    numbers,
    rows,
)

Vector = NDArray[np.float64]
Handling = Literal[
    "feasibility first",
    "penalty",
    "rejection",
    "fixed penalties",
    "fixed penalties per joint",
    "fixed penalties per joint and segment",
    "fixed penalties where kept",
]
DERIVATIVES = {1: "velocity", 2: "acceleration", 3: "jerk"}
MARGIN = 2.0**-49
"""Share by which a least duration is lengthened so that it obeys in doubles.

The root of a product and a quotient is off by 4 units of 2^-53, and a check by the limits rounds
at most 5 times, so 9 units would do; these are 16.
"""
_PENALTIES = 5
_HEADER = 8


@jit
def _cost(x, data):
    segments, joints = int(data[0]), int(data[1])
    handling, weight, longest = data[2], data[3], data[4]
    total = 0.0
    excess = 0.0
    broken = 0  # one bit per kind of limit
    each = 0.0  # the prices of all broken limits, joint by joint and segment by segment
    for k in range(segments):
        total += x[k]
        power = 1.0
        for m in range(3):
            power *= x[k]
            factor = data[_HEADER + m]
            for j in range(joints):
                limit = data[_HEADER + 3 + m * joints + j]
                distance = data[_HEADER + 3 + 3 * joints + k * joints + j]
                peak_share = factor * distance / (power * limit)
                if peak_share > 1.0:
                    excess += peak_share - 1.0
                    broken |= 1 << m
                    each += data[_PENALTIES + m]
    if handling >= 3.0:
        return total + _price(x, broken, each, data)
    if excess == 0.0:
        return total
    if handling == 0.0:
        return longest + excess  # worse than every motion that obeys, and ordered by excess
    if handling == 1.0:
        return total + weight * excess
    return longest + 1.0


@jit
def _price_per_joint(x, data):
    segments, joints = int(data[0]), int(data[1])
    price = 0.0
    for m in range(3):
        for j in range(joints):
            limit = data[_HEADER + 3 + m * joints + j]
            for k in range(segments):
                distance = data[_HEADER + 3 + 3 * joints + k * joints + j]
                if data[_HEADER + m] * distance > limit * x[k] ** (m + 1):
                    price += data[_PENALTIES + m]
                    break
    return price


@jit
def _price(x, broken, each, data):
    handling = data[2]
    if handling == 4.0:
        return _price_per_joint(x, data)
    if handling == 5.0:
        return each
    kinds = ~broken if handling == 6.0 else broken
    price = 0.0
    for m in range(3):
        if kinds & (1 << m):
            price += data[_PENALTIES + m]
    return price


@dataclass(frozen=True, slots=True, kw_only=True)
class MinimumTime:
    """Choose the duration of each segment so that the sum is least and every limit is kept.

    `waypoints` (points, joints) in rad; every joint follows the `law`; `velocity`, `acceleration`,
    `jerk` are limits per joint in rad/s, rad/s², rad/s³; `durations` are the (shortest, longest)
    that a search may try, in s.
    `handling` says what a search is told of a motion that breaks a limit: "feasibility first"
    ranks it behind every motion that obeys (K. Deb, Computer Methods in Applied Mechanics and
    Engineering 186 (2000) 311-338), "penalty" adds `weight` seconds per unit of relative excess,
    "rejection" gives one flat cost, "fixed penalties" adds the velocity, acceleration or jerk entry
    of `penalties`, in s, once if any joint breaks a limit of that kind anywhere, or once per joint
    that does, or per joint and segment, or if no joint does ("where kept").
    """

    waypoints: tuple[tuple[float, ...], ...]
    law: Law
    velocity: tuple[float, ...]
    acceleration: tuple[float, ...]
    jerk: tuple[float, ...] | None = None
    durations: tuple[float, float]
    handling: Handling = "feasibility first"
    weight: float = 1000.0
    penalties: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        """Raise DeclarationError for a law, points, limits, times or penalties that cannot be.

        Arrays and lists are taken where tuples are meant.
        """
        free = "jerk" if self.jerk is None else ""
        limited = {m: kind for m, kind in DERIVATIVES.items() if kind != free}
        object.__setattr__(self, "waypoints", rows(self.waypoints, called="waypoints"))
        for name in (*limited.values(), "durations", "penalties"):
            object.__setattr__(self, name, numbers(getattr(self, name), called=name))
        kinds = {kind: getattr(self, kind) for kind in limited.values()}
        check_motion(self.waypoints, kinds, self.durations, called="waypoints")
        check_word(self.handling, get_args(Handling), called="handling")
        object.__setattr__(self, "weight", number(self.weight, called="weight"))
        if len(self.penalties) != 3:
            message = (
                f"penalties {self.penalties}: there must be three, of velocity, acceleration "
                f"and jerk, not {len(self.penalties)}"
            )
            raise DeclarationError(message)
        if not all(0.0 <= price < np.inf for price in (self.weight, *self.penalties)):
            message = f"weight {self.weight} and penalties {self.penalties} must be 0 or more"
            raise DeclarationError(message)
        check_law(self.law, limited)

    @property
    def segments(self) -> int:
        """Number of durations to choose."""
        return len(self.waypoints) - 1

    @property
    def distances(self) -> Vector:
        """Angle that each joint moves in each segment, shape (segments, joints), in rad."""
        return np.abs(np.diff(np.array(self.waypoints), axis=0))

    @property
    def limits(self) -> Vector:
        """Limits on the first three derivatives (3, joints), infinite where there is none."""
        jerk = (np.inf,) * len(self.velocity) if self.jerk is None else self.jerk
        return np.array([self.velocity, self.acceleration, jerk])

    @property
    def factors(self) -> Vector:
        """Peak factors of the law in the first three derivatives (3,), 0 where none is limited."""
        limited = [True, True, self.jerk is not None]
        return np.array([self.law.peak_factor(m) if limited[m - 1] else 0.0 for m in DERIVATIVES])

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
        longest = self.segments * self.durations[1]
        header = (self.segments, len(self.velocity), handling, self.weight, longest)
        limits, distances = self.limits.ravel(), self.distances.ravel()
        return np.concatenate([header, self.penalties, self.factors, limits, distances])

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return tuple(getattr(self, name) for name in self.__slots__)

    def shortest(self) -> Vector:
        """Return the least duration of each segment that keeps every limit, shape (segments,)."""
        return np.asarray(self.times_to_keep().max(axis=(1, 2)))

    def times_to_keep(self) -> Vector:
        """Return the least duration per (segment, derivative, joint), in s.

        Each is longer than the exact one by less than twice the MARGIN, so that it obeys in
        doubles, too.
        """
        factors = self.factors.tolist()
        least = [
            root(factors[m - 1] * self.distances / self.limits[m - 1]) * (1.0 + MARGIN)
            for m, root in enumerate((np.positive, np.sqrt, np.cbrt), start=1)
        ]
        return np.stack(least, axis=1)

    def obeys(self, durations: Vector) -> bool:
        """Return whether a motion keeps every limit, in doubles and as a search is told."""
        times = checked_durations(durations, self.segments)[:, None, None]
        asked = self.factors[:, None] * self.distances[:, None, :]
        with np.errstate(all="ignore"):  # beyond doubles nothing obeys
            powers = np.concatenate([times, times * times, times * times * times], axis=1)
            return bool((asked / (powers * self.limits) <= 1.0).all())

    def quantity(self, name: str, points: Vector) -> Vector:
        """Return "total" or "duration k" of motions `points` (…, segments), shape (…), in s.

        A segment that breaks a limit counts with the least duration that keeps it, so a reported
        time is the time of a motion that obeys; under fixed penalties it is what the search found.
        """
        known = ("total", *(f"duration {k + 1}" for k in range(self.segments)))
        if name not in known:
            message = f"a motion has no quantity {name!r}; it has {', '.join(known)}"
            raise DeclarationError(message)
        fixed = self.handling.startswith("fixed penalties")
        counted = points if fixed else np.maximum(points, self.shortest())
        if name == "total":
            return np.asarray(counted.sum(axis=-1))
        return np.asarray(counted[..., known.index(name) - 1])


def peak(problem: MinimumTime, durations: tuple[float, ...], derivative: int) -> float:
    """Return the largest value that any joint reaches in the derivative, in rad/s^derivative."""
    return float(peaks(problem, durations, derivative).max())


def peaks(problem: MinimumTime, durations: tuple[float, ...], derivative: int) -> Vector:
    """Return the largest value of each joint in the derivative, (joints,), rad/s^derivative."""
    factor = problem.law.peak_factor(derivative)
    times = checked_durations(durations, problem.segments)[:, None]
    return np.asarray((factor * problem.distances / times**derivative).max(axis=0))


def motion(
    problem: MinimumTime, durations: Vector, *, derivative: int, samples: int
) -> tuple[Vector, Vector]:
    """Return times (n,) and joint values (n, joints) of the whole motion, SI units."""
    durations = checked_durations(durations, problem.segments)
    share = np.linspace(0.0, 1.0, samples)
    points = np.array(problem.waypoints)
    ends = np.concatenate([[0.0], np.cumsum(durations)])
    times = [start + share * length for start, length in zip(ends, durations, strict=False)]
    curve = problem.law.sample(share, derivative)
    values = [
        (points[k] if derivative == 0 else 0.0)
        + np.outer(curve, points[k + 1] - points[k]) / durations[k] ** derivative
        for k in range(problem.segments)
    ]
    return np.concatenate(times), np.concatenate(values)
