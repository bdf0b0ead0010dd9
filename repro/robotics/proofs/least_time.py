"""The proved least time of a motion: by closed form, linear programme, branch and bound."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from repro.errors import NotProvedError
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import Cheapest, cheapest
from repro.robotics.path_fitting import PathFitting
from repro.robotics.proofs.limit_rows import Cut
from repro.robotics.proofs.spline_minimum import SplineProof, prove
from repro.robotics.rest_to_rest import DERIVATIVES, MinimumTime
from repro.robotics.spline_motion import MinimumTimeSpline

GAP = 1e-4  # s: closer than this, a bound and a motion count as one minimum
SI = {"velocity": "rad/s", "acceleration": "rad/s²", "jerk": "rad/s³"}
LINEAR_PROGRAMME = (
    "linear programme: the velocity limits are linear in the durations, a rational combination of "
    "them bounds the sum from below, and a motion lengthened by 1e-7 of its time is proved to keep "
    "every limit by Bernstein coefficients in rational numbers; u runs from 0 to 1 in each segment"
)
BRANCH_AND_BOUND = (
    "branch and bound over the durations: the velocity limits are linear in them, the acceleration "
    "limits cubic with a chord as their linear bound in a box; a rational combination of both "
    "bounds the sum in each of {boxes} boxes from below, and a motion lengthened by 1e-7 of its "
    "time is proved to keep every limit by Bernstein coefficients in rational numbers; u runs from "
    "0 to 1 in each segment"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class LeastTime:
    """The proved minimum time of one problem, in s.

    `lower_bound` is proved, `attained` is the time of a motion checked to obey; `at` are its
    durations; `binding` names the joint and limit that hold each segment back. Where a search is
    better off breaking limits there is no `minimum`; `lower_bound` then holds for every motion
    that obeys, `at` is where the search is led, and `explanation` says why.
    """

    minimum: float | None
    lower_bound: float | None
    attained: float | None
    method: str
    at: tuple[float, ...]
    binding: tuple[str, ...]
    explanation: str = ""


def least_time(problem: MinimumTime | MinimumTimeSpline) -> LeastTime:
    """Return the least time of every motion that obeys, as far as it can be proved."""
    if isinstance(problem, MinimumTimeSpline):
        return _spline(problem)
    if problem.handling == "fixed penalties":
        least = cheapest(problem)
        if least.broken:
            return _better_off_breaking(problem, least)
    return _rest_to_rest(problem)


def least_norms(fits: Sequence[PathFitting]) -> LeastTime:
    """Return what is proved of path fits, which minimise no time: it only explains."""
    least = [fit.least_cost() for fit in fits]
    inside = sum(fit.allows(fit.nearest()) for fit in fits)
    found = " to ".join(sorted({f"{value:.4g}" for value in (min(least), max(least))}))
    return LeastTime(
        minimum=None,
        lower_bound=None,
        attained=None,
        method="linear least squares: the norm is convex, and least where its gradient vanishes",
        at=(),
        binding=(),
        explanation=(
            f"Not a time but a norm in rad, of {len(fits)} fits by {len(fits[0].box)} coefficients "
            f"each. It is convex, so there is no local minimum but the global one: {found} rad, at "
            f"coefficients inside the bounds of the search in {inside} of {len(fits)}."
        ),
    )


def _better_off_breaking(problem: MinimumTime, least: Cheapest) -> LeastTime:
    joints = fastest_joints(problem)
    bound = max(joints)
    slowest = joints.index(bound) + 1
    obeying = float(problem.shortest().sum())
    limit = cheapest(problem, shortest=0.0)
    broken = ", ".join(least.broken)
    each = " + ".join(f"{duration:.4g}" for duration in least.durations)
    return LeastTime(
        minimum=None,
        lower_bound=bound,
        attained=obeying,
        method=(
            "a joint that starts and ends at rest, as fast as its limits on jerk, acceleration and "
            "velocity allow, moves its angle in the least time that any curve can"
        ),
        at=tuple(float(duration) for duration in least.durations),
        binding=(f"whole motion: joint {slowest}",),
        explanation=(
            f"The fitness as printed has its least value, {least.cost:.4g} s, where limits are "
            f"broken ({broken}): with {each} s the motion takes {least.time:.4g} s, and breaking "
            f"costs {least.cost - least.time:.4g} s. Obeying costs {obeying:.4g} s with this law "
            f"and at least {bound:.4g} s with any curve between rest and rest, even as fast "
            f"as the limits on jerk, acceleration and velocity allow (joint {slowest}). "
            f"The shorter the durations allowed, the lower: the fitness tends to "
            f"{limit.cost:.4g} s for a motion of {limit.time:.4g} s."
        ),
    )


def _rest_to_rest(problem: MinimumTime) -> LeastTime:
    at = problem.shortest()
    total = float(at.sum())
    return LeastTime(
        minimum=total,
        lower_bound=total,
        attained=total,
        method=(
            "closed form: in each segment a joint that moves D in time T peaks at f·D/T^m, so T is "
            "at least (f·D/limit)^(1/m) for every joint and limit, and the greatest of these obeys"
        ),
        at=tuple(float(t) for t in at),
        binding=tuple(_binding(problem, k) for k in range(problem.segments)),
    )


def _spline(problem: MinimumTimeSpline) -> LeastTime:
    try:
        proof = prove(problem)
    except NotProvedError as error:
        return LeastTime(
            minimum=None,
            lower_bound=None,
            attained=None,
            method=LINEAR_PROGRAMME,
            at=(),
            binding=(),
            explanation=str(error),
        )
    # the double below, so that rounding cannot lift the bound
    lower, attained = math.nextafter(float(proof.lower_bound), 0.0), float(proof.attained)
    minimum = attained if attained - lower <= GAP else None
    return LeastTime(
        minimum=minimum,
        lower_bound=lower,
        attained=attained,
        method=BRANCH_AND_BOUND.format(boxes=proof.boxes) if proof.boxes else LINEAR_PROGRAMME,
        at=tuple(map(float, proof.durations)),
        binding=_holding(problem, proof),
        explanation=_accelerations(proof, minimum),
    )


def _accelerations(proof: SplineProof, minimum: float | None) -> str:
    share = f"{100 * proof.acceleration_share:.3g} % of its limit"
    lower, attained = float(proof.lower_bound), float(proof.attained)
    if minimum is None:
        return (
            f"The minimum lies between {lower:.4f} s, proved by {proof.boxes} boxes of durations, "
            f"and {attained:.4f} s, the shortest motion found (it reaches {share})."
        )
    if proof.boxes:
        return (
            f"The minimum lies between {lower:.6f} s and {attained:.6f} s. An acceleration reaches "
            f"{share}; the velocity limits alone would allow less."
        )
    return f"No acceleration exceeds {share}, so these limits play no part in the minimum."


def _holding(problem: MinimumTimeSpline, proof: SplineProof) -> tuple[str, ...]:
    # u that differ by less than is shown are one place
    places = (
        f"segment {limit.span + 1}, at u = {float(limit.u):.3g}: {kind} of joint "
        f"{limit.joint + 1} (limit {limits[limit.joint]:g} {SI[kind]})"
        for limit in sorted(proof.holding, key=lambda limit: (limit.span, limit.u))
        for kind, limits in [
            ("velocity", problem.velocity)
            if isinstance(limit, Cut)
            else ("acceleration", problem.acceleration)
        ]
    )
    return tuple(dict.fromkeys(places))


def _binding(problem: MinimumTime, segment: int) -> str:
    times = problem.times_to_keep()[segment]
    derivative, joint = np.unravel_index(np.argmax(times), times.shape)
    kind = DERIVATIVES[int(derivative) + 1]
    limit = problem.limits[derivative, joint]
    return f"segment {segment + 1}: {kind} of joint {joint + 1} (limit {limit:g} {SI[kind]})"
