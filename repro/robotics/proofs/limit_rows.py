"""The limits of a spline motion as exact inequalities of its durations h.

With p = dq/du and s = dt/du, prime for d/du, and v, a limits of one joint, above 0 upwards and
below 0 downwards, at every u

- velocity p/v <= s is linear in h (a `Cut`);
- acceleration (p's - ps')/a <= s³ has a linear left side and a cube on the right (a `Bend`).

The cube is convex for s >= 0, so between two values of s it lies below its chord, and everywhere
above its tangent. Where s is known to lie between the two, the chord in place of the cube gives a
linear inequality that every obeying motion fulfils; the tangent gives one that only obeying
motions fulfil.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from repro.robotics.bsplines import Matrix, span_weights
from repro.robotics.directed_spline import Limits, Spline, jerk_of, sides
from repro.robotics.spline_motion import slope_weights

Rationals = tuple[Fraction, ...]
Pairs = tuple[tuple[Fraction, Fraction], ...]
Row = tuple[Rationals, Fraction]  # weights and the least that weights · durations may be
Box = tuple[tuple[Fraction, Fraction], ...]  # shortest and longest of each duration


@dataclass(frozen=True, slots=True, kw_only=True)
class Exact:
    """dt/du as matrices, dq/du as coefficients per span and joint, and the limits, all exact.

    The limits are the lowest and the highest of each joint; there may be none of the jerk.
    """

    time: tuple[Matrix, ...]
    angle: tuple[tuple[Rationals, ...], ...]
    velocity: Pairs
    acceleration: Pairs
    jerk: Pairs | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Cut:
    """A velocity limit at one u of a span, as the row `weights` · durations >= `least`.

    `sign` is 1 upwards and -1 downwards.
    """

    span: int
    joint: int
    u: Fraction
    sign: int
    weights: Rationals
    least: Fraction

    def row(self, _box: Box) -> Row:
        """Return the limit, which is a row as it stands."""
        return self.weights, self.least


@dataclass(frozen=True, slots=True, kw_only=True)
class Bend:
    """An acceleration limit at one u of a span, as (`slope` · durations)³ >= `turn` · durations.

    `sign` is 1 upwards and -1 downwards; `least` is what the velocity limits alone ask of
    `slope` · durations there.
    """

    span: int
    joint: int
    u: Fraction
    sign: int
    slope: Rationals
    turn: Rationals
    least: Fraction

    def row(self, box: Box) -> Row:
        """Return the chord, a row that every obeying motion in the box fulfils.

        For a box that is one point it is the tangent: what fulfils that row obeys.
        """
        low = max(self.least, smallest(self.slope, box))
        high = max(low, -smallest([-entry for entry in self.slope], box))
        steep = high * high + high * low + low * low
        weights = (steep * own - other for own, other in zip(self.slope, self.turn, strict=True))
        return tuple(weights), steep * low - low**3


def exact(problem: Spline) -> Exact:
    """Return what the limits are made of, as the problem stands in doubles."""
    columns = list(zip(*problem.nodes, strict=True))
    joints = [[Fraction(angle) for angle in column] for column in columns]
    return Exact(
        time=slope_weights(problem.segments, problem.time_ends),
        angle=tuple(
            tuple(tuple((k + 1) * dot(matrix[k + 1], nodes) for k in range(3)) for nodes in joints)
            for matrix in span_weights(len(problem.nodes), problem.ends)
        ),
        velocity=_exact_sides(problem.velocity),
        acceleration=_exact_sides(problem.acceleration),
        jerk=None if (jerk := jerk_of(problem)) is None else _exact_sides(jerk),
    )


def _exact_sides(limits: Limits) -> Pairs:
    return tuple((Fraction(low), Fraction(high)) for low, high in sides(limits))


def dot(first: Sequence[Fraction], second: Sequence[Fraction]) -> Fraction:
    """Return the scalar product."""
    return sum((a * b for a, b in zip(first, second, strict=True)), Fraction(0))


def smallest(weights: Sequence[Fraction], box: Box) -> Fraction:
    """Return the least value of weights · durations in a box."""
    pairs = zip(weights, box, strict=True)
    return sum((w * (low if w > 0 else high) for w, (low, high) in pairs), Fraction(0))


def rounded_down(number: Fraction) -> Fraction:
    """Return a double that is not above the number: short to calculate with."""
    return Fraction(math.nextafter(float(number), -math.inf))


def cut(model: Exact, span: int, joint: int, u: Fraction) -> Cut:
    """Return the velocity limit of a joint at one u, in the direction in which it moves."""
    powers = (Fraction(1), u, u * u)
    step = dot(model.angle[span][joint], powers)
    sign = 1 if step >= 0 else -1
    return Cut(
        span=span,
        joint=joint,
        u=u,
        sign=sign,
        weights=combined(model.time[span], powers),
        least=step / model.velocity[joint][sign > 0],
    )


def bend(model: Exact, span: int, joint: int, u: Fraction, *, sign: int) -> Bend:
    """Return the acceleration limit of a joint at one u, upwards (sign 1) or downwards (-1)."""
    powers, rates = (Fraction(1), u, u * u), (Fraction(0), Fraction(1), 2 * u)
    angle = model.angle[span][joint]
    p, p1 = dot(angle, powers), dot(angle, rates)
    slope, slope1 = (combined(model.time[span], by) for by in (powers, rates))
    share = 1 / model.acceleration[joint][sign > 0]
    speeds = zip(model.angle[span], model.velocity, strict=True)
    return Bend(
        span=span,
        joint=joint,
        u=u,
        sign=sign,
        slope=slope,
        turn=tuple(share * (p1 * s - p * s1) for s, s1 in zip(slope, slope1, strict=True)),
        least=max(dot(other, powers) / limit for other, pair in speeds for limit in pair),
    )


def combined(matrix: Matrix, powers: Sequence[Fraction]) -> Rationals:
    """Return the linear form of the durations that the rows of a matrix, so weighted, add up to."""
    return tuple(dot(column, powers) for column in zip(*matrix, strict=True))
