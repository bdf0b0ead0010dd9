"""The values of a motion file: numbers in the shapes that they may have, each fault in one line."""

import difflib
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from repro.errors import InputError
from repro.robotics.motion_checks import LARGEST, Rows, numbers, rows, shown


class Faulty(InputError):  # noqa: N818 (a fault of a file, not of the program)
    """A value of a motion file that cannot be; the file is named around it."""


def check_keys(given: Iterable[str], known: Iterable[str]) -> None:
    """Raise Faulty for a key that no motion file has."""
    known = tuple(known)
    for key in given:
        if key not in known:
            near = difflib.get_close_matches(key, known, n=1)
            meant = f", {near[0]!r} perhaps" if near else ""
            message = f"unknown key {shown(key)}{meant}; known are {', '.join(known)}"
            raise Faulty(message)


def check_sizes(given: Mapping[str, Any]) -> None:
    """Raise Faulty for a number so large or so near to 0 that products of it are no doubles."""
    for key, value in given.items():
        for number in _numbers_in(value):
            if number and not 1.0 / LARGEST <= abs(number) <= LARGEST:
                shown = repr(number) if isinstance(number, float) else "a whole number"
                message = (
                    f"{key}: {shown} is beyond what is computed: 0, or from {1.0 / LARGEST:g} to "
                    f"{LARGEST:g} in size"
                )
                raise Faulty(message)


def _numbers_in(value: object) -> Iterator[int | float]:
    if isinstance(value, list):
        for entry in value:
            yield from _numbers_in(entry)
    elif isinstance(value, int) or (isinstance(value, float) and math.isfinite(value)):
        yield value


def text(
    given: Mapping[str, Any], key: str, *, default: str | None, known: tuple[str, ...] = ()
) -> str:
    """Return a text, one of those known."""
    value = given.get(key, default)
    among = f"one of {', '.join(known)}" if known else "a text"
    if value is None:
        message = f"{key} is missing: it is {among}"
        raise Faulty(message)
    if not isinstance(value, str) or (known and value not in known):
        message = f"{key}: {shown(value)} is not {among}"
        raise Faulty(message)
    return value


def row_of_numbers(given: Mapping[str, Any], key: str, joints: int) -> tuple[float, ...] | None:
    """Return one number per joint, None where the key is not there."""
    if key not in given:
        return None
    found = numbers(given[key], called=key)
    if len(found) != joints:
        message = f"{key}: {len(found)} numbers for {joints} joints"
        raise Faulty(message)
    for joint, value in enumerate(found, start=1):
        if not math.isfinite(value):
            message = f"{key} of joint {joint} is {value!r}, not a finite number"
            raise Faulty(message)
    return found


def pairs(given: Mapping[str, Any], key: str, joints: int) -> Rows | None:
    """Return the lowest and highest value of each joint, None where the key is not there.

    Limits may be one number for all joints, one per joint, or a pair per joint, a range only pairs.
    """
    if key not in given:
        return None
    value = given[key]
    if isinstance(value, int | float) and not isinstance(value, bool) and key != "range":
        value = [value] * joints
    if not isinstance(value, list):
        shapes = "[[low, high], …]" if key == "range" else "a number, a list, or [[low, high], …]"
        message = f"{key}: {shown(value)} is not {shapes}, one per joint"
        raise Faulty(message)
    if len(value) != joints:
        message = f"{key}: {len(value)} entries for {joints} joints"
        raise Faulty(message)
    if any(isinstance(entry, list) for entry in value) or key == "range":
        found = rows(value, called=key)
    else:
        found = tuple((-limit, limit) for limit in numbers(value, called=key))
    for joint, pair in enumerate(found, start=1):
        _check_pair(key, joint, pair, value[joint - 1])
    return found


def _check_pair(key: str, joint: int, pair: tuple[float, ...], given: object) -> None:
    if len(pair) != 2 or not all(map(math.isfinite, pair)):
        meant = "two finite numbers, low and high" if isinstance(given, list) else "a finite number"
        message = f"{key} of joint {joint}: {shown(given)} is not {meant}"
        raise Faulty(message)
    low, high = pair
    if key == "range" and not low < high:
        message = f"{key} of joint {joint}: {shown(given)} must be low < high"
        raise Faulty(message)
    if key != "range" and not low < 0.0 < high:
        rule = "low < 0 < high" if isinstance(given, list) else "above 0"
        message = f"{key} of joint {joint}: {shown(given)} must be {rule}"
        raise Faulty(message)
