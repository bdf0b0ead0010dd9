"""Motions of one polynomial per joint and segment that may start and end moving.

In a segment of time T, with τ = t/T, a joint that moves from a by D is at a + D·s(τ) + T·(v0·r(τ) -
v1·r(1 - τ)). s is the rest-to-rest polynomial of its degree 2k + 1, r the polynomial of that degree
whose slope is 1 at τ = 0 and 0 at 1, and whose values and further derivatives up to the k-th are 0
at both. v0 is the velocity at the start of the first segment and v1 that at the end of the last;
between segments the motion rests.
"""

import math
import operator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.robotics.bsplines import solve
from repro.robotics.motion_checks import (
    Rows,
    check_motion,
    checked_durations,
    limit_pairs,
    numbers,
    rows,
)
from repro.robotics.polynomials import bernstein, check_degree

Vector = NDArray[np.float64]
Rationals = tuple[Fraction, ...]
ROOTS = 12  # coefficients of which a polynomial's roots are found to the last digits
FINE, ZOOMS = 100, 4  # samples of a polynomial of more, and how often its extremes are approached
COMPUTED = (1e-60, 1e60)  # s: durations whose cubes doubles hold, and what is divided by them
_TO_POWERS = [
    np.array(
        [
            [math.comb(n, i) * math.comb(i, k) * (-1.0) ** (i - k) for k in range(n + 1)]
            for i in range(n + 1)
        ]
    )
    for n in range(ROOTS)
]
"""From Bernstein coefficients to those of 1, τ, τ², …, by degree."""
KINDS = {0: "range", 1: "velocity", 2: "acceleration", 3: "jerk"}


