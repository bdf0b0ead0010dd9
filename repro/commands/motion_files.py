"""The file that `repro motion` reads: a motion, its limits and perhaps its arm, as TOML."""

import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

from repro.commands.motion_robots import Robot, robot_of
from repro.commands.motion_values import (
    Faulty,
    check_keys,
    check_sizes,
    pairs,
    row_of_numbers,
    text,
)
from repro.errors import DeclarationError, InputError, ReproError
from repro.robotics import DirectedSpline, MinimumTime, RestToRestLaw
from repro.robotics.bsplines import Ends
from repro.robotics.motion_checks import Rows, numbers, rows, shown
from repro.robotics.own_motion import OwnMotion
from repro.robotics.polynomial_motion import PolynomialMotion
from repro.robotics.polynomials import HIGHEST
from repro.robotics.proofs.proved import FREE

KEYS = (
    *("title", "unit", "law", "waypoints", "velocity", "acceleration", "jerk", "range"),
    *("start_velocity", "end_velocity", "durations", "ends", "time_ends"),
    *("robot", "dh", "convention", "kinds"),
)
DEGREES = {"cubic": 3, "quintic": 5, "septic": 7, **{str(k): k for k in range(3, HIGHEST + 1, 2)}}
LAWS = "cubic, quintic, septic, an odd degree (9, 11, …) or spline"
CLOSED_FORM = 9  # highest degree whose polynomial is as good in doubles as it is exactly
SPLINE = "spline"


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionFile:
    """A motion as a file has it, in the file's own unit.

    `units` has one per joint, deg, rad or m; `limits` have pairs of lowest and highest per joint,
    by kind; `robot` is None where the file names none.
    """

    title: str
    units: tuple[str, ...]
    names: tuple[str, ...]
    problem: OwnMotion
    limits: Mapping[str, Rows]
    robot: Robot | None

    @property
    def si(self) -> tuple[float, ...]:
        """What one unit of each joint is in rad or m."""
        return tuple(math.radians(1.0) if unit == "deg" else 1.0 for unit in self.units)


def read_motion(path: Path) -> MotionFile:
    """Return the motion of a file; InputError with file, key, value and alternatives."""
    try:
        given = tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except OSError as error:
        message = f"{path}: cannot be read: {error.strerror}"
        raise InputError(message) from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        message = f"{path}: is no TOML: {' '.join(str(error).split())}"
        raise InputError(message) from None
    except (ValueError, RecursionError):
        message = f"{path}: cannot be read: a number of too many digits, or too many lists in lists"
        raise InputError(message) from None
    try:
        return motion_of(given, folder=path.parent, called=path.stem)
    except ReproError as error:
        message = f"{path}: {error}"
        raise InputError(message) from None


def motion_of(given: Mapping[str, Any], *, folder: Path, called: str) -> MotionFile:
    """Return the motion that a file's content declares."""
    check_keys(given, KEYS)
    check_sizes(given)
    unit = text(given, "unit", default=None, known=("deg", "rad"))
    points = _points(given)
    joints = len(points[0])
    robot = robot_of(given, folder=folder, unit=unit, joints=joints)
    kinds = robot.kinds if robot else ("revolute",) * joints
    limits = _limits(given, joints, robot)
    degree = _degree(given)
    if degree is None:
        problem: OwnMotion = _spline(given, points, limits)
    else:
        problem = _polynomials(given, points, limits, degree)
    return MotionFile(
        title=" ".join(text(given, "title", default=called).split()) or called,
        units=tuple("m" if kind == "prismatic" else unit for kind in kinds),
        names=robot.names if robot else tuple(f"joint_{k + 1}" for k in range(joints)),
        problem=problem,
        limits=limits,
        robot=robot,
    )


def _points(given: Mapping[str, Any]) -> Rows:
    if "waypoints" not in given:
        message = "waypoints are missing: a row per waypoint, a number per joint"
        raise Faulty(message)
    points = rows(given["waypoints"], called="waypoints")
    if len(points) < 2:
        message = f"waypoints: a motion needs two or more, not {len(points)}"
        raise Faulty(message)
    counts = [len(point) for point in points]
    if not counts[0]:
        message = "waypoints, row 1: there is no number; a row has one per joint"
        raise Faulty(message)
    for k, count in enumerate(counts, start=1):
        if count != counts[0]:
            message = f"waypoints, row {k}: {count} numbers where row 1 has {counts[0]}"
            raise Faulty(message)
    return points


def _degree(given: Mapping[str, Any]) -> int | None:
    """Return the degree of the law's polynomial, None for a spline."""
    law = given.get("law")
    if law == SPLINE:
        return None
    degree = DEGREES.get(law, law) if isinstance(law, str) else law
    if law is None:
        message = f"law is missing: {LAWS}"
        raise Faulty(message)
    if (
        isinstance(degree, bool)
        or not isinstance(degree, int)
        or not 3 <= degree <= HIGHEST
        or degree % 2 == 0
    ):
        message = f"law: {shown(law)} is not {LAWS}, {HIGHEST} at most"
        raise Faulty(message)
    return degree


