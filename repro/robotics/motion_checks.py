"""What every motion problem must declare: finite waypoints, limits above 0, durations in order."""

import math
from collections.abc import Iterable, Mapping, Sequence, Sized
from collections.abc import Set as AbstractSet
from itertools import pairwise
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError, InputError

Vector = NDArray[np.float64]
Rows = tuple[tuple[float, ...], ...]
LARGEST = 1e100  # of any number in size, in its unit: products of more are no doubles
SHOWN = 60  # characters of a value in a message


def numbers(values: Any, *, called: str) -> tuple[float, ...]:  # noqa: ANN401 (checked here)
    """Return a list, tuple or array as floats; DeclarationError where one is no number.

    So is one that is finite and more than LARGEST in size.
    """
    if not _is_list(values):
        message = f"{called}: {shown(values)} is no list of numbers, one per joint"
        raise DeclarationError(message)
    return tuple(number(value, called=f"{called}, number {k}") for k, value in enumerate(values, 1))


def rows(values: Any, *, called: str) -> Rows:  # noqa: ANN401 (checked here)
    """Return a list of lists, or an array (points, joints), as tuples of floats."""
    if not _is_list(values):
        message = f"{called}: {shown(values)} is no list of points, each a number per joint"
        raise DeclarationError(message)
    return tuple(numbers(point, called=f"{called}, row {k}") for k, point in enumerate(values, 1))


def number(value: Any, *, called: str) -> float:  # noqa: ANN401 (checked here)
    """Return a number as a float; DeclarationError for what is none or beyond what is computed."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, bool | np.bool_) or not isinstance(value, Real):
        message = f"{called}: {shown(value)} is no number"
        raise DeclarationError(message)
    try:
        found = float(value)
    except (OverflowError, ValueError):
        found = LARGEST * LARGEST
    if LARGEST < abs(found) < math.inf:
        message = (
            f"{called}: {shown(value)} is beyond what is computed: {LARGEST:g} in size at most"
        )
        raise DeclarationError(message)
    return found


def shown(value: object) -> str:
    """Return a value in one short line, whatever it is."""
    try:
        line = " ".join(repr(value).split())
    except Exception:  # noqa: BLE001 (a whole number of many digits, or a class of the user's own)
        line = f"this {type(value).__name__}"
    return line if len(line) <= SHOWN else f"{line[:SHOWN]}…"


def check_word(value: Any, known: Sequence[str], *, called: str) -> None:  # noqa: ANN401
    """Raise DeclarationError unless the value is one of the words known."""
    if not isinstance(value, str) or value not in known:
        message = f"{called} {shown(value)}: known are {', '.join(known)}"
        raise DeclarationError(message)


def _is_list(values: object) -> bool:
    if isinstance(values, str | bytes | bytearray | memoryview | Mapping | AbstractSet):
        return False
    if isinstance(values, np.ndarray):
        return values.ndim > 0
    return isinstance(values, Iterable) and isinstance(values, Sized)


def check_motion(
    points: Rows,
    limits: Mapping[str, Sequence[float]],
    durations: Sequence[float],
    *,
    called: str,
) -> None:
    """Raise DeclarationError for a motion that cannot be; `called` is what its points are called.

    `limits` are named. All points and limits have one number per joint, a segment takes time, and
    in every segment something moves.
    """
    _check_points(points, called=called)
    joints = len(points[0])
    for kind, values in limits.items():
        if len(values) != joints:
            message = (
                f"{called} and limits disagree on the number of joints: {called} have {joints}, "
                f"{kind} has {len(values)}"
            )
            raise DeclarationError(message)
        for joint, value in enumerate(values, start=1):
            if not 0.0 < value < math.inf:
                message = f"limits must be above 0 and finite: {kind} of joint {joint} is {value!r}"
                raise DeclarationError(message)
            check_limit(value, called=f"{kind} of joint {joint}")
    if len(durations) != 2 or not 0.0 < durations[0] <= durations[1] < math.inf:
        message = f"durations {tuple(durations)} must be 0 < shortest <= longest, in s"
        raise DeclarationError(message)


def limit_pairs(values: Any, *, called: str) -> Rows:  # noqa: ANN401 (checked here)
    """Return a list of limits as pairs; DeclarationError unless each is lowest < 0 < highest."""
    pairs = rows(values, called=called)
    for joint, pair in enumerate(pairs, start=1):
        if len(pair) != 2 or not pair[0] < 0.0 < pair[1]:
            message = f"{called} of joint {joint}: {shown(pair)} must be lowest < 0 < highest"
            raise DeclarationError(message)
        for limit in pair:
            check_limit(limit, called=f"{called} of joint {joint}")
    return pairs


def check_limit(value: float, *, called: str) -> None:
    """Raise DeclarationError for a limit so near to 0 that products of it are no doubles."""
    if abs(value) < 1.0 / LARGEST:
        message = f"{called}: {value!r} is beyond what is computed: {1.0 / LARGEST:g} at least"
        raise DeclarationError(message)


def _check_points(points: Rows, *, called: str) -> None:
    if len(points) < 2:
        message = f"{called}: a motion needs two or more, not {len(points)}"
        raise DeclarationError(message)
    counts = sorted({len(point) for point in points})
    if len(counts) > 1 or counts == [0]:
        message = f"{called} disagree on the number of joints: {counts}"
        raise DeclarationError(message)
    for place, point in enumerate(points, start=1):
        for joint, value in enumerate(point, start=1):
            if not math.isfinite(value):
                message = (
                    f"{called} must be finite angles: joint {joint} of number {place} is {value!r}"
                )
                raise DeclarationError(message)
    for place, (start, end) in enumerate(pairwise(points), start=1):
        if start == end:
            message = (
                f"{called} {place} and {place + 1} are equal, {start}: nothing moves between "
                "them; leave one of them out"
            )
            raise DeclarationError(message)


def as_doubles(values: Any, *, called: str) -> Vector:  # noqa: ANN401 (checked here)
    """Return an array of doubles; InputError for what is none."""
    try:
        found = np.asarray(values)
        if found.dtype.kind in "iufO":
            return np.asarray(found, dtype=np.float64)
    except Exception:  # noqa: BLE001, S110 (an object of the user's own may raise anything)
        pass
    message = f"{called} {shown(values)}: is no array of numbers"
    raise InputError(message)


def checked_durations(durations: Any, segments: int) -> Vector:  # noqa: ANN401 (checked here)
    """Return the durations of a motion as an array; InputError unless each segment takes time."""
    found = as_doubles(durations, called="durations")
    if found.shape != (segments,) or not (np.isfinite(found).all() and (found > 0.0).all()):
        message = (
            f"durations {shown(found.tolist())}: a motion of {segments} segments needs {segments}, "
            "each above 0 s and finite"
        )
        raise InputError(message)
    return found
