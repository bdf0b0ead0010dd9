"""Proved minimum time of a motion whose time and angle are B-splines.

For given nodes the velocity limit |q'(u)| <= v·t'(u) is linear in the durations, for every u, so
without the acceleration limit the least total time is a linear programme. It gives

- a lower bound: finitely many u are a relaxation, and any non-negative weights of its rows that
  add up to the objective prove a bound; they are made exact in rational numbers;
- a motion: the optimum, lengthened a little, is proved to keep both limits on the whole interval
  by Bernstein coefficients, again in rational numbers.

Both concern the problem as it stands in doubles. Where the acceleration limit bites, a motion is
sought that keeps it too, and a gap between the two numbers remains.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog, minimize

from repro.compiled import COST, ready
from repro.errors import ReproError
from repro.positivity import derivative, difference, positive, product
from repro.robotics.bsplines import Matrix, solve, span_weights
from repro.robotics.spline_motion import MinimumTimeSpline, slope_weights

Vector = NDArray[np.float64]
Rationals = tuple[Fraction, ...]
ROUNDS = 30  # of added cuts; the distance to the optimum falls with its square in every round
INFLATION = 1e-7  # share by which the optimum is lengthened
DECIMALS = 10**9  # durations of the proved motion are whole nanoseconds


class NotProvedError(ReproError):
    """The motion that should obey could not be proved to."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cut:
    """A velocity limit at one u of a span, as the row `weights` · durations >= `least`."""

    span: int
    joint: int
    u: Fraction
    weights: Rationals
    least: Fraction


@dataclass(frozen=True, slots=True, kw_only=True)
class SplineProof:
    """A proved lower bound, a motion proved to obey, and the cuts that hold the bound up, in s.

    `acceleration_share` is the greatest share of an acceleration limit that the motion reaches.
    """

    lower_bound: Fraction
    durations: Rationals
    cuts: tuple[Cut, ...]
    acceleration_share: float

    @property
    def attained(self) -> Fraction:
        """Total time of the motion."""
        return sum(self.durations, Fraction(0))


