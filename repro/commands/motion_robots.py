"""The arm of a motion file: a robot description (URDF) or a D-H table."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from repro.commands.motion_values import Faulty, text
from repro.robotics.chain import Chain, Joint, from_dh
from repro.robotics.motion_checks import Rows, rows, shown
from repro.robotics.urdf import read_urdf

OF_A_TABLE = ("convention", "kinds")


@dataclass(frozen=True, slots=True, kw_only=True)
class Robot:
    """An arm, and the limits that come with it, in the file's unit, by kind."""

    chain: Chain
    limits: Mapping[str, Rows]

    @property
    def kinds(self) -> tuple[str, ...]:
        """Whether each joint turns or slides."""
        return tuple(joint.kind for joint in self.chain.joints)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the joints."""
        return tuple(joint.name for joint in self.chain.joints)


def robot_of(given: Mapping[str, Any], *, folder: Path, unit: str, joints: int) -> Robot | None:
    """Return the arm that a file's content names, None where it names none."""
    if "robot" in given and "dh" in given:
        message = "robot and dh are two arms; keep one of them"
        raise Faulty(message)
    if "robot" in given:
        return _described(given, folder=folder, unit=unit, joints=joints)
    if "dh" in given:
        return _tabled(given, unit=unit, joints=joints)
    for key in OF_A_TABLE:
        if key in given:
            message = f"{key} belongs to a D-H table, and dh is missing"
            raise Faulty(message)
    return None


def _described(given: Mapping[str, Any], *, folder: Path, unit: str, joints: int) -> Robot:
    for key in OF_A_TABLE:
        if key in given:
            message = f"{key} belongs to a D-H table; the robot's description has its own"
            raise Faulty(message)
    chain, limits = read_urdf(folder / text(given, "robot", default=None))
    if len(chain.joints) != joints:
        names = ", ".join(joint.name for joint in chain.joints)
        message = (
            f"robot {given['robot']!r} has {len(chain.joints)} joints that move ({names}), "
            f"waypoints have {joints}"
        )
        raise Faulty(message)
    in_unit = {
        kind: tuple(
            tuple(value / _unit(joint, unit) for value in pair)
            for joint, pair in zip(chain.joints, values, strict=True)
        )
        for kind, values in limits.items()
    }
    return Robot(chain=chain, limits=in_unit)


def _unit(joint: Joint, unit: str) -> float:
    return math.radians(1.0) if joint.kind == "revolute" and unit == "deg" else 1.0


def _tabled(given: Mapping[str, Any], *, unit: str, joints: int) -> Robot:
    table = rows(given["dh"], called="dh")
    if len(table) != joints or any(len(row) != 4 for row in table):
        message = (
            f"dh: {joints} joints need {joints} rows of theta offset, d, a, alpha, not "
            f"{len(table)} of {sorted({len(row) for row in table})}"
        )
        raise Faulty(message)
    if not all(math.isfinite(value) for row in table for value in row):
        message = "dh: every entry must be a finite number"
        raise Faulty(message)
    convention = text(given, "convention", default="standard", known=("standard", "modified"))
    kinds = given.get("kinds", ["revolute"] * joints)
    known = ("revolute", "prismatic")
    if not isinstance(kinds, list) or len(kinds) != joints or any(k not in known for k in kinds):
        message = f"kinds: {shown(kinds)} must be {joints} of {', '.join(known)}"
        raise Faulty(message)
    one = math.radians(1.0) if unit == "deg" else 1.0
    chain = from_dh(
        [(a, alpha * one, d, theta * one) for theta, d, a, alpha in table],
        kinds,
        "modified" if convention == "modified" else "standard",
    )
    return Robot(chain=chain, limits={})
