"""The jerk limits of a spline motion as exact inequalities of its durations h.

With p = dq/du, s = dt/du, N = p's - ps', prime for d/du, the jerk is (N's - 3Ns')/s⁵, and

    N's - 3Ns' = s·(p''s - 3p's' - ps'' + 3p·s'²/s).

So a limit j of one joint, above 0 upwards and below 0 downwards, is at every u

    (p''s - 3p's' - ps'')/j + (3p/j)·s'²/s <= s⁴        (a `Jolt`),

where s, s' and s'' are linear in h. Between two values of s > 0 the fourth power lies below its
chord, as the cube of a `Bend` does. And s'²/s lies

- above 2rs' - r²s for every r, as (s' - rs)² >= 0;
- below (a + b)s' - abs where s'/s is from a to b, as (s' - as)(s' - bs) <= 0 there.

With the first where p/j is above 0 and the second where it is below, what is left is a linear
inequality that every obeying motion in a box fulfils. What it loses falls with the square of the
box, and, where p/j is above 0, of the distance from r.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from repro.robotics.proofs.limit_rows import (
    Bend,
    Box,
    Cut,
    Exact,
    Rationals,
    Row,
    combined,
    dot,
    rounded_down,
    smallest,
)

Vector = NDArray[np.float64]
DIGITS = 2**20  # of ratios s'/s, which need not be exact but short to calculate with
STEEPEST = Fraction(2**10)  # ratio s'/s; where time nearly stands still there are greater ones
WIDEST = 2**10  # ratio of two values of s between which a limit below 0 is looked into
TINY = 1e-300  # keeps 0/0 away
NEAREST, FARTHEST = 1e-50, 1e50  # s by a motion's time, beyond which powers are no doubles


@dataclass(frozen=True, slots=True, kw_only=True)
class Jolt:
    """A jerk limit at one u of a span: turn · h + `share` (rate · h)²/(slope · h) <= (slope · h)⁴.

    `sign` is 1 upwards and -1 downwards; `least` is what the velocity limits alone ask of
    `slope` · h there; `ratio` is the r of the tangent, 0 where there is none.
    """

    span: int
    joint: int
    u: Fraction
    sign: int
    slope: Rationals
    rate: Rationals
    turn: Rationals
    share: Fraction
    least: Fraction
    ratio: Fraction

    def row(self, box: Box) -> Row:
        """Return a row that every obeying motion in the box fulfils.

        It asks nothing where the box is so wide that it could not be calculated with.
        """
        low = max(Fraction(0), rounded_down(max(self.least, smallest(self.slope, box))))
        high = max(low, -rounded_down(smallest([-entry for entry in self.slope], box)))
        still = low * WIDEST <= high or low <= NEAREST
        if high > FARTHEST or (self.share < 0 and still):
            return (Fraction(0),) * len(box), Fraction(0)
        first, second = self._ratios(box, low, high) if self.share < 0 else (self.ratio,) * 2
        steep = (high + low) * (high * high + low * low)
        by_slope = steep + self.share * first * second
        by_rate = self.share * (first + second)
        forms = zip(self.slope, self.rate, self.turn, strict=True)
        weights = (by_slope * own - by_rate * rate - turn for own, rate, turn in forms)
        return tuple(weights), steep * low - low**4

    def _ratios(self, box: Box, low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
        """Return between which two values s'/s lies in the box, where s is from low to high."""
        middle = [(least + most) / 2 for least, most in box]
        ratio = dot(self.rate, middle) / max(low, dot(self.slope, middle))
        centre = _short(max(-STEEPEST, min(ratio, STEEPEST)))
        off = [rate - centre * own for own, rate in zip(self.slope, self.rate, strict=True)]
        least, most = smallest(off, box), -smallest([-entry for entry in off], box)
        first = centre + min(least / low, least / high)
        second = centre + max(most / low, most / high)
        return rounded_down(first), -rounded_down(-second)


Limit = Cut | Bend | Jolt


