"""Proved minimum time of a motion that rests at every waypoint, in closed form."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from repro.robotics.proofs.proved import LeastTime, closed
from repro.robotics.rest_to_rest import DERIVATIVES, MARGIN, MinimumTime

Vector = NDArray[np.float64]
PER = {"velocity": "/s", "acceleration": "/s²", "jerk": "/s³"}
METHOD = (
    "closed form: in each segment a joint that moves D in time T peaks at f·D/T^m, so T is at "
    "least (f·D/limit)^(1/m) for every joint and limit, and the greatest of these obeys"
)


def rest_to_rest(problem: MinimumTime, units: Sequence[str]) -> LeastTime:
    """Return the least time of every motion that obeys and whose durations are allowed."""
    shortest, longest = problem.durations
    times = problem.times_to_keep()
    needed = times.max(axis=(1, 2))
    # at most this much shorter without the margin; see there
    exact = needed * (1.0 - 3.0 * MARGIN)
    if (exact > longest).any():
        return _nothing_obeys(problem, times, math.nextafter(math.fsum(exact), 0.0), units)
    lower = math.nextafter(math.fsum(np.maximum(exact, shortest)), 0.0)
    at = np.clip(needed, shortest, longest)
    obeys = problem.obeys(at)
    attained = float(at.sum()) if obeys else None
    return LeastTime(
        minimum=closed(lower, attained),
        lower_bound=lower,
        attained=attained,
        method=METHOD,
        at=tuple(at.tolist()) if obeys else (),
        binding=tuple(
            f"segment {k}: {_binding(problem, each, units)}"
            for k, each in enumerate(times, start=1)
        ),
        box=problem.durations,
    )


def _nothing_obeys(
    problem: MinimumTime, times: Vector, lower: float, units: Sequence[str]
) -> LeastTime:
    low, longest = problem.durations
    over = [
        f"segment {k} takes {each.max():.6g} s or more ({_limit(problem, each, units)})"
        for k, each in enumerate(times, start=1)
        if each.max() > longest
    ]
    return LeastTime(
        minimum=None,
        lower_bound=lower,
        attained=None,
        method=METHOD,
        at=(),
        binding=(),
        box=problem.durations,
        explanation=(
            f"No durations from {low:g} to {longest:g} s obey: {'; '.join(over)}. Whatever the "
            f"durations, a motion that obeys takes {lower:.6g} s or more."
        ),
    )


def _binding(problem: MinimumTime, times: Vector, units: Sequence[str]) -> str:
    """Return what holds a segment back, whose least times per derivative and joint are given."""
    if times.max() < problem.durations[0]:
        return f"shortest duration allowed ({problem.durations[0]:g} s)"
    return _limit(problem, times, units)


def _limit(problem: MinimumTime, times: Vector, units: Sequence[str]) -> str:
    derivative, joint = map(int, np.unravel_index(np.argmax(times), times.shape))
    kind = DERIVATIVES[derivative + 1]
    limit = getattr(problem, kind)[joint]
    return f"{kind} of joint {joint + 1} (limit {limit:g} {units[joint]}{PER[kind]})"
