"""Proved minimum time of a motion whose time and angle are B-splines.

For given nodes the velocity limit |q'(u)| <= v·t'(u) is linear in the durations, for every u, so
without the acceleration limit the least total time is a linear programme. It gives

- a lower bound: finitely many u are a relaxation, and any non-negative weights of its rows that
  add up to the objective prove a bound; they are made exact in rational numbers;
- a motion: the optimum, lengthened a little, is proved to keep both limits on the whole interval
  by Bernstein coefficients, again in rational numbers.

Where the acceleration limit bites, bound and motion come from `branch_and_bound` instead.
Both concern the problem as it stands in doubles.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from repro.errors import NotProvedError
from repro.robotics.bsplines import solve
from repro.robotics.proofs.branch_and_bound import just_obeying, least_total
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Bend, Cut, Exact, Rationals, cut, dot, exact
from repro.robotics.proofs.positivity import derivative, difference, positive, product
from repro.robotics.spline_motion import MinimumTimeSpline

Vector = NDArray[np.float64]
ROUNDS = 30  # of added cuts; the distance to the optimum falls with its square in every round
INFLATION = 1e-7  # share by which the optimum is lengthened
DECIMALS = 10**9  # durations of the proved motion are whole nanoseconds


@dataclass(frozen=True, slots=True, kw_only=True)
class SplineProof:
    """A proved lower bound, a motion proved to obey, and what holds it back, in s.

    `holding` are limits that the motion meets: they hold the bound up. `acceleration_share` is the
    greatest share of an acceleration limit that the motion reaches; `boxes` is how many boxes of
    durations the bound took, none where the velocity limits alone give it.
    """

    lower_bound: Fraction
    durations: Rationals
    holding: tuple[Cut | Bend, ...]
    acceleration_share: float
    boxes: int

    @property
    def attained(self) -> Fraction:
        """Total time of the motion."""
        return sum(self.durations, Fraction(0))


@cache
def prove(problem: MinimumTimeSpline) -> SplineProof:
    """Return the proof for one problem; NotProvedError where no motion can be proved to obey."""
    model = exact(problem)
    cuts, optimum, marginals = _optimum(problem, model)
    lower, held = _bound(cuts, marginals)
    holding: tuple[Cut | Bend, ...] = held
    motion, boxes = just_obeying(problem, optimum), 0
    if not np.isfinite(motion).all():
        message = "time stands still at the optimum of the linear programme: no joint moves there"
        raise NotProvedError(message)
    if motion.sum() > optimum.sum() * (1.0 + INFLATION):
        bound = least_total(problem, Limits(model, cuts), motion)
        lower, boxes = max(lower, bound.lower), bound.boxes
        motion, holding = bound.motion, bound.holding
    durations = tuple(
        Fraction(math.ceil(h * DECIMALS), DECIMALS) for h in motion * (1.0 + INFLATION)
    )
    if not _obeys(model, durations):
        message = f"no proof that {[float(h) for h in durations]} s keeps every limit"
        raise NotProvedError(message)
    share = problem.peak_shares(np.array(durations, dtype=np.float64))[1]
    return SplineProof(
        lower_bound=lower,
        durations=durations,
        holding=holding,
        acceleration_share=float(share),
        boxes=boxes,
    )


def _optimum(problem: MinimumTimeSpline, model: Exact) -> tuple[list[Cut], Vector, Vector]:
    """Return cuts, and optimum and dual weights of the linear programme that they make."""
    places = list(itertools.product(range(problem.segments), range(len(problem.velocity))))
    cuts = [cut(model, *place, Fraction(k, 4)) for place in places for k in range(5)]
    for _ in range(ROUNDS):
        rows = np.array([cut.weights for cut in cuts], dtype=np.float64)
        least = np.array([cut.least for cut in cuts], dtype=np.float64)
        found = linprog(
            np.ones(problem.segments), A_ub=-rows, b_ub=-least, bounds=(None, None), method="highs"
        )
        if found.status:
            message = f"the linear programme of the durations has no optimum: {found.message}"
            raise NotProvedError(message)
        worst = [_worst(model, place, found.x) for place in places]
        known = {(cut.span, cut.joint, cut.u) for cut in cuts}
        fresh = [place for place, excess in worst if excess > 1e-12 and place not in known]
        if not fresh:
            break
        cuts += [cut(model, *place) for place in fresh]
    return cuts, found.x, -found.ineqlin.marginals


def _worst(
    model: Exact, place: tuple[int, int], durations: Vector
) -> tuple[tuple[int, int, Fraction], float]:
    """Return where on the span |q'| exceeds v·t' most, and by how much."""
    span, joint = place
    slope = np.array(model.time[span], dtype=np.float64) @ durations
    angle = np.array(model.angle[span][joint], dtype=np.float64) / float(model.velocity[joint])
    best = ((span, joint, Fraction(0)), -math.inf)
    for c0, c1, c2 in (angle - slope, -angle - slope):
        turn = -c1 / (2.0 * c2) if c2 < 0.0 else 0.0
        for u in (0.0, min(max(turn, 0.0), 1.0), 1.0):
            excess = c0 + u * (c1 + u * c2)
            if excess > best[1]:
                best = ((span, joint, Fraction(u)), excess)
    return best


def _bound(cuts: Sequence[Cut], marginals: Vector) -> tuple[Fraction, tuple[Cut, ...]]:
    """Return an exact lower bound and the cuts that prove it.

    Weights y >= 0 with yᵀG = 1 give: total = 1ᵀh = yᵀGh >= yᵀg for every h that obeys.
    """
    n = len(cuts[0].weights)
    holding: list[Cut] = []
    for i in np.argsort(-marginals, kind="stable"):
        # a node belongs to two spans, so the same row may stand there twice
        rows = np.array([cut.weights for cut in (*holding, cuts[i])], dtype=np.float64)
        if np.linalg.matrix_rank(rows) == len(rows):
            holding.append(cuts[i])
        if len(holding) == n:
            break
    transposed = [list(column) for column in zip(*(cut.weights for cut in holding), strict=True)]
    weights = [row[0] for row in solve(transposed, [[Fraction(1)]] * n)]
    if min(weights) < 0:
        message = "the dual of the linear programme is degenerate: its weights are not exact"
        raise NotProvedError(message)
    bound = dot(weights, [cut.least for cut in holding])
    return bound, tuple(cut for cut, weight in zip(holding, weights, strict=True) if weight)


def _obeys(model: Exact, durations: Rationals) -> bool:
    """Prove that time never stands still and that every limit is kept on every span."""
    for span, matrix in enumerate(model.time):
        slope = [dot(row, durations) for row in matrix]
        cube = product(slope, product(slope, slope))
        if not positive(slope):
            return False
        for joint, angle in enumerate(model.angle[span]):
            bend = difference(product(derivative(angle), slope), product(angle, derivative(slope)))
            for curve, allowed, limit in (
                (list(angle), slope, model.velocity[joint]),
                (bend, cube, model.acceleration[joint]),
            ):
                room = [limit * entry for entry in allowed]
                below = difference(room, curve)
                above = difference(room, [-entry for entry in curve])
                if not (positive(below) and positive(above)):
                    return False
    return True
