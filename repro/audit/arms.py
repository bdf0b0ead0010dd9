"""The arms of a paper: where their links go, and how they compare with the machine it names."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.audit.machines import limit_rows, link_rows, need_rows, range_rows
from repro.model.arm_motions import course, durations_of, led_through
from repro.model.figures import Arm, ArmMotion
from repro.model.paper import Paper
from repro.robotics.whereabouts import below, corners_along
from repro.tables.rows import AuditRow, Grade

Vector = NDArray[np.float64]
SAMPLES = 2001  # of a segment: chords of so short pieces lie within 0.1 mm of the tool's path
SLACK = 1e-4  # m: what is nearer to the plane than 0.1 mm is on it
WRIST = 3  # the first frame that a column and an upper arm do not hold
COLUMN = 1 / 20  # of the reach: no serial arm's column is thinner; joint 2 may stand farther out


def arm_rows(paper: Paper) -> Iterator[AuditRow]:
    """Yield the rows of every arm that the paper's figures show."""
    for figure in paper.figures:
        if isinstance(figure, Arm):
            yield from rows_of_arm(paper.key, figure)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Way:
    """A motion at `times` (n,), with angles (n, joints) and corners (n, 2 joints + 1, 3) in m."""

    motion: ArmMotion
    times: Vector
    angles: Vector
    corners: Vector


def _way(arm: Arm, chosen: ArmMotion) -> _Way:
    times, angles = course(chosen, derivative=0, samples=SAMPLES)
    corners = corners_along(arm.dh, angles, arm.convention)
    return _Way(motion=chosen, times=times, angles=angles, corners=corners)


def rows_of_arm(paper: str, arm: Arm) -> Iterator[AuditRow]:
    """Yield what one arm's links and motions say, first beside the machine, then in space."""
    paths = _paths(arm)
    if arm.robot is not None:
        yield from link_rows(paper, arm)
        yield from limit_rows(paper, arm)
        yield from need_rows(paper, arm)
        for same in paths:
            yield from range_rows(paper, arm, same[0].motion, same[0].angles)
    for same in paths:
        yield from _below_rows(paper, arm, same)
        yield from _column_rows(paper, arm, same)


def _paths(arm: Arm) -> list[list[_Way]]:
    """Return the motions grouped by what they lead through, which is one path in space each."""
    groups: dict[tuple[object, ...], list[_Way]] = {}
    for chosen in arm.motions:
        way = _way(arm, chosen)
        extent = np.round(way.corners.min(axis=0), 4)
        key = (*np.round(led_through(chosen), 9).ravel().tolist(), *extent.ravel().tolist())
        groups.setdefault(key, []).append(way)
    return list(groups.values())


def _below_rows(paper: str, arm: Arm, same: Sequence[_Way]) -> Iterator[AuditRow]:
    """Yield a row where the tool or another corner of the links is below the base plane."""
    corners = same[0].corners
    tool, lowest = float(corners[:, -1, 2].min()), float(corners[..., 2].min())
    if lowest >= -SLACK:
        return
    which = divmod(int(corners[..., 2].min(axis=0).argmin()), 2)
    times = "; ".join(map(_time_below, same))
    yield _row(
        paper,
        arm,
        "arm-below-base",
        (
            f"the lowest point of the links comes to {_mm(lowest)} mm from the plane z = 0 of the "
            f"base frame, {_corner(*which, len(arm.dh))}, the tool to {_mm(tool)} mm, whatever the "
            f"durations, for the path is the same; below the plane, by {SAMPLES:,} instants of "
            f"each segment: {times}"
        ),
        f"the arm stands on the plane z = 0 of the base frame{_unsaid_height(arm)}",
    )


def _time_below(way: _Way) -> str:
    times, corners = way.times, way.corners
    told = []
    for name, heights in (("the tool", corners[:, -1, 2]), ("any", corners[..., 2].min(axis=1))):
        lasting = below(times, heights, -SLACK).lasting
        told.append(f"{name} for {lasting:.3g} s ({100 * lasting / times[-1]:.0f} %)")
    return f"{way.motion.name}, {sum(durations_of(way.motion)):.5g} s: {', '.join(told)}"


def _unsaid_height(arm: Arm) -> str:
    """Return what is not known of the floor where the table begins at the shoulder."""
    if any(abs(corner) > SLACK for corner in corners_along(arm.dh[:1], [0.0])[0][:, 2]):
        return ""
    return (
        ", of which nothing says how high it is above the floor: joint 1 has no length of its own"
    )


def _corner(frame: int, bend: int, joints: int) -> str:
    """Return what a corner of the skeleton is called."""
    if bend:
        return f"the bend of link {frame + 1}"
    return "the tool" if frame == joints else f"the origin of frame {frame}"


def _column_rows(paper: str, arm: Arm, same: Sequence[_Way]) -> Iterator[AuditRow]:
    """Yield a row where wrist or tool is lower than joint 2 and close to the axis of joint 1."""
    times, corners = same[0].times, same[0].corners
    joints = len(arm.dh)
    if joints <= WRIST:
        return
    shoulder = float(corners[0, :3, 2].max())
    offset = float(np.hypot(*corners[0, 2, :2]))
    reach = float(np.linalg.norm(np.diff(corners[0], axis=0), axis=1).sum())
    near = max(offset, COLUMN * reach)
    wrist = 2 * max(WRIST, joints - 2)
    away = np.hypot(corners[:, wrist::2, 0], corners[:, wrist::2, 1])
    heights = corners[:, wrist::2, 2]
    away = np.where((heights >= -SLACK) & (heights <= shoulder), away, np.inf)
    if away.min() >= near:
        return
    instant, point = np.unravel_index(int(away.argmin()), away.shape)
    frame = wrist // 2 + int(point)
    yield _row(
        paper,
        arm,
        "arm-in-column",
        (
            f"{_corner(frame, 0, joints)} is {_mm(float(away.min()))} mm from the axis of joint 1 "
            f"and {_mm(float(heights[instant, point]))} mm above the base plane at "
            f"{times[instant]:.3g} s of {same[0].motion.name}, lower than joint 2, which stands "
            f"{_mm(shoulder)} mm high and {_mm(offset)} mm from that axis"
        ),
        f"the column that carries joint 2 is thicker there than {_mm(float(away.min()))} mm",
    )


def _row(paper: str, arm: Arm, check: str, explanation: str, condition: str) -> AuditRow:
    return AuditRow(
        paper=paper,
        table=arm.table.label if arm.table else arm.label,
        row=None,
        column=None,
        cells=(),
        check=check,
        grade=Grade.NOTED,
        explanation=explanation,
        condition=condition,
    )


def _mm(metres: float) -> str:
    return f"{1000 * metres:.0f}"
