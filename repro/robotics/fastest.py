"""The least time of any motion from rest to rest under limits, whatever its curve.

Jerk, acceleration and velocity in turn at their limits: the double-S profile (L. Biagiotti,
C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, Springer 2008, section 3.4).
"""

import math

from repro.robotics.rest_to_rest import MinimumTime


def fastest(
    distance: float, *, velocity: float, acceleration: float, jerk: float = math.inf
) -> float:
    """Return the least time in s in which one joint can move `distance`, at rest at both ends.

    At rest means without velocity and, where jerk is limited, without acceleration. Units agree:
    rad, rad/s, rad/s², rad/s³; acceleration is finite.
    """
    top = velocity
    if distance < velocity * _speeding_up(velocity, acceleration, jerk):
        lag = acceleration / jerk
        top = acceleration / 2 * (math.sqrt(lag**2 + 4 * distance / acceleration) - lag)
        if top * jerk < acceleration**2:  # the acceleration limit is not reached either
            top = (distance**2 * jerk / 4) ** (1 / 3)
    if top == 0:
        return 0.0
    # speeding up and slowing down cover top · (time of one of them); the rest is done at top speed
    return distance / top + _speeding_up(top, acceleration, jerk)


def _speeding_up(top: float, acceleration: float, jerk: float) -> float:
    """Return the time from rest to a top speed."""
    if top * jerk >= acceleration**2:
        return top / acceleration + acceleration / jerk
    return 2 * math.sqrt(top / jerk)


def fastest_joints(problem: MinimumTime) -> tuple[float, ...]:
    """Return each joint's least time in s from the first waypoint to the last, whatever its curve.

    The greatest is a lower bound on every motion that obeys and is at rest at both ends, whether
    or not it stops between them.
    """
    first, last = problem.waypoints[0], problem.waypoints[-1]
    velocity, acceleration, jerk = problem.limits.tolist()
    return tuple(
        fastest(abs(end - start), velocity=v, acceleration=a, jerk=j)
        for start, end, v, a, j in zip(first, last, velocity, acceleration, jerk, strict=True)
    )
