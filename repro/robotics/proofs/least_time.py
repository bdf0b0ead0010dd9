"""The proved least time of a motion: by closed form, linear programme, branch and bound."""

import math
from collections.abc import Sequence
from dataclasses import replace

from repro.errors import NotProvedError
from repro.robotics.directed_spline import Spline, jerk_of, sides
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import Cheapest, cheapest
from repro.robotics.path_fitting import PathFitting
from repro.robotics.proofs.jolts import Limit
from repro.robotics.proofs.limit_rows import Bend, Cut
from repro.robotics.proofs.proved import FREE, LeastTime, box_in_words, closed, gap
from repro.robotics.proofs.rest_to_rest_minimum import PER, rest_to_rest
from repro.robotics.proofs.spline_minimum import SplineProof, prove, prove_within
from repro.robotics.proofs.watch import Watch
from repro.robotics.rest_to_rest import MinimumTime

AT_AN_END = 1e-6  # share of a duration allowed by which the motion's is longer for its proof
LINEAR_PROGRAMME = (
    "linear programme: the velocity limits are linear in the durations, a rational combination of "
    "them bounds the sum from below, and a motion, lengthened a little, is proved to keep "
    "every limit by Bernstein coefficients in rational numbers; u goes from 0 to 1 in each segment"
)
BRANCH_AND_BOUND = (
    "branch and bound over the durations: the velocity limits are linear in them, {others}; "
    "a rational combination of {all} bounds the sum in {boxes} from below, and a motion, "
    "lengthened a little, is proved to keep every limit by Bernstein coefficients in rational "
    "numbers; u goes from 0 to 1 in each segment"
)
CUBIC = "the acceleration limits cubic with a chord as their linear bound in a box"
TO_THE_FIFTH = (
    f"{CUBIC}, those of the jerk, divided by dt/du, have a chord of its fourth power, and a chord "
    "or tangents of (d²t/du²)²/(dt/du)"
)


def least_time(
    problem: MinimumTime | Spline,
    watch: Watch | None = None,
    *,
    units: Sequence[str] | None = None,
) -> LeastTime:
    """Return the least time of every motion that obeys, as far as it can be proved.

    With a watch, as far as it can be proved until that is over. `units` of the joints stand in its
    words, rad where none are given.
    """
    units = ("rad",) * len(problem.velocity) if units is None else units
    if not isinstance(problem, MinimumTime):
        return _spline(problem, watch, units)
    if problem.handling == "fixed penalties":
        least = cheapest(problem)
        if least.broken:
            return _better_off_breaking(problem, least)
    return rest_to_rest(problem, units)


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
        box=problem.durations,
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


def _spline(problem: Spline, watch: Watch | None, units: Sequence[str]) -> LeastTime:
    try:
        proof = prove(problem) if watch is None else prove_within(problem, watch)
    except NotProvedError as error:
        return LeastTime(
            minimum=None,
            lower_bound=None,
            attained=None,
            method=LINEAR_PROGRAMME,
            at=(),
            binding=(),
            box=problem.durations,
            explanation=str(error),
        )
    # the double below, so that rounding cannot lift the bound
    finite = math.isfinite(proof.lower_bound)
    lower = math.nextafter(float(proof.lower_bound), 0.0) if finite else None
    attained = math.fsum(map(float, proof.durations)) if proof.durations else None
    return LeastTime(
        minimum=closed(lower, attained),
        lower_bound=lower,
        attained=attained,
        method=_method(problem, proof.boxes),
        at=tuple(map(float, proof.durations)),
        binding=(*_at_the_ends(problem, proof), *_holding(problem, proof, units)),
        box=problem.durations,
        explanation=_explanation(problem, proof, lower, attained)
        + ("" if lower is not None else _whatever(problem, watch)),
    )


