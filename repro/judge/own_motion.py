"""The certificate of a motion of a user's own, and what its limits cost."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from repro.errors import InputError, NotProvedError
from repro.judge.certificates import Certificate
from repro.judge.outside_planners import OutsideReference
from repro.robotics.chain import Chain
from repro.robotics.directed_spline import Spline
from repro.robotics.motion_checks import LARGEST, Rows
from repro.robotics.own_motion import OwnMotion, joints_of
from repro.robotics.polynomial_motion import KINDS, PolynomialMotion
from repro.robotics.proofs.least_time import least_time
from repro.robotics.proofs.polynomial_minimum import polynomial_minimum
from repro.robotics.proofs.proved import LeastTime
from repro.robotics.proofs.spline_minimum import fastest_found
from repro.robotics.proofs.watch import Watch
from repro.robotics.spline_range import leaving

FREE = 1e12  # times a limit: so high that it plays no part
LEAST_LOSS = 1e-6  # share of the motion's time: less is rounding, or the search for a motion


@dataclass(frozen=True, slots=True, kw_only=True)
class Loss:
    """How much sooner, in s, a motion would end if one limit were not there."""

    limit: str
    seconds: float


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnResult:
    """A motion, what is proved of it, what its limits cost, and what other planners say.

    `units` has one per joint (deg, rad or m), `si` what one of it is in rad or m; `limits` have a
    (lowest, highest) per joint, by kind.
    """

    title: str
    problem: OwnMotion
    units: tuple[str, ...]
    si: tuple[float, ...]
    names: tuple[str, ...]
    limits: Mapping[str, Rows]
    chain: Chain | None
    certificate: Certificate
    losses: tuple[Loss, ...]
    beside: tuple[OutsideReference, ...]


def certified(
    problem: OwnMotion, watch: Watch, *, title: str = "", units: tuple[str, ...] | None = None
) -> Certificate:
    """Return the certificate of a problem, as far as it can be proved until the watch is over.

    `units` of the joints stand in its words, rad where none are given.
    """
    if not isinstance(problem, OwnMotion):
        message = (
            f"{type(problem).__name__} is no motion that can be certified; those are "
            "MinimumTime, MinimumTimeSpline, DirectedSpline and PolynomialMotion"
        )
        raise InputError(message)
    least = _least(problem, watch, units or ("rad",) * joints_of(problem))
    return Certificate(paper="", problem=title, printed=(), gap=least.gap, **asdict(least))


def _least(problem: OwnMotion, watch: Watch, units: tuple[str, ...]) -> LeastTime:
    if isinstance(problem, PolynomialMotion):
        return polynomial_minimum(problem, units, watch)
    return least_time(problem, watch, units=units)


def outside_range(
    problem: OwnMotion, ranges: Rows | None, units: tuple[str, ...], *, title: str
) -> Certificate | None:
    """Return the certificate that no durations keep a spline in the ranges; None where they do."""
    if ranges is None or not isinstance(problem, Spline):
        return None
    found = leaving(problem, ranges)
    if found is None:
        return None
    segment, joint, value = found
    low, high = ranges[joint]
    return Certificate(
        paper="",
        problem=title,
        minimum=None,
        lower_bound=None,
        attained=None,
        method="the path of a spline depends on its waypoints alone; it turns where its slope is 0",
        at=(),
        binding=(f"segment {segment + 1}: range of joint {joint + 1}",),
        printed=(),
        box=problem.durations,
        explanation=(
            f"No durations obey: in segment {segment + 1} the path takes joint {joint + 1} to "
            f"{value:.6g} {units[joint]}, outside its range from {low:g} to {high:g}."
        ),
    )


def losses(problem: OwnMotion, found: Certificate, watch: Watch) -> tuple[Loss, ...]:
    """Return what each limit costs by itself, the dearest first.

    Of a spline it is what a motion that was found without the limit gains, which is not proved to
    be the fastest.
    """
    if found.attained is None:
        return ()
    known = []
    for m, joint in np.ndindex(3, joints_of(problem)):
        if watch.over:
            break
        kind = KINDS[m + 1]
        if getattr(problem, kind, None) is None or not _binds(found, kind, joint):
            continue
        time = _time_without(problem, kind, joint, watch)
        loss = found.attained - time if time is not None else 0.0
        if loss > LEAST_LOSS * found.attained:
            known.append(Loss(limit=f"{kind} of joint {joint + 1}", seconds=loss))
    return tuple(sorted(known, key=lambda each: -each.seconds))


def _binds(found: Certificate, kind: str, joint: int) -> bool:
    return any(f"{kind} of joint {joint + 1} " in text for text in found.binding)


def _time_without(problem: OwnMotion, kind: str, joint: int, watch: Watch) -> float | None:
    limits = list(getattr(problem, kind))
    limits[joint] = np.clip(np.array(limits[joint]) * FREE, -LARGEST, LARGEST)
    freed: dict[str, Any] = {kind: limits}
    without: OwnMotion = replace(problem, **freed)
    if not isinstance(without, Spline):
        return _least(without, watch, ("",) * joints_of(problem)).attained
    try:
        return fastest_found(without, watch)
    except NotProvedError:
        return None
