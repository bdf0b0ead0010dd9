"""Where a fixed price for breaking limits leads: the proved least cost, and what it breaks.

A motion that keeps some kinds of limit takes in each segment at least the longest of the times
that keep them, and pays no more than the price of the other kinds. The cheapest of the eight
choices of what to keep is therefore the least cost, and its durations attain it.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError
from repro.robotics.rest_to_rest import DERIVATIVES, MinimumTime

Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Cheapest:
    """The least cost in s, the durations that attain it, and the kinds of limit that they break."""

    cost: float
    durations: Vector
    broken: tuple[str, ...]

    @property
    def time(self) -> float:
        """Time of the motion itself, in s."""
        return float(self.durations.sum())


def cheapest(problem: MinimumTime, *, shortest: float | None = None) -> Cheapest:
    """Return the proved minimum of a cost with fixed penalties over the durations allowed.

    `shortest` takes the place of the shortest duration allowed: with 0 they may be as short as one
    likes. Raises InputError for a problem whose limits are handled in another way.
    """
    if problem.handling != "fixed penalties":
        message = f"limits are handled by {problem.handling!r}, not by fixed penalties"
        raise InputError(message)
    longest = problem.durations[1]
    shortest = problem.durations[0] if shortest is None else shortest
    needed = problem.times_to_keep().max(axis=2)
    choices = []
    for kept in product((False, True), repeat=3):
        times = np.maximum(shortest, needed[:, kept].max(axis=1, initial=0.0))
        price = sum(p for p, keep in zip(problem.penalties, kept, strict=True) if not keep)
        if (times <= longest).all():
            choices.append((float(times.sum()) + price, times))
    cost, durations = min(choices, key=lambda choice: choice[0])
    over = (needed > durations[:, None]).any(axis=0)
    broken = tuple(kind for m, kind in DERIVATIVES.items() if over[m - 1])
    return Cheapest(cost=cost, durations=durations, broken=broken)