@cache
def prove(problem: MinimumTimeSpline) -> SplineProof:
    """Return the proof for one problem; NotProvedError where no motion can be proved to obey."""
    exact = _exact(problem)
    cuts, optimum, marginals = _optimum(problem, exact)
    lower, holding = _bound(cuts, marginals)
    slowed = _just_obeying(problem, optimum) * (1.0 + INFLATION)
    if not np.isfinite(slowed).all():
        message = "time stands still at the optimum of the linear programme: no joint moves there"
        raise NotProvedError(message)
    durations = tuple(Fraction(math.ceil(h * DECIMALS), DECIMALS) for h in slowed)
    if not _obeys(exact, durations):
        message = f"no proof that {[float(h) for h in durations]} s keeps every limit"
        raise NotProvedError(message)
    share = problem.peak_shares(np.array(durations, dtype=np.float64))[1]
    return SplineProof(
        lower_bound=lower, durations=durations, cuts=holding, acceleration_share=float(share)
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _Exact:
    """dt/du as matrices, dq/du as coefficients per span and joint, and the limits, all exact."""

    time: tuple[Matrix, ...]
    angle: tuple[tuple[Rationals, ...], ...]
    velocity: Rationals
    acceleration: Rationals


def _exact(problem: MinimumTimeSpline) -> _Exact:
    columns = list(zip(*problem.nodes, strict=True))
    joints = [[Fraction(angle) for angle in column] for column in columns]
    return _Exact(
        time=slope_weights(problem.segments, problem.time_ends),
        angle=tuple(
            tuple(tuple((k + 1) * _dot(matrix[k + 1], nodes) for k in range(3)) for nodes in joints)
            for matrix in span_weights(len(problem.nodes), problem.ends)
        ),
        velocity=tuple(map(Fraction, problem.velocity)),
        acceleration=tuple(map(Fraction, problem.acceleration)),
    )


def _dot(first: Sequence[Fraction], second: Sequence[Fraction]) -> Fraction:
    return sum((a * b for a, b in zip(first, second, strict=True)), Fraction(0))


def _cut(exact: _Exact, span: int, joint: int, u: Fraction) -> Cut:
    powers = (Fraction(1), u, u * u)
    columns = zip(*exact.time[span], strict=True)
    speed = abs(_dot(exact.angle[span][joint], powers))
    return Cut(
        span=span,
        joint=joint,
        u=u,
        weights=tuple(_dot(column, powers) for column in columns),
        least=speed / exact.velocity[joint],
    )


def _optimum(problem: MinimumTimeSpline, exact: _Exact) -> tuple[list[Cut], Vector, Vector]:
    """Return cuts, and optimum and dual weights of the linear programme that they make."""
    places = list(itertools.product(range(problem.segments), range(len(problem.velocity))))
    cuts = [_cut(exact, *place, Fraction(k, 4)) for place in places for k in range(5)]
    for _ in range(ROUNDS):
        rows = np.array([cut.weights for cut in cuts], dtype=np.float64)
        least = np.array([cut.least for cut in cuts], dtype=np.float64)
        found = linprog(
            np.ones(problem.segments), A_ub=-rows, b_ub=-least, bounds=(None, None), method="highs"
        )
        if found.status:
            message = f"the linear programme of the durations has no optimum: {found.message}"
            raise NotProvedError(message)
        worst = [_worst(exact, place, found.x) for place in places]
        known = {(cut.span, cut.joint, cut.u) for cut in cuts}
        fresh = [place for place, excess in worst if excess > 1e-12 and place not in known]
        if not fresh:
            break
        cuts += [_cut(exact, *place) for place in fresh]
    return cuts, found.x, -found.ineqlin.marginals


def _worst(
    exact: _Exact, place: tuple[int, int], durations: Vector
) -> tuple[tuple[int, int, Fraction], float]:
    """Return where on the span |q'| exceeds v·t' most, and by how much."""
    span, joint = place
    slope = np.array(exact.time[span], dtype=np.float64) @ durations
    angle = np.array(exact.angle[span][joint], dtype=np.float64) / float(exact.velocity[joint])
    best = ((span, joint, Fraction(0)), -math.inf)
    for c0, c1, c2 in (angle - slope, -angle - slope):
        turn = -c1 / (2.0 * c2) if c2 < 0.0 else 0.0
        for u in (0.0, min(max(turn, 0.0), 1.0), 1.0):
            excess = c0 + u * (c1 + u * c2)
            if excess > best[1]:
                best = ((span, joint, Fraction(u)), excess)
    return best


def _just_obeying(problem: MinimumTimeSpline, optimum: Vector) -> Vector:
    """Return a short motion that keeps both limits in doubles, near the optimum of the first."""
    scaled = replace(problem, handling="time scaling")
    if not np.isfinite(scaled.peak_shares(optimum)).all():
        return np.full_like(optimum, np.inf)
    if scaled.peak_shares(optimum)[1] > 1.0:
        cost, data = ready(scaled.kernel, COST), scaled.data
        options = {"xatol": 1e-7, "fatol": 1e-9, "maxfev": 20000}
        optimum = minimize(cost, optimum, (data,), method="Nelder-Mead", options=options).x
    return scaled.obeying(optimum)


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
    bound = _dot(weights, [cut.least for cut in holding])
    return bound, tuple(cut for cut, weight in zip(holding, weights, strict=True) if weight)


def _obeys(exact: _Exact, durations: Rationals) -> bool:
    """Prove that time never stands still and that every limit is kept on every span."""
    for span, matrix in enumerate(exact.time):
        slope = [_dot(row, durations) for row in matrix]
        cube = product(slope, product(slope, slope))
        if not positive(slope):
            return False
        for joint, angle in enumerate(exact.angle[span]):
            bend = difference(product(derivative(angle), slope), product(angle, derivative(slope)))
            for curve, allowed, limit in (
                (list(angle), slope, exact.velocity[joint]),
                (bend, cube, exact.acceleration[joint]),
            ):
                room = [limit * entry for entry in allowed]
                below = difference(room, curve)
                above = difference(room, [-entry for entry in curve])
                if not (positive(below) and positive(above)):
                    return False
    return True