def _whatever(problem: Spline, watch: Watch | None) -> str:
    """Return what a motion takes where no durations allowed obey, as far as it is found."""
    if problem.durations == FREE:
        return ""
    free = replace(problem, durations=FREE)
    try:
        proof = prove(free) if watch is None else prove_within(free, watch)
    except NotProvedError:
        return ""
    if not math.isfinite(proof.lower_bound):
        return ""
    lower = math.nextafter(float(proof.lower_bound), 0.0)
    found = f" Whatever the durations, a motion that obeys takes {lower:.6g} s or more"
    if proof.durations:
        found += f"; with {' + '.join(f'{float(each):.6g}' for each in proof.durations)} s one does"
    return f"{found}."


def _explanation(
    problem: Spline, proof: SplineProof, lower: float | None, attained: float | None
) -> str:
    if lower is None:
        box = box_in_words(problem.durations) or f" up to {FREE[1]:g} s"
        return f"No durations{box} obey{_by_boxes(proof.boxes)}."
    by_boxes = _by_boxes(proof.boxes, " of durations")
    if attained is None:
        among = box_in_words(problem.durations, " with durations ")
        least = f"one would take {lower:.6g} s or more{by_boxes}"
        return f"No motion{among} was found that obeys; {least}."
    share = f"{100 * proof.acceleration_share:.3g} % of its limit"
    jerk = None if proof.jerk_share is None else f"jerk {100 * proof.jerk_share:.3g} % of its own"
    also = f", a {jerk}" if jerk else ""
    if closed(lower, attained) is None:
        return (
            f"The minimum lies between {lower:.6g} s{by_boxes}{',' if by_boxes else ''} "
            f"and {attained:.6g} s, the shortest motion found (an acceleration reaches "
            f"{share}{also}): "
            f"they are {100 * (gap(lower, attained) or 0.0):.2g} % apart."
        )
    if proof.boxes:
        return (
            f"The minimum lies between {lower:.8g} s and {attained:.8g} s. An acceleration reaches "
            f"{share}{also}; the velocity limits alone would allow less."
        )
    also = f" and no {jerk}" if jerk else ""
    return f"No acceleration exceeds {share}{also}, so these limits play no part in the minimum."


def _method(problem: Spline, boxes: int) -> str:
    if not boxes:
        return LINEAR_PROGRAMME
    jerky = jerk_of(problem) is not None
    return BRANCH_AND_BOUND.format(
        others=TO_THE_FIFTH if jerky else CUBIC,
        all="all" if jerky else "both",
        boxes="one box" if boxes == 1 else f"each of {boxes} boxes",
    )


def _by_boxes(boxes: int, of: str = "") -> str:
    """Return ", proved by 2 boxes", nothing where it took none."""
    return f", proved by {boxes} box{'' if boxes == 1 else 'es'}{of}" if boxes else ""


def _at_the_ends(problem: Spline, proof: SplineProof) -> tuple[str, ...]:
    """Return the segments that are as short or as long as is allowed."""
    shortest, longest = problem.durations
    return tuple(
        f"segment {k}: {name} duration allowed ({end:g} s)"
        for k, duration in enumerate(map(float, proof.durations), start=1)
        for name, end in (("shortest", shortest), ("longest", longest))
        if abs(duration - end) <= AT_AN_END * end
    )


def _holding(problem: Spline, proof: SplineProof, units: Sequence[str]) -> tuple[str, ...]:
    # u that differ by less than is shown are one place
    places = (
        f"segment {limit.span + 1}, at u = {float(limit.u):.3g}: {kind} of joint "
        f"{limit.joint + 1} (limit {_reached(pairs[limit.joint], limit.sign):g} "
        f"{units[limit.joint]}{PER[kind]})"
        for limit in sorted(proof.holding, key=lambda limit: (limit.span, limit.u))
        for kind in [_kind(limit)]
        for pairs in [sides(getattr(problem, kind))]
    )
    return tuple(dict.fromkeys(places))


def _kind(limit: Limit) -> str:
    if isinstance(limit, Cut):
        return "velocity"
    return "acceleration" if isinstance(limit, Bend) else "jerk"


def _reached(pair: Sequence[float], sign: int) -> float:
    """Return the limit in a direction, without a sign where both are alike."""
    low, high = pair
    return low if sign < 0 and low != -high else high
