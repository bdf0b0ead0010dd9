"""Proved minimum time of a motion that rests at every waypoint, in closed form."""

import math
from collections.abc import Sequence

import numpy as np

from repro.robotics.proofs.proved import LeastTime, closed
from repro.robotics.rest_to_rest import DERIVATIVES, MARGIN, MinimumTime

PER = {"velocity": "/s", "acceleration": "/s²", "jerk": "/s³"}
METHOD = (
    "closed form: in each segment a joint that moves D in time T peaks at f·D/T^m, so T is at "
    "least (f·D/limit)^(1/m) for every joint and limit, and the greatest of these obeys"
)


def rest_to_rest(problem: MinimumTime, units: Sequence[str]) -> LeastTime:
    """Return the least time of every motion that obeys and whose durations are allowed."""
    shortest, longest = problem.durations
    needed = problem.shortest()
    # at most this much shorter without the margin; see there
    exact = np.maximum(needed * (1.0 - 3.0 * MARGIN), shortest)
    lower = math.nextafter(math.fsum(exact), 0.0)
    if (exact > longest).any():
        return _nothing_obeys(problem, lower, units)
    at = np.clip(needed, shortest, longest)
    obeys = problem.obeys(at)
    attained = float(at.sum()) if obeys else None
    return LeastTime(
        minimum=closed(lower, attained),
        lower_bound=lower,
        attained=attained,
        method=METHOD,
        at=tuple(at.tolist()) if obeys else (),
        binding=tuple(_binding(problem, k, units) for k in range(problem.segments)),
        box=problem.durations,
    )


def _nothing_obeys(problem: MinimumTime, lower: float, units: Sequence[str]) -> LeastTime:
    low, longest = problem.durations
    over = [
        f"segment {k + 1} takes {time:.6g} s or more ({_limit(problem, k, units)})"
        for k, time in enumerate(problem.shortest())
        if time > longest
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


def _binding(problem: MinimumTime, segment: int, units: Sequence[str]) -> str:
    if problem.times_to_keep()[segment].max() < problem.durations[0]:
        return f"segment {segment + 1}: shortest duration allowed ({problem.durations[0]:g} s)"
    return f"segment {segment + 1}: {_limit(problem, segment, units)}"


def _limit(problem: MinimumTime, segment: int, units: Sequence[str]) -> str:
    times = problem.times_to_keep()[segment]
    derivative, joint = map(int, np.unravel_index(np.argmax(times), times.shape))
    kind = DERIVATIVES[derivative + 1]
    limit = problem.limits[derivative, joint]
    return f"{kind} of joint {joint + 1} (limit {limit:g} {units[joint]}{PER[kind]})"