@dataclass(frozen=True, slots=True, kw_only=True)
class PolynomialMotion:
    """Choose the duration of each segment so that the sum is least and every limit is kept.

    `waypoints` (points, joints); `velocity`, `acceleration`, `jerk` and `range` have a (lowest,
    highest) per joint, in the unit of the waypoints and s, infinite where there is none; the
    velocities at `start` and `end` have a number per joint. `durations` are the (shortest,
    longest) allowed, in s.
    """

    waypoints: Rows
    degree: int
    velocity: Rows
    acceleration: Rows
    jerk: Rows | None = None
    range: Rows | None = None
    start: tuple[float, ...] | None = None
    end: tuple[float, ...] | None = None
    durations: tuple[float, float]

    def __post_init__(self) -> None:
        """Raise DeclarationError for points, limits, velocities or times that cannot be."""
        check_degree(self.degree)
        put: Any = object.__setattr__
        put(self, "waypoints", rows(self.waypoints, called="waypoints"))
        put(self, "durations", numbers(self.durations, called="durations"))
        check_motion(self.waypoints, {}, self.durations, called="waypoints")
        if self.durations[0] < COMPUTED[0] or self.durations[1] > COMPUTED[1]:
            message = (
                f"durations {self.durations}: computed are {COMPUTED[0]:g} to {COMPUTED[1]:g} s"
            )
            raise DeclarationError(message)
        for kind in KINDS.values():
            if getattr(self, kind) is not None or kind in {"velocity", "acceleration"}:
                put(self, kind, self._pairs(kind))
        for name in ("start", "end"):
            put(self, name, self._speeds(name))

    def _pairs(self, kind: str) -> Rows:
        pairs = rows(getattr(self, kind), called=kind)
        if len(pairs) != self.joints or any(len(pair) != 2 for pair in pairs):
            message = f"{kind}: {self.joints} joints need {self.joints} pairs of lowest and highest"
            raise DeclarationError(message)
        if kind != "range":
            return limit_pairs(pairs, called=kind)
        for joint, (low, high) in enumerate(pairs, start=1):
            if not low < high:
                message = f"{kind} of joint {joint}: ({low!r}, {high!r}) must be lowest < highest"
                raise DeclarationError(message)
            for place, point in enumerate(self.waypoints, start=1):
                if not low <= (value := point[joint - 1]) <= high:
                    message = (
                        f"waypoints: joint {joint} of number {place} is {value!r}, outside its "
                        f"range from {low!r} to {high!r}"
                    )
                    raise DeclarationError(message)
        return pairs

    def _speeds(self, name: str) -> tuple[float, ...]:
        given = getattr(self, name)
        speeds = (
            (0.0,) * self.joints if given is None else numbers(given, called=f"{name} velocity")
        )
        if len(speeds) != self.joints:
            message = f"{name} velocity: {self.joints} joints need {self.joints}, not {len(speeds)}"
            raise DeclarationError(message)
        for joint, (speed, (low, high)) in enumerate(zip(speeds, self.velocity, strict=True), 1):
            if not low <= speed <= high:
                message = (
                    f"{name} velocity of joint {joint} is {speed!r}, outside its limits from "
                    f"{low!r} to {high!r}"
                )
                raise DeclarationError(message)
        return speeds

    @property
    def joints(self) -> int:
        """Number of joints."""
        return len(self.waypoints[0])

    @property
    def segments(self) -> int:
        """Number of durations to choose."""
        return len(self.waypoints) - 1

    def bounds(self, derivative: int, joint: int) -> tuple[float, float]:
        """Return the least and greatest value that a derivative may have, infinite for none."""
        pairs = getattr(self, KINDS[derivative])
        return (-math.inf, math.inf) if pairs is None else pairs[joint]

    def moves(self, segment: int, joint: int) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """Return start and end of a joint in a segment, and its velocities there, exactly."""
        start, end = (Fraction(self.waypoints[segment + k][joint]) for k in (0, 1))
        first = self.start[joint] if segment == 0 and self.start else 0.0
        last = self.end[joint] if segment == self.segments - 1 and self.end else 0.0
        return start, end, Fraction(first), Fraction(last)

    def value(
        self, segment: int, joint: int, derivative: int, share: Fraction
    ) -> tuple[Fraction, Fraction]:
        """Return a derivative at τ times T^derivative, exactly: what stands alone and by T."""
        start, end, first, last = self.moves(segment, joint)
        powers = [share**power for power in range(self.degree + 1 - derivative)]
        shape, hook, back = (
            sum(map(operator.mul, derived(p, derivative), powers), Fraction(0))
            for p in (*shapes(self.degree), _back(self.degree))
        )
        still = (end - start) * shape + (start if derivative == 0 else 0)
        return still, first * hook - last * back

    def obeys(self, durations: Vector) -> bool:
        """Return whether a motion keeps every limit, in doubles, at its turning points."""
        times = checked_durations(durations, self.segments)
        return all(
            low <= least and most <= high
            for segment, joint in np.ndindex(self.segments, self.joints)
            for m in KINDS
            for low, high in [self.bounds(m, joint)]
            if low > -math.inf or high < math.inf
            for least, most in [extremes(self, segment, joint, m, float(times[segment]))[:2]]
        )


@cache
def shapes(degree: int) -> tuple[Rationals, Rationals]:
    """Return s and r of a degree as exact coefficients of 1, τ, τ², …."""
    k = (degree - 1) // 2
    falling = [[Fraction(math.perm(power, m)) for power in range(degree + 1)] for m in range(k + 1)]
    at_start = [[f if power == m else Fraction(0) for power, f in enumerate(row)]
                for m, row in enumerate(falling)]  # fmt: skip
    asked = [[Fraction(0), Fraction(int(m == 1))] for m in range(k + 1)]
    asked += [[Fraction(int(m == 0)), Fraction(0)] for m in range(k + 1)]
    found = solve(at_start + falling, asked)
    return tuple(row[0] for row in found), tuple(row[1] for row in found)


def mirrored(p: Rationals) -> Rationals:
    """Return the coefficients of p(1 - τ)."""
    n = len(p)
    return tuple(
        sum((p[j] * math.comb(j, i) * (-1) ** i for j in range(i, n)), Fraction(0))
        for i in range(n)
    )


def derived(p: Rationals, order: int) -> Rationals:
    """Return the coefficients of a derivative."""
    return tuple(math.perm(power, order) * entry for power, entry in enumerate(p))[order:]


@cache
def _back(degree: int) -> Rationals:
    """Return the coefficients of r(1 - τ)."""
    return mirrored(shapes(degree)[1])


