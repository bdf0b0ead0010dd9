"""What every motion problem must declare: finite waypoints, limits above 0, durations in order."""

import math
from collections.abc import Iterable, Sequence

from repro.errors import DeclarationError


def check_motion(
    points: Sequence[Sequence[float]],
    limits: Iterable[Sequence[float]],
    durations: tuple[float, float],
    *,
    called: str,
) -> None:
    """Raise DeclarationError for a motion that cannot be; `called` is what its points are called.

    All points and limits have one number per joint, and a segment takes time.
    """
    limits = tuple(limits)
    joints = {len(values) for values in (*points, *limits)}
    if len(joints) > 1 or len(points) < 2:
        message = f"{called} and limits disagree on the number of joints: {sorted(joints)}"
        raise DeclarationError(message)
    if not all(math.isfinite(value) for point in points for value in point):
        message = f"{called} must be finite angles, not {points}"
        raise DeclarationError(message)
    if not all(0.0 < value < math.inf for values in limits for value in values):
        message = f"limits must be above 0 and finite, not {limits}"
        raise DeclarationError(message)
    shortest, longest = durations
    if not 0.0 < shortest <= longest < math.inf:
        message = f"durations {durations} must be 0 < shortest <= longest, in s"
        raise DeclarationError(message)
