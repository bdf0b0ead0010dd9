"""A printed arm beside the machine that its paper names: links, limits, needs and ranges."""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from repro.model.arm_motions import durations_of, limits_of, peaks
from repro.model.figures import Arm, ArmMotion
from repro.model.named_robot import LINKS, NamedRobot
from repro.robotics.kinematics import dh_rows
from repro.robotics.link_lengths import LinkLengths, link_lengths
from repro.tables.rows import AuditRow, Grade

Vector = NDArray[np.float64]
APART = 1e-3  # m and rad: descriptions and prints are rounded to so much
ROUNDING = 1e-9
KINDS = {1: ("speed", "rad/s"), 2: ("acceleration", "rad/s²")}


def link_rows(paper: str, arm: Arm) -> Iterator[AuditRow]:
    """Yield the printed table against the machine's, by what no convention changes."""
    robot = _robot(arm)
    if arm.table is None or robot.links is None:
        return
    a, alpha, d = (robot.links.column(name) for name in LINKS)
    printed = link_lengths(arm.dh, arm.convention)
    machine = link_lengths(dh_rows(a=a, alpha=alpha, d=d))
    differ = [*_twists_apart(printed, machine), *_lengths_apart(printed, machine)]
    if not differ:
        told = (
            f"{arm.table.label} has the links of the {robot.name}: every length that no choice of "
            f"frames changes is that of {robot.links_source} within 1 mm, every twist within 0.001 "
            "rad"
        )
        yield _row(paper, arm, "arm-links", told, grade=Grade.NOTED)
        return
    told = (
        f"the links are not those of the {robot.name}, compared by lengths that no choice of "
        f"frames changes, printed beside {robot.links_source}: {'; '.join(differ)}"
    )
    condition = f"{arm.table.label} means the {robot.name} as that source describes it"
    yield _row(paper, arm, "arm-links", told, condition, grade=Grade.INCONSISTENT)


def _lengths_apart(printed: LinkLengths, machine: LinkLengths) -> Iterator[str]:
    for name in sorted(printed.lengths.keys() | machine.lengths.keys(), key=_axis):
        own, other = printed.lengths.get(name), machine.lengths.get(name)
        if own is None or other is None:
            which, length = ("print", own) if other is None else ("machine", other)
            yield f"{name} {1000 * (length or 0):.0f} mm in the {which} alone"
        elif abs(own - other) > APART:
            yield (
                f"{name} {1000 * own:.0f} and {1000 * other:.0f} mm ({1000 * (own - other):+.0f})"
            )


def _axis(name: str) -> tuple[int, str]:
    return int(next(word for word in name.split() if word.isdigit())), name


def _twists_apart(printed: LinkLengths, machine: LinkLengths) -> Iterator[str]:
    for k, (own, other) in enumerate(zip(printed.twists, machine.twists, strict=True), start=1):
        if abs(own - other) > APART:
            yield (
                f"the angle between axes {k} and {k + 1} {math.degrees(own):.0f}° and "
                f"{math.degrees(other):.0f}°"
            )


def limit_rows(paper: str, arm: Arm) -> Iterator[AuditRow]:
    """Yield the limits that the paper sets above those of the machine."""
    robot = _robot(arm)
    limits = next((found for m in arm.motions if (found := limits_of(m)) is not None), None)
    if limits is None:
        return
    for derivative, (kind, unit) in KINDS.items():
        greatest = robot.limit(derivative)
        if greatest is None:
            continue
        over = [
            f"joint {k} {own:.4g} over {least:.3g} {unit}"
            for k, (own, least) in enumerate(zip(limits[derivative - 1], greatest, strict=True), 1)
            if own > least * (1 + APART)
        ]
        if over:
            told = (
                f"the limits on {kind} exceed those of the {robot.name} ({robot.source}): "
                f"{', '.join(over)}"
            )
            yield _row(paper, arm, "arm-limits", told, _means(robot), at=arm.limits_at)


