"""SYJI-0035: the motions that the paper speaks of, under each reading of it."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from papers.syji.printed import (
    DURATIONS,
    END,
    PENALTIES,
    SECOND_DURATION,
    START,
    TABLE_3,
    TABLE_4,
    WHOLE,
)
from repro.robotics import MinimumTime, quintic, septic
from repro.robotics.piecewise import PiecewiseMotion, passing_through, resting_at

Vector = NDArray[np.float64]

# section 6R robot simulation: one polynomial from q1 to q2, velocity, acceleration and jerk zero
# at both ends
SEVENTH = MinimumTime(
    waypoints=tuple(tuple(angle.si for angle in place) for place in (START, END)),
    law=septic,  # Eqs. (1)-(3)
    velocity=TABLE_3.column("Maximum Velocity"),
    acceleration=TABLE_3.column("Maximum Acceleration"),
    jerk=TABLE_3.column("Maximum Jerk"),
    durations=(0.1, 10.0),
)
FIFTH = replace(SEVENTH, law=quintic)
ORDERS = {"7": SEVENTH, "5": FIFTH}

# The problem as printed: Eqs. (4)-(9)
PRINTED = replace(
    SEVENTH,
    waypoints=tuple(TABLE_4.column(name) for name in TABLE_4.column_names),
    durations=(0.1, WHOLE.si),
    handling="fixed penalties",
    penalties=(PENALTIES[0].si, PENALTIES[1].si, PENALTIES[2].si),
)
RESTING = replace(PRINTED, handling="feasibility first")

FOUND = (DURATIONS[0].si, SECOND_DURATION.si, DURATIONS[2].si, DURATIONS[3].si)

Motion = Callable[[], PiecewiseMotion]


def at_rest_everywhere() -> PiecewiseMotion:
    """Return the motion of the printed durations that rests at every position of Table 4."""
    return resting_at(PRINTED.waypoints, FOUND, law=septic)


def without_stopping() -> PiecewiseMotion:
    """Return the seventh-order spline through Table 4 at the printed times, at rest at the ends."""
    return passing_through(PRINTED.waypoints, FOUND, degree=septic.degree)


def in_one_piece() -> PiecewiseMotion:
    """Return the one polynomial from q1 to q2 in the sum of the printed durations."""
    return resting_at(SEVENTH.waypoints, (sum(FOUND),), law=septic)


def in_five_seconds() -> PiecewiseMotion:
    """Return the one polynomial from q1 to q2 before optimisation."""
    return resting_at(SEVENTH.waypoints, (WHOLE.si,), law=septic)


READINGS: dict[str, Motion] = {
    "at rest at each position of Table 4": at_rest_everywhere,
    "passing through the positions of Table 4 without a stop": without_stopping,
    "with one polynomial from start to end": in_one_piece,
}


def share_of_limit(motion: Motion, derivative: int) -> float:
    """Return the largest share of its limit that any joint uses, in percent."""
    return float(100 * (motion().peaks(derivative) / PRINTED.limits[derivative - 1]).max())


def least_share_of_speed() -> float:
    """Return the largest average speed of a joint in a segment, in percent of its limit.

    Whatever the curve, a joint is somewhere as fast as it is on average.
    """
    averages = PRINTED.distances / np.array(FOUND)[:, None]
    return float(100 * (averages / PRINTED.limits[0]).max())


def reversals(motion: Motion) -> float:
    """Return how often a joint turns back, of the joint that does so most."""
    return float(motion().reversals())
