"""Angle and its derivatives over time, along a B-spline in time and angle."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.errors import NotProvedError
from repro.model.evidence import Evidence
from repro.model.figures import SplineMotion
from repro.report.drawings.motion import (
    CERTIFIED,
    QUANTITIES,
    UNITS,
    Course,
    problem_name,
    sample_frame,
)
from repro.report.drawings.style import CURVE_POINTS, Plot, line_style, name_left_axis, panels
from repro.report.words import number
from repro.robotics.proofs.spline_minimum import prove
from repro.robotics.spline_motion import motion

Vector = NDArray[np.float64]
PRINTED = "printed durations"
LIMITED = (1, 2)  # derivatives that have limits: velocity and acceleration


@dataclass(frozen=True, slots=True, kw_only=True)
class SplineCurve:
    """One joint of one motion, and how it is drawn."""

    course: Course
    joint: int
    label: str
    style: int


def spline_plot(figure: SplineMotion, evidence: Evidence) -> Plot:
    """Return the drawing of the motions: of several joints side by side, of one joint together."""
    courses, missing = _courses(figure, evidence)
    columns = _columns(figure, courses)
    canvas, grid = panels(
        len(figure.derivatives),
        len(columns),
        height=1.45 if len(columns) > 1 else 2.2,
        legend=[
            Line2D([], [], label=curve.label, **line_style(curve.style)) for curve in columns[0]
        ],
        title=0.44 if len(columns) > 1 else 0.1,
    )
    for derivative, row in zip(figure.derivatives, grid, strict=True):
        for axes, curves in zip(row, columns, strict=True):
            _draw_curves(axes, figure, curves, derivative)
        if derivative in LIMITED:
            _draw_limits(row, figure, derivative)
        name_left_axis(row[0], f"{QUANTITIES[derivative]}\n[{UNITS[derivative]}]")
    for axes, course in zip(grid[0], courses if len(columns) > 1 else (), strict=False):
        axes.set_title(f"{course.name}\n{course.total:.4g} s")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return Plot(
        canvas=canvas,
        description=_description(figure, courses, missing),
        frame=_frame(figure, courses),
    )


def _columns(figure: SplineMotion, courses: Sequence[Course]) -> list[list[SplineCurve]]:
    """Return the curves of each column: all motions in one where a single joint is drawn."""
    if len(figure.joints) == 1:
        joint = figure.joints[0]
        return [
            [
                SplineCurve(
                    course=course,
                    joint=joint,
                    label=f"{course.name}, {course.total:.4g} s",
                    style=k,
                )
                for k, course in enumerate(courses)
            ]
        ]
    return [
        [
            SplineCurve(course=course, joint=joint, label=f"joint {joint}", style=joint - 1)
            for joint in figure.joints
        ]
        for course in courses
    ]


def _courses(figure: SplineMotion, evidence: Evidence) -> tuple[list[Course], list[str]]:
    """Return the motions that can be drawn, and the algorithms of which no run is there."""
    experiment = evidence.experiment(figure.experiment)
    name = problem_name(figure.label, figure.problem, experiment)
    courses = [Course(name=PRINTED, durations=np.array(figure.durations))]
    missing = []
    for algorithm in figure.algorithms:
        cell = (figure.experiment, name, algorithm)
        if cell in evidence.runs:
            points = figure.problem.obeying(evidence.runs[cell].points[0])
            shortest = points[np.argmin(points.sum(axis=-1))]
            courses.append(Course(name=f"{algorithm}, re-run", durations=shortest))
        else:
            missing.append(algorithm)
    try:
        proved = np.array(prove(figure.problem).durations, dtype=np.float64)
    except NotProvedError:
        return courses, missing
    return [*courses, Course(name=CERTIFIED, durations=proved)], missing


def _sampled(figure: SplineMotion, course: Course, derivative: int) -> tuple[Vector, Vector]:
    """Return times (n,) and the values of the joints that are drawn, in their order."""
    samples = max(9, CURVE_POINTS // figure.problem.segments)
    times, values = motion(figure.problem, course.durations, derivative=derivative, samples=samples)
    return times, values[:, [joint - 1 for joint in figure.joints]]


def _draw_curves(
    axes: Axes, figure: SplineMotion, curves: Sequence[SplineCurve], derivative: int
) -> None:
    for curve in curves:
        times, values = _sampled(figure, curve.course, derivative)
        axes.plot(times, values[:, figure.joints.index(curve.joint)], **line_style(curve.style))
    if len(figure.joints) > 1:
        for end in np.cumsum(curves[0].course.durations):
            axes.axvline(end, color="#000000", linewidth=0.8, alpha=0.6)
    axes.set_xlim(left=0)
    axes.locator_params(nbins=5)


def _draw_limits(row: Sequence[Axes], figure: SplineMotion, derivative: int) -> None:
    """Draw the limits on a derivative: in the colour of the joint that has it alone."""
    limits = figure.problem.limits[derivative - 1]
    for limit in sorted({limits[joint - 1] for joint in figure.joints}):
        joints = [joint for joint in figure.joints if limits[joint - 1] == limit]
        colour = line_style(joints[0] - 1)["color"] if len(joints) == 1 else "#000000"
        for axes in row:
            for sign in (-1, 1):
                axes.axhline(sign * limit, color=colour, linewidth=1, linestyle=(0, (2, 2)))


def _description(figure: SplineMotion, courses: Sequence[Course], missing: Sequence[str]) -> str:
    *first, last = (QUANTITIES[derivative] for derivative in figure.derivatives)
    named = f"{', '.join(first)} and {last}" if first else last
    joints = ", ".join(map(str, figure.joints))
    told = "; ".join(
        f"{course.name}: {' + '.join(number(float(d)) for d in course.durations)} = "
        f"{number(course.total)} s, {_peaks(figure, course)}"
        for course in courses
    )
    text = (
        f"{named.capitalize()} of joint{'s' * (len(figure.joints) > 1)} {joints} over time, "
        f"through {figure.problem.segments + 1} nodes. {told}."
    )
    return text + (f" No runs yet of {', '.join(missing)}." if missing else "")


def _peaks(figure: SplineMotion, course: Course) -> str:
    fast, hard = 100.0 * figure.problem.peak_shares(course.durations)
    ends = abs(motion(figure.problem, course.durations, derivative=1, samples=2)[1][[0, -1]])
    return (
        f"with at most {fast:.3g} % of a velocity limit and {hard:.3g} % of an acceleration limit, "
        f"starting at {number(float(ends[0].max()))} and ending at "
        f"{number(float(ends[1].max()))} {UNITS[1]} (fastest joint)"
    )


def _frame(figure: SplineMotion, courses: Sequence[Course]) -> pd.DataFrame:
    sampled = [(course.name, partial(_sampled, figure, course)) for course in courses]
    return sample_frame("motion", sampled, derivatives=figure.derivatives, joints=figure.joints)
