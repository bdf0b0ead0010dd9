"""Angle and its derivatives over time, along a B-spline in time and angle."""

import math
from collections.abc import Sequence
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


ACROSS = 3  # panels side by side


def spline_plot(figure: SplineMotion, evidence: Evidence) -> Plot:
    """Return the drawing of the motions: a panel for each joint and derivative, all in each."""
    courses, missing = _courses(figure, evidence)
    alone = len(figure.joints) == 1
    across = min(ACROSS, len(figure.joints))
    deep = math.ceil(len(figure.joints) / across)
    canvas, grid = panels(
        len(figure.derivatives) * deep,
        across,
        height=2.2 if alone else 0.9,
        legend=[
            Line2D([], [], label=f"{course.name}, {course.total:.4g} s", **line_style(k))
            for k, course in enumerate(courses)
        ],
        title=0.1 if alone else 0.28,
        gaps=(0.2, 0.36),
    )
    for k, derivative in enumerate(figure.derivatives):
        rows = grid[k * deep : (k + 1) * deep]
        places = [axes for row in rows for axes in row]
        for joint, axes in zip(figure.joints, places, strict=False):
            _draw_joint(axes, figure, courses, joint, derivative)
        for axes in places[len(figure.joints) :]:
            axes.remove()
        for row in rows:
            name_left_axis(row[0], f"{QUANTITIES[derivative]}\n[{UNITS[derivative]}]")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return Plot(
        canvas=canvas,
        description=_description(figure, courses, missing),
        frame=_frame(figure, courses),
    )


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


def _draw_joint(
    axes: Axes, figure: SplineMotion, courses: Sequence[Course], joint: int, derivative: int
) -> None:
    """Draw a joint in all motions, a dot at each node, and the limits on it."""
    for k, course in enumerate(courses):
        times, values = _sampled(figure, course, derivative)
        own = values[:, figure.joints.index(joint)]
        axes.plot(times, own, **line_style(k))
        nodes = np.concatenate([[0.0], np.cumsum(course.durations)])
        marks = np.searchsorted(times, nodes - 1e-9).clip(max=len(times) - 1)
        axes.plot(times[marks], own[marks], ".", color=line_style(k)["color"], markersize=4)
    if derivative in LIMITED:
        limit = figure.problem.limits[derivative - 1][joint - 1]
        for sign in (-1, 1):
            axes.axhline(sign * limit, color="#000000", linewidth=1, linestyle=(0, (2, 2)))
    if len(figure.joints) > 1:
        axes.set_title(f"joint {joint}", fontsize=10, pad=2)
    axes.set_xlim(left=0)
    axes.locator_params(axis="x", nbins=5)
    axes.locator_params(axis="y", nbins=3 if len(figure.joints) > 1 else 5)


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
