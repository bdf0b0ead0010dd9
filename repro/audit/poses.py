"""Printed joint angles against printed positions, through the printed D-H table."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from repro.robotics import Convention, forward_kinematics
from repro.tables.published import UNITS, PublishedTable
from repro.tables.relations import PrintedPoses, TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import span, unit

Array = NDArray[np.float64]
Place = tuple[int, int]  # row and column of the D-H table
RIGHT_ANGLES = (-math.pi / 2, 0.0, math.pi / 2, math.pi)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Change:
    """One constant of the D-H table replaced, and the position errors (waypoints, 3) in m then."""

    words: str
    errors: Array


def pose_rows(paper: str, relation: PrintedPoses) -> Iterator[AuditRow]:
    """Yield a row where no convention leads from the joint table to the position table."""
    errors = {
        convention: _errors(relation, _dh(relation), convention)
        for convention in get_args(Convention)
    }
    nearest: Convention = min(errors, key=lambda name: _size(errors[name]))
    cells = _beyond_rounding(relation, errors[nearest])
    if not cells:
        return
    gaps = "; ".join(f"{name} {_distances(gap)}" for name, gap in errors.items())
    worst = ", ".join(_gap_in_words(relation, errors[nearest], cell) for cell in cells)
    yield audit_row(
        paper,
        cells,
        check="poses",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{relation.joints.label} leads through {relation.dh.label} to points that lie off "
            f"those of {relation.positions.label}, in mm, at "
            f"{', '.join(relation.positions.row_names)}: {gaps}. In the "
            f"{nearest} convention, beyond rounding: {worst}; the rounding of "
            f"{relation.joints.label} moves the tool by {_mm(_joint_allowance(relation))} mm at "
            f"most. {_closing(relation, nearest)}"
        ),
        condition=f"{relation.dh.label} is exact, and no joint angle has "
        f"{'another' if relation.offsets else 'an'} offset",
    )


def _dh(relation: PrintedPoses) -> Array:
    columns = (relation.a, relation.alpha, relation.d)
    return np.array([relation.dh.column(name) for name in columns]).T


def _errors(relation: PrintedPoses, dh: Array, convention: Convention) -> Array:
    """Return computed less printed positions, shape (waypoints, 3), in m."""
    positions = np.array([relation.positions.column(axis) for axis in "xyz"]).T
    offsets = np.array([offset.si for offset in relation.offsets] or 0.0)
    reached = [
        forward_kinematics(dh, relation.joints.column(waypoint) + offsets, convention)[:3, 3]
        for waypoint in relation.positions.row_names
    ]
    return np.asarray(np.array(reached) - positions)


def _size(errors: Array) -> float:
    return float(np.sum(errors**2))


def _joint_allowance(relation: PrintedPoses) -> float:
    """Return how far the tool can move within the print of the joint angles, in m.

    Turning joint j moves the tool by at most the angle times the length of all links from j on.
    """
    dh = _dh(relation)
    lengths = np.abs(dh[:, 0]) + np.abs(dh[:, 2])
    reach = np.cumsum(lengths[::-1])[::-1]
    return max(
        sum(
            _last_digit(relation.joints, joint, waypoint) * float(lever)
            for joint, lever in zip(relation.joints.row_names, reach, strict=True)
        )
        for waypoint in relation.joints.column_names
    )


def _last_digit(table: PublishedTable, row: str, column: str) -> float:
    """Return one unit of the last printed digit in SI; a bare 0 has that of its column."""
    printed = table[row, column]
    others = [table[name, column] for name in table.row_names]
    kin = [other for other in others if other.value != 0] if printed.text == "0" else [printed]
    return max(float(unit(each)) * UNITS[each.unit] for each in kin or [printed])


def _beyond_rounding(relation: PrintedPoses, errors: Array) -> list[TableCell]:
    """Return the cells that rounding of angles and positions cannot bring to the computed point."""
    allowed = _joint_allowance(relation)
    found = []
    for waypoint, gaps in zip(relation.positions.row_names, errors, strict=True):
        for axis, gap in zip("xyz", gaps, strict=True):
            printed = relation.positions[waypoint, axis]
            around = span(printed)
            reached = printed.value + float(gap) / UNITS[printed.unit]
            slack = allowed / UNITS[printed.unit]
            if not float(around.low) - slack <= reached <= float(around.high) + slack:
                found.append(TableCell(table=relation.positions, row=waypoint, column=axis))
    return found


def _closing(relation: PrintedPoses, convention: Convention) -> str:
    """Say which change of one constant of the D-H table brings the points nearest."""
    changes = []
    for place, value, words in _changes(relation, convention):
        dh = _dh(relation)
        dh[place] = value
        changes.append(_Change(words=words, errors=_errors(relation, dh, convention)))
    best = min(changes, key=lambda change: _size(change.errors))
    # two parallel links are told apart by no waypoint, so all that do as well are named
    ties = [each for each in changes if np.allclose(each.errors, best.errors, atol=1e-9)]
    left = _beyond_rounding(relation, best.errors)
    verdict = (
        f"beyond rounding would remain {', '.join(cell.where for cell in left)}"
        if left
        else "every coordinate would then agree within its print"
    )
    return (
        f"Of all changes of one constant of {relation.dh.label}, "
        f"{' or '.join(each.words for each in ties)} brings the points nearest: "
        f"{_distances(best.errors)} mm; {verdict}"
    )


def _changes(relation: PrintedPoses, convention: Convention) -> Iterator[tuple[Place, float, str]]:
    """Yield place and value of the best length, rounded as it is printed, and all right angles."""
    for row, joint in enumerate(relation.dh.row_names):
        for column, name in ((0, relation.a), (2, relation.d)):
            printed = relation.dh[joint, name]
            step = _last_digit(relation.dh, joint, name)
            length = round(_best_length(relation, convention, (row, column)) / step) * step
            words = (
                f"{name} of joint {joint} = {length / UNITS[printed.unit]:.10g} instead of "
                f"{printed.text} {printed.unit}"
            )
            yield (row, column), length, words
        for angle in RIGHT_ANGLES:
            printed = relation.dh[joint, relation.alpha]
            words = f"{relation.alpha} of joint {joint} = {angle:.4f} instead of {printed.text} rad"
            yield (row, 1), angle, words


def _best_length(relation: PrintedPoses, convention: Convention, place: Place) -> float:
    """Return the length at `place` that brings the points nearest, in m.

    Positions are linear in every length, so one difference gives the least-squares solution.
    """
    dh = _dh(relation)
    before = _errors(relation, dh, convention)
    longer = dh.copy()
    longer[place] += 1.0
    slope = _errors(relation, longer, convention) - before
    steepness = float(np.sum(slope**2))
    if steepness < np.finfo(np.float64).eps:  # this length moves no point
        return float(dh[place])
    return float(dh[place] - np.sum(slope * before) / steepness)


def _gap_in_words(relation: PrintedPoses, errors: Array, cell: TableCell) -> str:
    waypoint = relation.positions.row_names.index(cell.row)
    gap = float(errors[waypoint, "xyz".index(cell.column)])
    return f"{cell.column} of {cell.row} off by {_mm(gap)} mm (printed {cell.printed.text})"


def _distances(errors: Array) -> str:
    return ", ".join(_mm(float(length)) for length in np.linalg.norm(errors, axis=1))


def _mm(metres: float) -> str:
    return f"{1000 * metres:.1f}" if abs(metres) < 0.1 else f"{1000 * metres:.0f}"