def need_rows(paper: str, arm: Arm) -> Iterator[AuditRow]:
    """Yield the motions whose exact peaks exceed what the machine can do."""
    robot = _robot(arm)
    for chosen in arm.motions:
        needs = []
        for derivative, (kind, unit) in KINDS.items():
            greatest = robot.limit(derivative)
            if greatest is None:
                continue
            for k, (peak, most) in enumerate(zip(peaks(chosen, derivative), greatest, strict=True)):
                if peak > most * (1 + ROUNDING):
                    needs.append(
                        f"{100 * peak / most:.0f} % of the {kind} of joint {k + 1} "
                        f"({peak:.4g} of {most:.4g} {unit})"
                    )
        if needs:
            told = (
                f"{chosen.name}, {sum(durations_of(chosen)):.5g} s, needs at its peaks "
                f"{', '.join(needs)} of the {robot.name} ({robot.source})"
            )
            yield _row(paper, arm, "arm-needs", told, _means(robot))


def range_rows(paper: str, arm: Arm, chosen: ArmMotion, angles: Vector) -> Iterator[AuditRow]:
    """Yield what the way leaves of the ranges of the machine's axes; angles (n, joints) in rad."""
    robot = _robot(arm)
    left = [_left(robot, joint, own) for joint, own in enumerate(angles.T)]
    told = (
        f"on the way of {chosen.name} the axes of the {robot.name} ({robot.source}) go: "
        f"{'; '.join(words for words, _ in left)}"
    )
    names = zip(robot.axes.row_names, left, strict=True)
    outside = [name for name, (_, room) in names if room < 0]
    if outside:
        told += f". Out of range: {', '.join(outside)}"
    yield _row(paper, arm, "arm-ranges", told, _zeros(robot))


def _left(robot: NamedRobot, joint: int, angles: Vector) -> tuple[str, float]:
    """Return what an axis does, in words, and the angle in rad that it leaves at the least."""
    least, greatest = robot.ranges[joint]
    axis = robot.axes.row_names[joint]
    reads = robot.reads(joint, angles)
    if reads is None:
        way = float(np.ptp(angles))
        wide = float(greatest - least)
        return f"{axis} over {math.degrees(way):.1f}° of {math.degrees(wide):.0f}°", wide - way
    low, high = float(reads.min()), float(reads.max())
    room = float(min(low - least, greatest - high))
    words = (
        f"{axis} from {math.degrees(low):.1f}° to {math.degrees(high):.1f}° in "
        f"{math.degrees(least):.0f}°…{math.degrees(greatest):.0f}° "
        f"({abs(math.degrees(room)):.1f}° {'left' if room >= 0 else 'beyond'})"
    )
    return words, room


def _zeros(robot: NamedRobot) -> str:
    """Return what is taken of the axes' zeros, and that the machine is meant."""
    known = [joint for joint in range(robot.joints) if robot.reads(joint, np.zeros(1)) is not None]
    told = ", ".join(f"{robot.axes.row_names[joint]} = {_reading(robot, joint)}" for joint in known)
    return f"{told}, and {_means(robot)}" if told else _means(robot)


def _reading(robot: NamedRobot, joint: int) -> str:
    """Return an axis's angle as a formula of the joint's, whose zero is known."""
    zero, sign = robot.zeros[joint] or 0.0, robot.signs[joint] if robot.signs else 1
    angle, offset = f"θ{joint + 1}", -sign * math.degrees(zero)
    if abs(zero) < APART:
        return angle if sign > 0 else f"-{angle}"
    if sign < 0:
        return f"{offset:.0f}° - {angle}"
    return f"{angle} {'+' if offset > 0 else '-'} {abs(offset):.0f}°"


def _means(robot: NamedRobot) -> str:
    return f"the {robot.name} is meant, as that source describes it"


def _robot(arm: Arm) -> NamedRobot:
    if arm.robot is None:
        message = f"{arm.label}: no robot is declared"
        raise ValueError(message)
    return arm.robot


def _row(
    paper: str,
    arm: Arm,
    check: str,
    told: str,
    condition: str | None = None,
    *,
    grade: Grade = Grade.NOTED,
    at: str = "",
) -> AuditRow:
    return AuditRow(
        paper=paper,
        table=at or (arm.table.label if arm.table else arm.label),
        row=None,
        column=None,
        cells=(),
        check=check,
        grade=grade,
        explanation=told,
        condition=condition,
    )
