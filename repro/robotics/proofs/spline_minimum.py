"""Proved minimum time of a motion whose time and angle are B-splines.

For given nodes the velocity limit |q'(u)| <= v·t'(u) is linear in the durations, for every u, so
without the acceleration limit the least total time is a linear programme. It gives

- a lower bound: finitely many u are a relaxation, and any non-negative weights of its rows prove a
  bound, in rational numbers (see `linear_programmes`);
- a motion: the optimum, lengthened a little, is proved to keep both limits on the whole interval
  by Bernstein coefficients, again in rational numbers.

Where a limit of acceleration or jerk bites, bound and motion come from `branch_and_bound` instead.
Both concern the problem as it stands in doubles. A fast problem and a slow one are one: the unit
of time is a power of two, in s, near the time of the motion.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError, NotProvedError
from repro.robotics.directed_spline import Spline, jerk_of, times
from repro.robotics.motion_checks import LARGEST
from repro.robotics.proofs.branch_and_bound import least_total
from repro.robotics.proofs.descent import chords, descended, just_obeying, starts
from repro.robotics.proofs.jolts import Jolt, Limit
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Cut, Exact, Rationals, cut, dot, exact
from repro.robotics.proofs.linear_programmes import TOLERANCES, weighed
from repro.robotics.proofs.positivity import derivative, difference, positive, product
from repro.robotics.proofs.watch import ENDLESS, Watch

Vector = NDArray[np.float64]
ROUNDS = 30  # of added cuts; the distance to the optimum falls with its square in every round
INFLATION = (1e-7, 1e-6, 1e-5)  # shares by which the optimum is lengthened, until it is proved
BREACH = 1e-12  # of a velocity limit, by which it is worth adding
_STILL = "time stands still at an end whatever the durations, so no motion has these `time_ends`"


@dataclass(frozen=True, slots=True, kw_only=True)
class SplineProof:
    """A proved lower bound, a motion proved to obey, and what holds it back, in s.

    `holding` are limits that the motion meets: they hold the bound up. `acceleration_share` is the
    greatest share of an acceleration limit that the motion reaches, `jerk_share` that of a jerk
    limit where there is one; `boxes` is how many boxes of durations the bound took, none where the
    velocity limits alone give it. Where no durations are found that obey there are none; where that
    is proved, the bound is infinite.
    """

    lower_bound: Fraction | float
    durations: Rationals
    holding: tuple[Limit, ...]
    acceleration_share: float
    jerk_share: float | None = None
    boxes: int

    @property
    def attained(self) -> Fraction:
        """Total time of the motion."""
        return sum(self.durations, Fraction(0))


@cache
def prove(problem: Spline) -> SplineProof:
    """Return the proof for one problem; NotProvedError where nothing can be proved."""
    return prove_within(problem, ENDLESS)


def prove_within(problem: Spline, watch: Watch) -> SplineProof:
    """Return as much of the proof as there is time for."""
    unit, scaled = _scaled(problem)
    found = _in_unit(scaled, watch.scaled(unit))
    scale = Fraction(unit)
    bound = found.lower_bound
    return replace(
        found,
        lower_bound=bound * scale if isinstance(bound, Fraction) else bound,
        durations=tuple(duration * scale for duration in found.durations),
        holding=tuple(_in_seconds(limit, scale) for limit in found.holding),
    )


def fastest_found(problem: Spline, watch: Watch) -> float | None:
    """Return the time of the fastest motion that is found, in s, without a proof of a bound."""
    unit, scaled = _scaled(problem)
    model = exact(scaled)
    cuts, optimum, _ = _optimum(scaled, model, watch)
    limits = Limits(model, cuts)
    tried = [descended(scaled, limits, start, watch)[0] for start in starts(scaled, optimum)]
    return min((unit * float(motion.sum()) for motion in tried), default=None)


def _scaled(problem: Spline) -> tuple[float, Spline]:
    """Return a unit of time in s, and the problem in it."""
    if problem.time_ends == "still":
        raise NotProvedError(_STILL)
    unit = 2.0 ** round(math.log2(_roughly(problem)))
    shortest, longest = problem.durations
    changed: dict[str, Any] = {
        "velocity": times(problem.velocity, unit),
        "acceleration": times(times(problem.acceleration, unit), unit),
        "durations": (shortest / unit, min(longest / unit, LARGEST)),
    }
    if (jerk := jerk_of(problem)) is not None:
        changed["jerk"] = times(times(times(jerk, unit), unit), unit)
    try:
        return unit, replace(problem, **changed)
    except DeclarationError as error:
        message = f"in units of {unit:.3g} s, about the motion's time, {error}"
        raise NotProvedError(message) from None


def _in_seconds(limit: Limit, unit: Fraction) -> Limit:
    if isinstance(limit, Cut):
        return replace(limit, least=limit.least * unit)
    if isinstance(limit, Jolt):
        turn = tuple(entry * unit**3 for entry in limit.turn)
        return replace(limit, least=limit.least * unit, turn=turn, share=limit.share * unit**3)
    turn = tuple(entry * unit * unit for entry in limit.turn)
    return replace(limit, least=limit.least * unit, turn=turn)


def _roughly(problem: Spline) -> float:
    """Return about how long the motion takes, in s."""
    return float(np.maximum(chords(problem), problem.durations[0]).sum())


def _in_unit(problem: Spline, watch: Watch) -> SplineProof:
    model = exact(problem)
    cuts, optimum, weights = _optimum(problem, model, watch)
    tried = starts(problem, optimum)
    lower: Fraction | float = _bound(problem, cuts, weights, tried)
    holding: tuple[Limit, ...] = tuple(
        limit for limit, weight in zip(cuts, weights, strict=True) if weight > BREACH
    )
    motion, boxes = just_obeying(problem, optimum), 0
    near = bool(motion.sum() <= optimum.sum() * (1.0 + INFLATION[0]))
    if not near and watch.over:
        motion, holding = (tried[0] if len(tried) else motion), ()
    elif not near:
        limits = Limits(model, cuts)
        bound = least_total(problem, limits, tried, watch)
        lower, boxes = max(lower, bound.lower), bound.boxes
        motion, holding = bound.motion, bound.holding
    durations = _lengthened(problem, model, motion)
    shares = _shares(problem, durations)
    return SplineProof(
        lower_bound=lower,
        durations=durations,
        holding=holding if durations else (),
        acceleration_share=shares[1] if durations else 0.0,
        jerk_share=shares[2] if len(shares) > 2 else None,
        boxes=boxes,
    )


def _shares(problem: Spline, durations: Rationals) -> list[float]:
    """Return the greatest shares of each kind of limit, none where there is no motion."""
    at = np.array(durations, dtype=np.float64)
    return [float(share) for share in problem.peak_shares(at)] if durations else []


def _lengthened(problem: Spline, model: Exact, motion: Vector) -> Rationals:
    """Return the motion lengthened so little that it is proved to obey, also in doubles.

    Nothing where that cannot be done with the durations allowed.
    """
    if not np.isfinite(motion).all():
        return ()
    for share in INFLATION:
        durations = np.clip(motion * (1.0 + share), *problem.durations)
        exactly = tuple(map(Fraction, durations.tolist()))
        if problem.obeys(durations) and _obeys(model, exactly):
            return exactly
    return ()


def _optimum(problem: Spline, model: Exact, watch: Watch) -> tuple[list[Cut], Vector, Vector]:
    """Return cuts, and optimum and dual weights of the linear programme that they make.

    Where the longest durations allowed are too short for it, it is that without them.
    """
    from scipy.optimize import linprog  # noqa: PLC0415 (slow to load)

    places = list(itertools.product(range(problem.segments), range(len(problem.velocity))))
    cuts = [cut(model, *place, Fraction(k, 4)) for place in places for k in range(5)]
    bounds: tuple[float, float | None] = problem.durations
    for _ in range(ROUNDS):
        rows = np.array([cut.weights for cut in cuts], dtype=np.float64)
        least = np.array([cut.least for cut in cuts], dtype=np.float64)
        ones = np.ones(problem.segments)
        found = linprog(
            ones, A_ub=-rows, b_ub=-least, bounds=bounds, method="highs", options=TOLERANCES
        )
        if found.status:
            if bounds[1] is not None:
                bounds = (problem.durations[0], None)
                continue
            message = f"the linear programme of the durations has no optimum: {found.message}"
            raise NotProvedError(message)
        worst = [_worst(model, place, found.x) for place in places]
        known = {(cut.span, cut.joint, cut.u) for cut in cuts}
        fresh = [place for place, excess in worst if excess > BREACH and place not in known]
        if not fresh or watch.over:
            break
        cuts += [cut(model, *place) for place in fresh]
    weights = np.maximum(-found.ineqlin.marginals, 0.0)
    return cuts[: len(weights)], found.x, weights


def _worst(
    model: Exact, place: tuple[int, int], durations: Vector
) -> tuple[tuple[int, int, Fraction], float]:
    """Return where on the span q' exceeds v·t' most, in either direction, and by how much."""
    span, joint = place
    slope = np.array(model.time[span], dtype=np.float64) @ durations
    angle = np.array(model.angle[span][joint], dtype=np.float64)
    low, high = map(float, model.velocity[joint])
    best = ((span, joint, Fraction(0)), -math.inf)
    for c0, c1, c2 in (angle / high - slope, angle / low - slope):
        turn = -c1 / (2.0 * c2) if c2 < 0.0 else 0.0
        for u in (0.0, min(max(turn, 0.0), 1.0), 1.0):
            excess = c0 + u * (c1 + u * c2)
            if excess > best[1]:
                best = ((span, joint, Fraction(u)), excess)
    return best


def _bound(problem: Spline, cuts: Sequence[Cut], weights: Vector, motions: Vector) -> Fraction:
    """Return an exact lower bound on every motion that is no slower than the best known."""
    n = problem.segments
    shortest, longest = map(Fraction, problem.durations)
    if len(motions):
        longest = min(longest, Fraction(float(motions[0].sum())))
    box = ((shortest, longest),) * n
    rows = [(each.weights, each.least) for each in cuts]
    return weighed((Fraction(1),) * n, rows, list(map(Fraction, weights.tolist())), box)


def _obeys(model: Exact, durations: Rationals) -> bool:
    """Prove that time never stands still and that every limit is kept on every span."""
    for span, matrix in enumerate(model.time):
        slope = [dot(row, durations) for row in matrix]
        cube = product(slope, product(slope, slope))
        if not positive(slope):
            return False
        for joint, angle in enumerate(model.angle[span]):
            bend = difference(product(derivative(angle), slope), product(angle, derivative(slope)))
            kinds = [
                (list(angle), slope, model.velocity[joint]),
                (bend, cube, model.acceleration[joint]),
            ]
            if model.jerk is not None:
                turned = [3 * entry for entry in product(bend, derivative(slope))]
                jolt = difference(product(derivative(bend), slope), turned)
                kinds.append((jolt, product(cube, product(slope, slope)), model.jerk[joint]))
            for curve, allowed, (low, high) in kinds:
                below = difference([high * entry for entry in allowed], curve)
                above = difference(curve, [low * entry for entry in allowed])
                if not (positive(below) and positive(above)):
                    return False
    return True