def jolt(model: Exact, span: int, joint: int, u: Fraction, *, sign: int, ratio: float) -> Jolt:
    """Return the jerk limit of a joint at one u, upwards (sign 1) or downwards (-1).

    `ratio` is s'/s of a motion near which its row should be sharp.
    """
    none, one = Fraction(0), Fraction(1)
    orders = ((one, u, u * u), (none, one, 2 * u), (none, none, 2 * one))
    powers = orders[0]
    p, p1, p2 = (dot(model.angle[span][joint], by) for by in orders)
    s, s1, s2 = (combined(model.time[span], by) for by in orders)
    by = 1 / (model.jerk or ())[joint][sign > 0]
    speeds = zip(model.angle[span], model.velocity, strict=True)
    tangent = np.clip(ratio, -float(STEEPEST), float(STEEPEST)) if p * sign > 0 else 0.0
    return Jolt(
        span=span,
        joint=joint,
        u=u,
        sign=sign,
        slope=s,
        rate=s1,
        turn=tuple(by * (p2 * a - 3 * p1 * b - p * c) for a, b, c in zip(s, s1, s2, strict=True)),
        share=3 * p * by,
        least=max(dot(other, powers) / limit for other, pair in speeds for limit in pair),
        ratio=_short(Fraction(float(tangent))),
    )


def _short(number: Fraction) -> Fraction:
    return Fraction(round(number * DIGITS), DIGITS)


def doubles(limit: Jolt) -> tuple[float, ...]:
    """Return a Jolt as a row of the table that `jolt_rows` takes."""
    parts = (*limit.slope, *limit.rate, *limit.turn, limit.share, limit.least, limit.ratio)
    return tuple(map(float, parts))


def jolt_rows(table: Sequence[tuple[float, ...]], box: Vector) -> tuple[Vector, Vector, Vector]:
    """Return weights (n, durations) and least values (n,) of the rows of Jolts in a box.

    They are the exact ones but for rounding. The third (n, durations) is what the row loses by the
    width of each side: by s, by s'/s, or by both in the share that they have in it.
    """
    n = len(box)
    numbers = np.array(table)
    slope, rate, turn = (numbers[:, k * n : (k + 1) * n] for k in range(3))
    share, floor, ratio = numbers[:, 3 * n :].T
    low = np.maximum(np.maximum(floor, _smallest(slope, box)), 0.0)
    high = np.maximum(low, -_smallest(-slope, box))
    used = (high <= FARTHEST) & ((share >= 0.0) | ((low * WIDEST > high) & (low > NEAREST)))
    low, high = np.where(used, low, 1.0), np.where(used, high, 1.0)
    under = np.where(low > 0.0, low, 1.0)  # of those that are looked into it is
    above = np.where(high > 0.0, high, 1.0)
    middle, limit = box.mean(axis=1), float(STEEPEST)
    ratios = np.clip(rate @ middle / np.maximum(under, slope @ middle), -limit, limit)
    centre = np.round(ratios * DIGITS) / DIGITS
    off = rate - centre[:, None] * slope
    least, most = _smallest(off, box), -_smallest(-off, box)
    ranged = used & (share < 0.0)
    first = np.where(ranged, centre + np.minimum(least / under, least / above), ratio)
    second = np.where(ranged, centre + np.maximum(most / under, most / above), ratio)
    steep = (high + low) * (high * high + low * low)
    by_slope, by_rate = steep + share * first * second, share * (first + second)
    weights = np.where(
        used[:, None], by_slope[:, None] * slope - by_rate[:, None] * rate - turn, 0.0
    )
    # roughly the distances of the fourth power and its chord, and of s'²/s and what stands for it
    power = 1.5 * (high * (high - low)) ** 2
    square = np.maximum(-share, 0.0) * high * (second - first) ** 2 / 4.0
    part = (square / np.maximum(power + square, TINY))[:, None]
    loosening = (1.0 - part) * abs(slope) + part * abs(off)
    return weights, np.where(used, steep * low - low**4, 0.0), loosening


def _smallest(weights: Vector, box: Vector) -> Vector:
    """Return the least values (n,) of weights (n, durations) · durations in a box."""
    return np.asarray(np.maximum(weights, 0.0) @ box[:, 0] + np.minimum(weights, 0.0) @ box[:, 1])
