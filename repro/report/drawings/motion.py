"""Angle, velocity and acceleration of every joint over time, with the limits."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.evidence import Cell, Evidence
from repro.model.experiment import Experiment
from repro.model.figures import Motion
from repro.report.drawings.style import CURVE_POINTS, Plot, Rows, line_style, name_left_axis, panels
from repro.robotics import MinimumTime
from repro.robotics.own_motion import increasing
from repro.robotics.shown_motion import Moving, ShowsMotion, highest, lasting, moved, shortest

Vector = NDArray[np.float64]
QUANTITIES = ("angle", "velocity", "acceleration", "jerk")
UNITS = ("rad", "rad/s", "rad/s²", "rad/s³")
Sample = Callable[[int], tuple[Vector, Vector]]
"""From the order of a derivative to times (n,) and its values (n, joints)."""
CERTIFIED = "certified optimum"
SET = "durations as set"


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """One motion to draw: its name and the duration of each segment in s.

    `point` is what a search found where that is something else than durations.
    """

    name: str
    durations: Vector
    point: Vector | None = None

    @property
    def total(self) -> float:
        """Time of the whole motion in s."""
        return float(self.durations.sum())


def motion_plot(figure: Motion, evidence: Evidence) -> Plot | None:
    """Return the drawing: a column per algorithm and one of the optimum, or one of set times.

    None where no run is there yet and nothing is proved.
    """
    problem = figure.problem
    courses, missing = _courses(figure, evidence)
    if not courses:
        return None
    derivatives = _derivatives(problem)
    legend = [
        Line2D([], [], label=f"joint {joint + 1}", **line_style(joint))
        for joint in range(problem.limits.shape[1])
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
    problem = figure.problem
    if figure.durations is not None:
        return [_course(SET, problem, np.array(figure.durations))], []
    name = problem_name(figure.label, problem, evidence.experiment(figure.experiment))
    courses, missing = [], []
    for algorithm in figure.algorithms:
        cell = (figure.experiment, name, algorithm)
        if cell in evidence.runs:
            courses.append(_course(algorithm, problem, _found(problem, evidence, cell)))
        else:
            missing.append(algorithm)
    optimum = shortest(problem)
    proved = [] if optimum is None else [_course(CERTIFIED, problem, optimum)]
    return [*courses, *proved], missing


def problem_name(label: str, problem: object, of: Experiment) -> str:
    """Return by which name the experiment has the problem; DeclarationError where it has not."""
    for name, own in of.problems.items():
        # what others wrote may hold arrays, of which == makes no truth
        if own is problem or (not isinstance(problem, ShowsMotion) and own == problem):
            return name
    message = f"{label}: its problem is none of {of.name}, which has {', '.join(of.problems)}"
    raise DeclarationError(message)


def _course(name: str, problem: Moving, point: Vector) -> Course:
    return Course(name=name, durations=lasting(problem, point), point=point)


def _found(problem: Moving, evidence: Evidence, cell: Cell) -> Vector:
    """Return what the runs of the first repeat reach on average, or the best of them."""
    if isinstance(problem, MinimumTime):
        names = (f"duration {k + 1}" for k in range(problem.segments))
        return np.array([evidence.values(cell, name)[0].mean() for name in names])
    runs = evidence.runs[cell]
    return np.asarray(runs.points[0][runs.costs[0].argmin()])


def _point(course: Course) -> Vector:
    return course.durations if course.point is None else course.point


def _derivatives(problem: Moving) -> range:
    """Return which derivatives of the angles are drawn: the jerk only where it is limited."""
    return range(4 if np.isfinite(problem.limits[2]).any() else 3)


def _sampled(problem: Moving, course: Course, derivative: int) -> tuple[Vector, Vector]:
    samples = max(9, CURVE_POINTS // len(course.durations))
    return moved(problem, _point(course), derivative=derivative, samples=samples)


def _draw_course(axes: Axes, problem: Moving, course: Course, derivative: int) -> None:
    times, values = _sampled(problem, course, derivative)
    for joint, curve in enumerate(values.T):
        axes.plot(times, curve, **line_style(joint))
    for end in np.cumsum(course.durations):
        axes.axvline(end, color="#000000", linewidth=0.8, alpha=0.6)
    axes.set_xlim(left=0)
    axes.locator_params(nbins=5)


def _draw_limits(
    row: Sequence[Axes], problem: Moving, courses: Sequence[Course], derivative: int
) -> None:
    """Draw the limits on a derivative: in the colour of the joint that has it alone."""
    if derivative == 0:
        return
    limits = problem.limits[derivative - 1]
    different = sorted({limit for limit in limits if np.isfinite(limit)})
    reached = [highest(problem, _point(course), derivative) for course in courses]
    reach = 1.36 * (max([*different, *reached], default=0.0) or 1.0)
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


def _limits_text(problem: Moving, derivative: int) -> str:
    limits = problem.limits[derivative - 1]
    low, high = _short(limits.min()), _short(limits.max())
    return f"limit {low if low == high else f'{low} to {high}'}"


def _short(value: float) -> str:
    return f"{value:.4g}"


def _description(problem: Moving, courses: Sequence[Course], missing: Sequence[str]) -> str:
    derivatives = _derivatives(problem)[1:]
    told = "; ".join(
        f"{course.name}: {' + '.join(_short(d) for d in course.durations)} = "
        f"{_short(course.total)} s, with at most "
        + ", ".join(
            f"{_short(highest(problem, _point(course), m))} {UNITS[m]}" for m in derivatives
        )
        for course in courses
    )
    limits = ", ".join(
        f"{QUANTITIES[m]} {_limits_text(problem, m)} {UNITS[m]}" for m in derivatives
    )
    *first, last = (QUANTITIES[m] for m in _derivatives(problem))
    text = (
        f"{', '.join(first).capitalize()} and {last} of {problem.limits.shape[1]} joints over time"
        f"{', at rest at every waypoint' if isinstance(problem, MinimumTime) else ''} "
        f"({limits}). {told}."
    )
    return text + (f" No runs yet of {', '.join(missing)}." if missing else "")


def _rows(problem: Moving, courses: Sequence[Course]) -> Rows:
    joints = range(1, problem.limits.shape[1] + 1)
    sampled = [(course.name, partial(_sampled, problem, course)) for course in courses]
    return sample_rows("motion", sampled, derivatives=_derivatives(problem), joints=joints)


def sample_rows(
    what: str,
    sampled: Iterable[tuple[str, Sample]],
    *,
    derivatives: Sequence[int],
    joints: Sequence[int],
) -> Rows:
    """Return a row per sample: which motion, the time, every derivative of every joint.

    At an inner waypoint, where one segment ends and the next begins, stands the latter alone: a
    controller refuses an instant that comes twice.
    """
    named = (f"{QUANTITIES[m]} of joint {k} [{UNITS[m]}]" for m in derivatives for k in joints)
    rows: list[tuple[str, ...]] = [(what, "time [s]", *named)]
    for name, sample in sampled:
        times, _ = sample(0)
        values = np.hstack([sample(m)[1] for m in derivatives])
        rows += [
            (name, f"{times[k]:.12g}", *(f"{value:.6g}" for value in values[k]))
            for k in increasing(times).tolist()
        ]
    return tuple(rows)