def _limits(given: Mapping[str, Any], joints: int, robot: Robot | None) -> dict[str, Rows]:
    """Return what the file says, and else what the robot's description says."""
    found = {}
    for key in ("velocity", "acceleration", "jerk", "range"):
        own = pairs(given, key, joints)
        told = robot.limits.get(key) if robot else None
        if own is None:
            own = told
        if own is not None:
            found[key] = own
        elif key in {"velocity", "acceleration"}:
            where = " (the robot's description has none)" if robot else ""
            message = f"{key} is missing{where}: a number, a list, or [[low, high], …]"
            raise Faulty(message)
    return found


def _box(given: Mapping[str, Any]) -> tuple[float, float]:
    if "durations" not in given:
        return FREE
    own = given["durations"]
    box = numbers(own, called="durations") if isinstance(own, list) else ()
    if len(box) != 2 or not 0.0 < box[0] <= box[1] < math.inf:
        message = f"durations: {shown(own)} must be [shortest, longest] in s, 0 < shortest"
        raise Faulty(message)
    return box[0], box[1]


def _even(limits: Rows) -> tuple[float, ...] | None:
    """Return one number per joint where upper and lower limits are alike, else None."""
    if all(low == -high for low, high in limits):
        return tuple(high for _, high in limits)
    return None


def _polynomials(
    given: Mapping[str, Any], points: Rows, limits: Mapping[str, Rows], degree: int
) -> OwnMotion:
    for key in ("ends", "time_ends"):
        if key in given:
            message = f"{key} is of a spline alone; law is {given['law']!r}"
            raise Faulty(message)
    joints = len(points[0])
    problem = PolynomialMotion(
        waypoints=points,
        degree=degree,
        velocity=limits["velocity"],
        acceleration=limits["acceleration"],
        jerk=limits.get("jerk"),
        range=limits.get("range"),
        start=row_of_numbers(given, "start_velocity", joints),
        end=row_of_numbers(given, "end_velocity", joints),
        durations=_box(given),
    )
    jerk = _even(limits["jerk"]) if "jerk" in limits else None
    even = _even(limits["velocity"]), _even(limits["acceleration"])
    still = not any(problem.start or ()) and not any(problem.end or ())
    if None in even or ("jerk" in limits and jerk is None) or not still or degree > CLOSED_FORM:
        return problem
    # at rest at every waypoint a law runs from one to the next, so that it keeps every range
    return MinimumTime(
        waypoints=points,
        law=RestToRestLaw(degree),
        velocity=even[0] or (),
        acceleration=even[1] or (),
        jerk=jerk,
        durations=problem.durations,
    )


def _spline(given: Mapping[str, Any], points: Rows, limits: Mapping[str, Rows]) -> OwnMotion:
    joints = len(points[0])
    rule = {
        key: text(given, key, default=default, known=("still", "repeated", "natural"))
        for key, default in (("ends", "still"), ("time_ends", "repeated"))
    }
    _check_spline(given, joints, rule["ends"])
    _check_inside(points, limits.get("range", ()))
    try:
        spline = DirectedSpline(
            nodes=points,
            velocity=limits["velocity"],
            acceleration=limits["acceleration"],
            jerk=limits.get("jerk"),
            durations=_box(given),
            ends=_rule(rule["ends"]),
            time_ends=_rule(rule["time_ends"]),
        )
    except DeclarationError as error:  # nodes are called waypoints in a file
        raise Faulty(str(error).replace("nodes", "waypoints", 1)) from None
    if _even(spline.velocity) and _even(spline.acceleration) and spline.jerk is None:
        return spline.widest
    return spline


def _check_spline(given: Mapping[str, Any], joints: int, ends: str) -> None:
    """Raise Faulty for what a spline does not admit."""
    for key in ("start_velocity", "end_velocity"):
        speeds = row_of_numbers(given, key, joints)
        if speeds is not None and (any(speeds) or ends != "still"):
            message = (
                f"{key}: a spline has none of its own: 0 with ends = 'still', and what its "
                f"durations make it with other ends; leave it out"
            )
            raise Faulty(message)


def _check_inside(points: Rows, ranges: Rows) -> None:
    for joint, (low, high) in enumerate(ranges):
        for place, point in enumerate(points, start=1):
            if not low <= point[joint] <= high:
                message = (
                    f"waypoints: joint {joint + 1} of number {place} is {point[joint]!r}, outside "
                    f"its range from {low!r} to {high!r}"
                )
                raise Faulty(message)


def _rule(word: str) -> Ends:
    return next(rule for rule in get_args(Ends) if rule == word)
