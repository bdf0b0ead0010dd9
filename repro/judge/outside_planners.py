"""Outside references for minimum times: other people's planners, as references and not as proofs.

ruckig (L. Berscheid, T. Kröger, Robotics: Science and Systems 2021) plans each segment from rest
to rest with any curve; toppra (H. Pham, Q.-C. Pham, IEEE Transactions on Robotics 34(3) (2018),
doi:10.1109/TRO.2018.2819195) runs through the waypoints along a fixed spline without stopping, and
its time depends on its grid. Both come with the extra `references`. What they answer is looked at
before it is shown: their own words for failure, and every limit along the whole motion.
"""

import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from repro.errors import ReproError
from repro.model.paper import Paper
from repro.robotics import MinimumTime, MinimumTimeSpline
from repro.robotics.along_path import slowing
from repro.robotics.bsplines import spans

Vector = NDArray[np.float64]
Problem = TypeVar("Problem")
GRID = 1000  # points of toppra's grid; with few points it can exceed a velocity limit
LINE = 120  # characters of what a planner says of its failure
ROUNDING = 1e-6  # share of a limit that a planner's own arithmetic may lose


class NoAnswerError(ReproError):
    """A planner gave no motion, or one that breaks a limit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OutsideReference:
    """A time in s that another planner gives, or why it gave none."""

    paper: str
    problem: str
    planner: str
    what: str
    time: float | None
    skipped: str = ""


def outside_references(papers: Iterable[Paper]) -> tuple[OutsideReference, ...]:
    """Return what each planner says of each motion from rest to rest, or along a spline."""
    return tuple(
        reference
        for paper in papers
        for experiment in paper.experiments
        for name, problem in experiment.problems.items()
        if isinstance(problem, MinimumTime | MinimumTimeSpline)
        for reference in references_of(problem, paper=paper.key, name=f"{experiment.name}/{name}")
    )


def references_of(
    problem: MinimumTime | MinimumTimeSpline, *, paper: str, name: str
) -> tuple[OutsideReference, ...]:
    """Return what each planner says of one problem; of a spline toppra alone, on its path."""
    if isinstance(problem, MinimumTimeSpline):
        return (_asked(paper, name, problem, toppra_path_time),)
    return tuple(_asked(paper, name, problem, planner) for planner in (ruckig_time, toppra_time))


def not_asked(kind: str, *, paper: str, name: str) -> tuple[OutsideReference, ...]:
    """Return that no planner is asked of a motion of some other kind."""
    return tuple(
        OutsideReference(
            paper=paper,
            problem=name,
            planner=planner,
            what="",
            time=None,
            skipped=f"not asked of {kind}",
        )
        for planner in ("ruckig", "toppra")
    )


def _asked(
    paper: str, name: str, problem: Problem, planner: Callable[[Problem], float]
) -> OutsideReference:
    time, skipped = None, ""
    try:
        time = planner(problem)
    except ImportError as error:
        skipped = f"{error.name} is not installed: pip install 'repro-whales[references]'"
    except NoAnswerError as error:
        skipped = str(error)
    except Exception as error:  # noqa: BLE001 (whatever a planner raises of its own)
        skipped = f"it raises {type(error).__name__}: {_line(error)}"
    return OutsideReference(
        paper=paper,
        problem=name,
        planner=planner.__name__.partition("_")[0],
        what=(planner.__doc__ or "").partition(".")[0],
        time=time,
        skipped=skipped,
    )


def _line(error: Exception) -> str:
    return " ".join(str(error).split())[:LINE]


def ruckig_time(problem: MinimumTime) -> float:
    """Time from rest to rest at every waypoint along any curve, in s.

    The least that the limits allow, so a lower bound on the same motion along any fixed curve.
    Raises NoAnswerError where ruckig has none, or one that breaks a limit.
    """
    return float(sum(_ruckig_segment(problem, k) for k in range(problem.segments)))


def _ruckig_segment(problem: MinimumTime, segment: int) -> float:
    from ruckig import InputParameter, Result, Ruckig, Trajectory  # noqa: PLC0415 (an extra)

    joints = len(problem.velocity)
    wanted = InputParameter(joints)
    wanted.current_position = list(problem.waypoints[segment])
    wanted.target_position = list(problem.waypoints[segment + 1])
    wanted.max_velocity, wanted.max_acceleration, wanted.max_jerk = problem.limits.tolist()
    found = Trajectory(joints)
    place = f"ruckig has no motion for segment {segment + 1}"
    try:
        result = Ruckig(joints).calculate(wanted, found)
    except Exception as error:  # noqa: BLE001 (its own kind of error is no kind of ours)
        message = f"{place}: {_line(error)}"
        raise NoAnswerError(message) from None
    if result not in (Result.Working, Result.Finished):
        message = f"{place}: {result!s}"
        raise NoAnswerError(message)
    for joint, profile in enumerate(found.profiles[0]):
        _check_profile(problem, segment, joint, profile)
    return float(found.duration)


def _check_profile(problem: MinimumTime, segment: int, joint: int, profile: Any) -> None:  # noqa: ANN401
    """Raise NoAnswerError unless phases of constant jerk obey and lead to the waypoint."""
    jerk, a, v = (np.array(getattr(profile, name)) for name in "jav")
    phases = np.array(profile.t)
    # the velocity turns where the acceleration passes 0 inside a phase
    turns = np.where(a[:-1] * a[1:] < 0.0, v[:-1] - a[:-1] ** 2 / (2.0 * jerk + (jerk == 0.0)), 0.0)
    speeds = np.concatenate([v, turns])
    reached = [np.abs(speeds).max(), np.abs(a).max(), np.abs(jerk[phases > 0.0]).max(initial=0.0)]
    start, end = problem.waypoints[segment][joint], problem.waypoints[segment + 1][joint]
    off = abs(profile.p[-1] - end)
    if (
        off > ROUNDING * abs(end - start)
        or (reached > problem.limits[:, joint] * (1.0 + ROUNDING)).any()
    ):
        message = (
            f"ruckig's motion of joint {joint + 1} in segment {segment + 1} is none: it reaches "
            f"{reached} in velocity, acceleration and jerk and ends {off:.3g} away"
        )
        raise NoAnswerError(message)


def toppra_time(problem: MinimumTime) -> float:
    """Time along the cubic spline through the waypoints without stopping, jerk free, in s.

    It may be less or more than the minimum with rests: it follows another curve. Where toppra's
    motion breaks a limit between two points of its grid, the time is that of the motion slowed as
    a whole until it obeys. Raises NoAnswerError where toppra has none.
    """
    from scipy.interpolate import CubicSpline  # noqa: PLC0415 (slow to load)

    knots = np.linspace(0.0, 1.0, len(problem.waypoints))
    # the cubic spline that toppra itself takes: its third derivative goes through the second knot
    path = CubicSpline(knots, np.array(problem.waypoints))
    return _along(path, knots, limits=problem.limits[:2])


def toppra_path_time(problem: MinimumTimeSpline) -> float:
    """Time along the paper's own B-spline in the angles, at rest at both ends, in s.

    Any course of time along the path is allowed, but the ends are at rest, which those of the
    paper's motions need not be, so it may be less or more than their minimum. Raises NoAnswerError
    as toppra_time does.
    """
    from scipy.interpolate import PPoly  # noqa: PLC0415 (slow to load)

    coefficients = spans(problem.nodes, problem.ends)
    knots = np.arange(problem.segments + 1.0)
    path = PPoly(coefficients[:, ::-1].transpose(1, 0, 2), knots)
    return _along(path, knots, limits=problem.limits)


def _along(path: Callable[..., Vector], knots: Vector, *, limits: Vector) -> float:
    """Return toppra's time along a cubic path; limits on velocity and acceleration (2, joints)."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its docstrings hold invalid escape sequences
        from toppra import algorithm, constraint  # noqa: PLC0415 (an extra)
        from toppra.interpolator import AbstractGeometricPath  # noqa: PLC0415

    class Path(AbstractGeometricPath):  # type: ignore[misc]
        """The path in toppra's words."""

        dof = limits.shape[1]
        path_interval = knots[[0, -1]]

        def __call__(self, at: Any, order: int = 0) -> Vector:  # noqa: ANN401
            return np.asarray(path(at, order))

    velocity, acceleration = limits
    asked = [
        constraint.JointVelocityConstraint(np.stack([-velocity, velocity], axis=1)),
        constraint.JointAccelerationConstraint(np.stack([-acceleration, acceleration], axis=1)),
    ]
    grid = np.union1d(np.linspace(knots[0], knots[-1], GRID), knots)
    planner = algorithm.TOPPRA(asked, Path(), gridpoints=grid)
    along, speeds, _ = planner.compute_parameterization(0.0, 0.0)
    if along is None or speeds is None or not _moves(speeds):
        message = "toppra has no motion along the spline through these waypoints"
        raise NoAnswerError(message)
    steps = 2.0 * np.diff(grid) / (speeds[:-1] + speeds[1:])
    slope, bend = (np.asarray(path(grid, m)) for m in (1, 2))
    return float(steps.sum()) * slowing(
        grid, speeds, slope, bend, velocity=velocity, acceleration=acceleration
    )


def _moves(speeds: Vector) -> bool:
    """Return whether a path with these speeds at its grid's points is passed in finite time."""
    return bool(np.isfinite(speeds).all() and (speeds[:-1] + speeds[1:] > 0.0).all())
