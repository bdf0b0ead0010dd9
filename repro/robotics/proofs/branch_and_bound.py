"""Lower bound on the total time of a spline motion whose acceleration limits bite.

Velocity limits are linear in the durations, acceleration limits are not (see `limit_rows`). In a
box of durations the cubes of the latter are replaced by their chords: a linear programme, whose
optimum lies below that of the problem by an amount that falls with the square of the box. Boxes
that could hold a motion faster than the best known are shrunk by such programmes and halved, until
the bound of each is near it (R. Horst, H. Tuy, Global Optimization, 3rd ed., Springer 1996,
chapter IV).

The programmes are solved in doubles, and no bound rests on that: for any weights y >= 0, c·h is at
least y·g + min over the box of (c - yG)·h where Gh >= g, and both terms are worked out in rational
numbers (A. Neumaier, O. Shcherbina, Mathematical Programming 99 (2004) 283-296).
"""

import heapq
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from repro.errors import NotProvedError
from repro.robotics import MinimumTimeSpline
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Bend, Box, Cut, Rationals, Row, rounded_down, smallest

Vector = NDArray[np.float64]
BOXES = 2000  # after so many the bound reached counts
ROUNDS = 8  # of added limits in one box
STEPS = 200  # of the search for a motion
NEAR = 2e-5  # s: a box whose bound is as near the best motion is not looked into further
GAIN = 1e-9  # s: the search for a motion ends when a step gains less
COST_OF_BREACH = 1e4  # in the linear programmes, which so have an optimum in any box
SMALL = 1e-9  # weights below are left out of a bound
SHARE = 0.25  # of a box, that each part of it has at least