@cache
def _bernstein_shapes(degree: int, derivative: int) -> tuple[Rationals, ...]:
    """Return the Bernstein coefficients of a derivative of s(τ), r(τ) and r(1 - τ)."""
    return tuple(tuple(bernstein(derived(p, derivative))) for p in (*shapes(degree), _back(degree)))


def bernstein_curve(
    problem: PolynomialMotion, segment: int, joint: int, derivative: int, time: Fraction
) -> list[Fraction]:
    """Return the Bernstein coefficients of a derivative times T^derivative, exactly."""
    start, end, first, last = problem.moves(segment, joint)
    by = (end - start, time * first, -time * last)
    used = [(k, factor) for k, factor in enumerate(by) if factor]
    base = start if derivative == 0 else Fraction(0)
    return [
        sum((factor * parts[k] for k, factor in used), base)
        for parts in zip(*_bernstein_shapes(problem.degree, derivative), strict=True)
    ]


def _doubles(
    problem: PolynomialMotion, segment: int, joint: int, derivative: int, time: float
) -> Vector:
    """Return Bernstein coefficients of a derivative, from which doubles lose nothing."""
    exactly = Fraction(time)
    scale = exactly**derivative
    curve = bernstein_curve(problem, segment, joint, derivative, exactly)
    return np.array([entry / scale for entry in curve], dtype=np.float64)


def extremes(
    problem: PolynomialMotion, segment: int, joint: int, derivative: int, time: float
) -> tuple[float, float, float, float]:
    """Return least and greatest value of a derivative in a segment, and the τ of both."""
    coefficients = _doubles(problem, segment, joint, derivative, time)
    places = _turns(coefficients)
    values = at_shares(coefficients, places)
    low, high = int(values.argmin()), int(values.argmax())
    return float(values[low]), float(values[high]), float(places[low]), float(places[high])


def at_shares(coefficients: Vector, share: Vector) -> Vector:
    """Return the values at `share` (k,) of a polynomial on [0, 1], by de Casteljau's scheme."""
    rest = np.tile(coefficients[:, None], len(share))
    while len(rest) > 1:
        rest = rest[:-1] * (1.0 - share) + rest[1:] * share
    # no value is beyond the coefficients but by rounding, which a start at a limit would not bear
    return np.asarray(np.clip(rest[0], coefficients.min(), coefficients.max()))


def _turns(coefficients: Vector) -> Vector:
    """Return both ends and where the curve turns: by roots, or of a high degree as sampled."""
    ends = np.array([0.0, 1.0])
    if len(coefficients) <= ROOTS:
        slope = np.polynomial.Polynomial(_TO_POWERS[len(coefficients) - 1] @ coefficients).deriv()
        slope = slope.trim()
        turns = slope.roots().real if slope.degree() > 0 else np.zeros(0)
        return np.concatenate([ends, turns[(turns > 0.0) & (turns < 1.0)]])
    places = np.linspace(0.0, 1.0, FINE + 1)
    for zoom in range(1, ZOOMS + 1):
        values = at_shares(coefficients, places)
        found = np.array([places[values.argmin()], places[values.argmax()]])
        near = found[:, None] + np.linspace(-2.0, 2.0, FINE + 1) / FINE**zoom
        places = np.clip(np.concatenate([found, near.ravel()]), 0.0, 1.0)
    return np.concatenate([ends, found])


def motion(
    problem: PolynomialMotion, durations: Vector, *, derivative: int, samples: int
) -> tuple[Vector, Vector]:
    """Return times (n,) and joint values (n, joints) of the whole motion."""
    durations = checked_durations(durations, problem.segments)
    share = np.linspace(0.0, 1.0, samples)
    ends = np.concatenate([[0.0], np.cumsum(durations)])
    values = np.empty((problem.segments, samples, problem.joints))
    for k, j in np.ndindex(problem.segments, problem.joints):
        coefficients = _doubles(problem, k, j, derivative, float(durations[k]))
        values[k, :, j] = at_shares(coefficients, share)
    times = ends[:-1, None] + share * durations[:, None]
    return times.ravel(), values.reshape(-1, problem.joints)
