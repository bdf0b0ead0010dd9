"""Angle, velocity and acceleration of every joint over time, with the limits."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.model.evidence import Evidence
from repro.model.figures import Motion
from repro.report.drawings.style import CURVE_POINTS, Plot, Rows, line_style, name_left_axis, panels
from repro.robotics import MinimumTime, peak
from repro.robotics.rest_to_rest import motion

Vector = NDArray[np.float64]
QUANTITIES = ("angle", "velocity", "acceleration", "jerk")
UNITS = ("rad", "rad/s", "rad/s²", "rad/s³")
Sample = Callable[[int], tuple[Vector, Vector]]
"""From the order of a derivative to times (n,) and its values (n, joints)."""
CERTIFIED = "certified optimum"
SET = "durations as set"


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """One motion to draw: its name and the duration of each segment in s."""

    name: str
    durations: Vector

    @property
    def total(self) -> float:
        """Time of the whole motion in s."""
        return float(self.durations.sum())


def motion_plot(figure: Motion, evidence: Evidence) -> Plot:
    """Return the drawing: a column per algorithm and one of the optimum, or one of set times."""
    problem = figure.problem
    courses, missing = _courses(figure, evidence)
    derivatives = _derivatives(problem)
    legend = [
        Line2D([], [], label=f"joint {joint + 1}", **line_style(joint))
        for joint in range(len(problem.velocity))
    ]
    canvas, grid = panels(
        len(derivatives),
        len(courses),
        height=1.45,
        legend=legend,
        title=0.44,
    )
    for derivative, row in zip(derivatives, grid, strict=True):
        for axes, course in zip(row, courses, strict=True):
            _draw_course(axes, problem, course, derivative)
        _draw_limits(row, problem, courses, derivative)
        name_left_axis(row[0], f"{QUANTITIES[derivative]}\n[{UNITS[derivative]}]")
    for axes, course in zip(grid[0], courses, strict=True):
        axes.set_title(f"{course.name}\n{_short(course.total)} s")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return Plot(
        canvas=canvas,
        description=_description(problem, courses, missing),
        rows=_rows(problem, courses),
    )


def _courses(figure: Motion, evidence: Evidence) -> tuple[list[Course], list[str]]:
    """Return the motions that can be drawn, and the algorithms of which no run is there."""
    if figure.durations is not None:
        return [Course(name=SET, durations=np.array(figure.durations))], []
    problems = evidence.experiment(figure.experiment).problems
    name = next(name for name, problem in problems.items() if problem == figure.problem)
    courses, missing = [], []
    for algorithm in figure.algorithms:
        cell = (figure.experiment, name, algorithm)
        if cell in evidence.runs:
            each = [
                evidence.values(cell, f"duration {k + 1}")[0].mean()
                for k in range(figure.problem.segments)
            ]
            courses.append(Course(name=algorithm, durations=np.array(each)))
        else:
            missing.append(algorithm)
    return [*courses, Course(name=CERTIFIED, durations=figure.problem.shortest())], missing


def _derivatives(problem: MinimumTime) -> range:
    """Return which derivatives of the angles are drawn: the jerk only where it is limited."""
    return range(4 if problem.jerk else 3)


def _sampled(problem: MinimumTime, course: Course, derivative: int) -> tuple[Vector, Vector]:
    samples = max(9, CURVE_POINTS // problem.segments)
    return motion(problem, course.durations, derivative=derivative, samples=samples)


def _draw_course(axes: Axes, problem: MinimumTime, course: Course, derivative: int) -> None:
    times, values = _sampled(problem, course, derivative)
    for joint, curve in enumerate(values.T):
        axes.plot(times, curve, **line_style(joint))
    for end in np.cumsum(course.durations):
        axes.axvline(end, color="#000000", linewidth=0.8, alpha=0.6)
    axes.set_xlim(left=0)
    axes.locator_params(nbins=5)


def _draw_limits(
    row: Sequence[Axes], problem: MinimumTime, courses: Sequence[Course], derivative: int
) -> None:
    """Draw the limits on a derivative: in the colour of the joint that has it alone."""
    if derivative == 0:
        return
    limits = problem.limits[derivative - 1]
    different = sorted({limit for limit in limits if np.isfinite(limit)})
    reached = [peak(problem, tuple(course.durations), derivative) for course in courses]
    reach = 1.36 * max(*different, *reached)
    for axes in row:
        axes.set_ylim(-reach, reach)
        for limit in different:
            joints = np.flatnonzero(limits == limit)
            colour = line_style(int(joints[0]))["color"] if len(joints) == 1 else "#000000"
            for sign in (-1, 1):
                axes.axhline(sign * limit, color=colour, linewidth=1, linestyle=(0, (2, 2)))
        if different:
            for sign in (-1, 1):
                axes.axhspan(sign * different[-1], sign * reach, color="#000000", alpha=0.1, lw=0)
    if different:
        row[0].text(
            0.03, 0.985, _limits_text(problem, derivative), transform=row[0].transAxes, va="top"
        )


def _limits_text(problem: MinimumTime, derivative: int) -> str:
    limits = problem.limits[derivative - 1]
    low, high = _short(limits.min()), _short(limits.max())
    return f"limit {low if low == high else f'{low} to {high}'}"


def _short(value: float) -> str:
    return f"{value:.4g}"


def _description(problem: MinimumTime, courses: Sequence[Course], missing: Sequence[str]) -> str:
    derivatives = _derivatives(problem)[1:]
    told = "; ".join(
        f"{course.name}: {' + '.join(_short(d) for d in course.durations)} = "
        f"{_short(course.total)} s, with at most "
        + ", ".join(
            f"{_short(peak(problem, tuple(course.durations), m))} {UNITS[m]}" for m in derivatives
        )
        for course in courses
    )
    limits = ", ".join(
        f"{QUANTITIES[m]} {_limits_text(problem, m)} {UNITS[m]}" for m in derivatives
    )
    *first, last = (QUANTITIES[m] for m in _derivatives(problem))
    text = (
        f"{', '.join(first).capitalize()} and {last} of {len(problem.velocity)} joints over time, "
        f"at rest at every waypoint ({limits}). {told}."
    )
    return text + (f" No runs yet of {', '.join(missing)}." if missing else "")


def _rows(problem: MinimumTime, courses: Sequence[Course]) -> Rows:
    joints = range(1, len(problem.velocity) + 1)
    sampled = [(course.name, partial(_sampled, problem, course)) for course in courses]
    return sample_rows("motion", sampled, derivatives=_derivatives(problem), joints=joints)


def sample_rows(
    what: str,
    sampled: Iterable[tuple[str, Sample]],
    *,
    derivatives: Sequence[int],
    joints: Sequence[int],
) -> Rows:
    """Return a row per sample: which motion, the time, every derivative of every joint."""
    named = (f"{QUANTITIES[m]} of joint {k} [{UNITS[m]}]" for m in derivatives for k in joints)
    rows: list[tuple[str, ...]] = [(what, "time [s]", *named)]
    for name, sample in sampled:
        times, _ = sample(0)
        values = np.hstack([sample(m)[1] for m in derivatives])
        rows += [
            (name, f"{time:.6g}", *(f"{value:.6g}" for value in line))
            for time, line in zip(times, values, strict=True)
        ]
    return tuple(rows)