@dataclass(frozen=True, slots=True, kw_only=True)
class Bound:
    """A proved lower bound in s, the number of boxes, and the best motion (not proved to obey).

    `holding` are the limits that keep the motion from getting faster.
    """

    lower: Fraction
    boxes: int
    motion: Vector
    holding: tuple[Cut | Bend, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Optimum:
    """Optimum of a linear programme, and the weights of the limits and of the extra row."""

    x: Vector
    weights: Vector
    extra: float


def least_total(problem: MinimumTimeSpline, limits: Limits, start: Vector) -> Bound:
    """Return a bound on the total time of every motion that obeys, in s.

    `start` obeys. The search for a faster motion begins there, and again in a box in which one
    turns up. Every motion faster than the bound would lie in one of the boxes.
    """
    best, holding = descended(problem, limits, start)
    waiting = [(Fraction(0), 0, ((Fraction(0), Fraction(float(best.sum()))),) * problem.segments)]
    closed: list[Fraction] = []
    boxes = 0
    while waiting and waiting[0][0] < best.sum() - NEAR and boxes < BOXES:
        boxes += 1
        lower, _, box = heapq.heappop(waiting)
        smaller = tightened(limits, box, Fraction(float(best.sum())))
        if smaller is None:
            continue
        bound, found = _bounded(limits, smaller, best.sum() - NEAR)
        bound = max(bound, lower)
        motion = just_obeying(problem, found.x)
        if motion.sum() < best.sum() - GAIN:
            best, holding = descended(problem, limits, motion)
        if bound >= best.sum() - NEAR:
            closed.append(bound)
            continue
        for k, half in enumerate(_parts(limits, smaller, found)):
            heapq.heappush(waiting, (bound, 2 * boxes + k, half))
    least = min([*closed, *(bound for bound, _, _ in waiting), Fraction(float(best.sum()))])
    return Bound(lower=least, boxes=boxes, motion=best, holding=holding)


def just_obeying(problem: MinimumTimeSpline, durations: Vector) -> Vector:
    """Return a motion as slow as the limits need it; infinitely slow where time stands still."""
    scaled = replace(problem, handling="time scaling")
    if not np.isfinite(scaled.peak_shares(durations)).all():
        return np.full_like(durations, np.inf)
    return scaled.obeying(durations)


def descended(
    problem: MinimumTimeSpline, limits: Limits, start: Vector
) -> tuple[Vector, tuple[Cut | Bend, ...]]:
    """Return a motion from which no small change is faster, and the limits that hold it back.

    In each step the cubes are replaced by their tangents at the motion so far, so that the optimum
    of the linear programme obeys, and is no slower.
    """
    best, held = start, np.array([])
    for _ in range(STEPS):
        around = np.column_stack([best, best])
        anywhere = np.tile([0.0, best.sum()], (len(best), 1))
        for _ in range(ROUNDS):
            found = _solved(limits, np.ones(len(best)), around, anywhere)
            if not limits.add_worst(found.x):
                break
        motion = just_obeying(problem, found.x)
        gain = best.sum() - motion.sum()
        if gain <= 0.0:
            break
        best, held = motion, found.weights
        if gain < GAIN:
            break
    known = zip(limits.known, held, strict=False)
    return best, tuple(limit for limit, weight in known if weight > SMALL)


def tightened(limits: Limits, box: Box, total: Fraction) -> Box | None:
    """Return the part of a box that can hold obeying motions of this total time; None if none."""
    sides = list(box)
    for k, sign in np.ndindex(len(box), 2):
        unit = np.zeros(len(box))
        unit[k] = (1.0, -1.0)[sign]
        corners = np.array(sides, dtype=np.float64)
        found = _solved(limits, unit, corners, corners, total=float(total))
        bound = rounded_down(_proved(limits, unit, tuple(sides), found, total=total))
        low, high = sides[k]
        sides[k] = (low, min(high, -bound)) if sign else (max(low, bound), high)
        if sides[k][0] > sides[k][1]:
            return None
    return tuple(sides)


def _bounded(limits: Limits, box: Box, goal: float) -> tuple[Fraction, _Optimum]:
    """Return a bound on the total time in a box, and the optimum that it comes from."""
    corners, ones = np.array(box, dtype=np.float64), np.ones(len(box))
    for _ in range(ROUNDS):
        found = _solved(limits, ones, corners, corners)
        bound = _proved(limits, ones, box, found)
        if bound >= goal or not limits.add_worst(found.x):
            break
    return rounded_down(bound), found


def _solved(
    limits: Limits,
    objective: Vector,
    around: Vector,
    allowed: Vector,
    *,
    total: float | None = None,
) -> _Optimum:
    """Return the least objective among durations `allowed`, with rows as they are `around`."""
    weights, least, _ = limits.rows(around)
    if total is not None:
        weights = np.vstack([weights, -np.ones(len(objective))])
        least = np.append(least, -total)
    found = linprog(
        np.append(objective, COST_OF_BREACH),
        A_ub=-np.column_stack([weights, np.ones(len(least))]),
        b_ub=-least,
        bounds=[*allowed.tolist(), (0.0, None)],
        method="highs",
    )
    if found.status:
        message = f"a linear programme of the durations has no optimum: {found.message}"
        raise NotProvedError(message)
    y = np.maximum(-found.ineqlin.marginals, 0.0)
    extra = 0.0 if total is None else float(y[-1])
    return _Optimum(x=found.x[:-1], weights=y[: len(limits.known)], extra=extra)


def _proved(
    limits: Limits, objective: Vector, box: Box, found: _Optimum, *, total: Fraction = Fraction(0)
) -> Fraction:
    """Return a bound on the objective in a box, exactly, from weights that need not be exact."""
    used = [i for i in range(len(found.weights)) if found.weights[i] > SMALL]
    rows = [limits.known[i].row(box) for i in used]
    rows.append(((Fraction(-1),) * len(box), -total))
    weights = [Fraction(found.weights[i]) for i in used] + [Fraction(found.extra)]
    return weighed(tuple(map(Fraction, objective)), rows, weights, box)


def weighed(
    objective: Rationals, rows: Sequence[Row], weights: Sequence[Fraction], box: Box
) -> Fraction:
    """Return a bound on the objective in a box, for any weights >= 0 of rows that hold there."""
    rest = list(objective)
    bound = Fraction(0)
    for (row, least), weight in zip(rows, weights, strict=True):
        rest = [own - weight * entry for own, entry in zip(rest, row, strict=True)]
        bound += weight * least
    return bound + smallest(rest, box)


def _parts(limits: Limits, box: Box, found: _Optimum) -> tuple[Box, Box]:
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
