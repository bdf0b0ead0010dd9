"""Lower bound on the total time of a spline motion whose acceleration or jerk limits bite.

Velocity limits are linear in the durations, acceleration limits are not (see `limit_rows`), nor
are those of the jerk (see `jolts`). In a box of durations the cubes of the acceleration limits are
replaced by their chords, and those of the jerk likewise: a linear programme, whose
optimum lies below that of the problem by an amount that falls with the square of the box. Boxes
that could hold a motion faster than the best known are shrunk by such programmes and halved, until
the bound of each is near it (R. Horst, H. Tuy, Global Optimization, 3rd ed., Springer 1996,
chapter IV). Every bound is proved in rational numbers (see `linear_programmes`).
"""

import heapq
import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from repro.robotics.directed_spline import Spline
from repro.robotics.proofs.descent import GAIN, descended, just_obeying
from repro.robotics.proofs.jolts import Limit
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Box, rounded_down
from repro.robotics.proofs.linear_programmes import Optimum, proved, solved
from repro.robotics.proofs.watch import ENDLESS, Watch

Vector = NDArray[np.float64]
BOXES = 2000  # after so many the bound reached counts
ROUNDS = 8  # of added limits in one box
NEAR = 1e-6  # share of the best motion's time: a box whose bound is as near is not looked into
SHARE = 0.25  # of a box, that each part of it has at least


@dataclass(frozen=True, slots=True, kw_only=True)
class Bound:
    """A proved lower bound in s, the number of boxes, and the best motion (not proved to obey).

    `holding` are the limits that keep the motion from getting faster. Where no durations allowed
    obey, `motion` and, once that is proved, `lower` are infinite.
    """

    lower: Fraction | float
    boxes: int
    motion: Vector
    holding: tuple[Limit, ...]


def least_total(problem: Spline, limits: Limits, starts: Vector, watch: Watch = ENDLESS) -> Bound:
    """Return a bound on the total time of every motion that obeys, in s.

    `starts` (n, segments) obey, none where none is known. The search for a faster motion begins
    there, and again in a box in which one turns up. Every motion faster than the bound would lie
    in one of the boxes.
    """
    best, holding = _fastest(problem, limits, starts, watch)
    longest, waiting = _whole(problem, best)
    closed: list[Fraction] = []
    boxes = 0
    while waiting and waiting[0][0] < _near(best) and boxes < BOXES and not watch.over:
        boxes += 1
        lower, _, box = heapq.heappop(waiting)
        watch.tell(float(min([lower, *closed])), float(best.sum()))
        smaller = tightened(limits, box, longest, watch)
        if smaller is None:
            continue
        bound, optimum = _bounded(limits, smaller, _near(best), watch)
        bound = max(bound, lower)
        motion = just_obeying(problem, optimum.x)
        if motion.sum() < best.sum() * (1.0 - GAIN) or best.sum() == math.inf > motion.sum():
            best, holding = descended(problem, limits, motion, watch)
            longest = Fraction(float(best.sum()))
        if bound >= _near(best):
            closed.append(bound)
            continue
        for k, half in enumerate(_parts(limits, smaller, optimum)):
            heapq.heappush(waiting, (bound, 2 * boxes + k, half))
    ends = [*closed, *(bound for bound, _, _ in waiting)]
    if best.sum() < math.inf:
        ends.append(Fraction(float(best.sum())))
    return Bound(lower=min(ends, default=math.inf), boxes=boxes, motion=best, holding=holding)


def _fastest(
    problem: Spline, limits: Limits, starts: Vector, watch: Watch
) -> tuple[Vector, tuple[Limit, ...]]:
    """Return the best of the motions gone down to, an endless one where there is no start."""
    endless: Vector = np.full(problem.segments, math.inf)
    found = (descended(problem, limits, start, watch) for start in starts)
    return min(found, key=_time, default=(endless, ()))


def _whole(problem: Spline, best: Vector) -> tuple[Fraction, list[tuple[Fraction, int, Box]]]:
    """Return the longest total time of interest, and the box of all durations to look into."""
    lowest, highest = map(Fraction, problem.durations)
    known = best.sum() < math.inf
    longest = Fraction(float(best.sum())) if known else problem.segments * highest
    box = ((lowest, min(highest, longest)),) * problem.segments
    return longest, [(problem.segments * lowest, 0, box)]


def _time(found: tuple[Vector, object]) -> float:
    return float(found[0].sum())


def _near(best: Vector) -> float:
    return float(best.sum()) * (1.0 - NEAR)


def tightened(limits: Limits, box: Box, total: Fraction, watch: Watch = ENDLESS) -> Box | None:
    """Return the part of a box that can hold obeying motions of this total time; None if none."""
    sides = list(box)
    for k, sign in np.ndindex(len(box), 2):
        if watch.over:
            break
        unit = np.zeros(len(box))
        unit[k] = (1.0, -1.0)[sign]
        corners = np.array(sides, dtype=np.float64)
        found = solved(limits, unit, corners, corners, total=float(total))
        bound = rounded_down(proved(limits, unit, tuple(sides), found, total=total))
        low, high = sides[k]
        sides[k] = (low, min(high, -bound)) if sign else (max(low, bound), high)
        if sides[k][0] > sides[k][1]:
            return None
    return tuple(sides)


def _bounded(limits: Limits, box: Box, goal: float, watch: Watch) -> tuple[Fraction, Optimum]:
    """Return a bound on the total time in a box, and the optimum that it comes from."""
    corners, ones = np.array(box, dtype=np.float64), np.ones(len(box))
    for _ in range(ROUNDS):
        found = solved(limits, ones, corners, corners)
        bound = proved(limits, ones, box, found)
        if bound >= goal or watch.over or not limits.add_worst(found.x):
            break
    return rounded_down(bound), found


def _parts(limits: Limits, box: Box, found: Optimum) -> tuple[Box, Box]:
    """Return two parts, cut near the optimum across the side that loosens the bound most."""
    corners = np.array(box, dtype=np.float64)
    point = np.column_stack([found.x, found.x])
    n = len(found.weights)
    chords, tangents = limits.rows(corners), limits.rows(point)
    room = [(rows[0] @ found.x - rows[1])[:n] for rows in (chords, tangents)]
    width = corners[:, 1] - corners[:, 0]
    looseness = (found.weights * np.maximum(room[0] - room[1], 0.0)) @ abs(chords[2][:n]) * width
    k = int(np.argmax(looseness if looseness.any() else width))
    low, high = box[k]
    margin = SHARE * width[k]
    at = Fraction(float(np.clip(found.x[k], corners[k, 0] + margin, corners[k, 1] - margin)))
    return (*box[:k], (low, at), *box[k + 1 :]), (*box[:k], (at, high), *box[k + 1 :])
