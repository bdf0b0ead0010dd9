"""Angle, velocity and acceleration of every joint along polynomials, fitted or desired."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
import pandas as pd
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.model.evidence import Evidence, Runs
from repro.model.figures import JointCurves
from repro.report.drawings.motion import QUANTITIES, UNITS, sample_frame
from repro.report.drawings.style import CURVE_POINTS, Plot, line_style, name_left_axis, panels
from repro.report.words import number
from repro.robotics.polynomial_curves import derivative, values

Vector = NDArray[np.float64]
DERIVATIVES = range(3)  # angle, velocity and acceleration
DESIRED = "desired path"


@dataclass(frozen=True, slots=True, kw_only=True)
class Curves:
    """What one column shows: its name, and the coefficients of one curve per joint."""

    name: str
    coefficients: tuple[Vector, ...]


def joint_curves_plot(figure: JointCurves, evidence: Evidence) -> Plot:
    """Return the drawing: a column per algorithm that has run, and one of the desired path."""
    courses, missing = _courses(figure, evidence)
    joints = range(len(figure.paths))
    canvas, grid = panels(
        len(DERIVATIVES),
        len(courses),
        height=1.45,
        legend=[
            Line2D([], [], label=f"joint {joint + 1}", **line_style(joint)) for joint in joints
        ],
        title=0.28,
    )
    times = np.linspace(0.0, figure.paths[0].duration, CURVE_POINTS)
    for order, row in enumerate(grid):
        for axes, course in zip(row, courses, strict=True):
            for joint, curve in enumerate(_sampled(course, times, order)[1].T):
                axes.plot(times, curve, **line_style(joint))
            axes.set_xlim(0, times[-1])
            axes.locator_params(axis="x", nbins=1 + 6 // len(courses))  # labels side by side
            axes.locator_params(axis="y", nbins=5)
        name_left_axis(row[0], f"{QUANTITIES[order]}\n[{UNITS[order]}]")
    for axes, course in zip(grid[0], courses, strict=True):
        axes.set_title(course.name)
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return Plot(
        canvas=canvas,
        description=_description(figure, courses, missing),
        frame=_frame(courses, times),
    )


def _courses(figure: JointCurves, evidence: Evidence) -> tuple[list[Curves], list[str]]:
    """Return the columns, and the algorithms of which no run is there."""
    courses, missing = [], []
    for algorithm in figure.algorithms:
        problems = evidence.experiment(figure.experiment).problems
        names = [next(n for n, problem in problems.items() if problem == p) for p in figure.paths]
        cells = [(figure.experiment, name, algorithm) for name in names]
        if all(cell in evidence.runs for cell in cells):
            fitted = tuple(_middle_run(evidence.runs[cell]) for cell in cells)
            courses.append(Curves(name=algorithm, coefficients=fitted))
        else:
            missing.append(algorithm)
    desired = tuple(path.coefficients for path in figure.paths)
    return [*courses, Curves(name=DESIRED, coefficients=desired)], missing


def _middle_run(runs: Runs) -> Vector:
    """Return what the run of median cost of the first repeat found."""
    order = np.argsort(runs.costs[0], kind="stable")
    return np.asarray(runs.points[0, order[len(order) // 2]])


def _description(figure: JointCurves, courses: Sequence[Curves], missing: Sequence[str]) -> str:
    """Say what is drawn, how large its derivatives get, and how far the fits are off."""
    path = figure.paths[0]
    told = [
        f"{course.name}: at most {_peaks(course, path.duration)}{_errors(figure, course)}"
        for course in courses
    ]
    text = (
        f"Angle, velocity and acceleration of {len(figure.paths)} joints over "
        f"{number(path.duration)} s. {'; '.join(told)}."
    )
    if len(courses) > 1:
        text += " An algorithm is drawn by the run of median cost of each joint."
    return text + (f" No runs yet of {', '.join(missing)}." if missing else "")


def _errors(figure: JointCurves, course: Curves) -> str:
    if course.name == DESIRED:
        return ""
    errors = [
        number(float(path.quantity("rms error", curve)))
        for path, curve in zip(figure.paths, course.coefficients, strict=True)
    ]
    return f", root mean square errors of the joints {', '.join(errors)} rad"


def _peaks(course: Curves, duration: float) -> str:
    times = np.linspace(0.0, duration, 10 * CURVE_POINTS + 1)
    peaks = [
        max(float(np.abs(values(derivative(c, order), times)).max()) for c in course.coefficients)
        for order in (1, 2)
    ]
    return " and ".join(f"{number(p)} {unit}" for p, unit in zip(peaks, UNITS[1:3], strict=True))


def _sampled(course: Curves, times: Vector, order: int) -> tuple[Vector, Vector]:
    curves = [values(derivative(curve, order), times) for curve in course.coefficients]
    return times, np.transpose(curves)


def _frame(courses: Sequence[Curves], times: Vector) -> pd.DataFrame:
    joints = range(1, len(courses[0].coefficients) + 1)
    sampled = [(course.name, partial(_sampled, course, times)) for course in courses]
    return sample_frame("curve", sampled, derivatives=DERIVATIVES, joints=joints)
