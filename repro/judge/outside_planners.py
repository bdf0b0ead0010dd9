"""Outside references for minimum times: other people's planners, as references and not as proofs.

ruckig (L. Berscheid, T. Kröger, Robotics: Science and Systems 2021) plans each segment from rest
to rest with any curve; toppra (H. Pham, Q.-C. Pham, IEEE Transactions on Robotics 34(3) (2018),
doi:10.1109/TRO.2018.2819195) runs through the waypoints along a fixed spline without stopping, and
its time depends on its grid. Both come with the extra `references`.
"""

import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from repro.model.paper import Paper
from repro.robotics import MinimumTime

GRID = 1000  # points of toppra's grid; with few points it can exceed a velocity limit


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
    """Return what each planner says of each problem whose segments rest at both ends."""
    return tuple(
        _asked(paper.key, f"{experiment.name}/{name}", problem, planner)
        for paper in papers
        for experiment in paper.experiments
        for name, problem in experiment.problems.items()
        if isinstance(problem, MinimumTime)
        for planner in (ruckig_time, toppra_time)
    )


def _asked(
    paper: str, name: str, problem: MinimumTime, planner: Callable[[MinimumTime], float]
) -> OutsideReference:
    time, skipped = None, ""
    try:
        time = planner(problem)
    except ImportError as error:
        skipped = f"{error.name} is not installed: pip install 'repro-whales[references]'"
    return OutsideReference(
        paper=paper,
        problem=name,
        planner=planner.__name__.removesuffix("_time"),
        what=(planner.__doc__ or "").partition(".")[0],
        time=time,
        skipped=skipped,
    )


def ruckig_time(problem: MinimumTime) -> float:
    """Time from rest to rest at every waypoint along any curve, in s.

    The least that the limits allow, so a lower bound on the same motion along any fixed curve.
    """
    from ruckig import InputParameter, Ruckig, Trajectory  # noqa: PLC0415 (an extra)

    joints = len(problem.velocity)
    velocity, acceleration, jerk = problem.limits.tolist()
    total = 0.0
    for k in range(problem.segments):
        wanted = InputParameter(joints)
        wanted.current_position = list(problem.waypoints[k])
        wanted.target_position = list(problem.waypoints[k + 1])
        wanted.max_velocity = velocity
        wanted.max_acceleration = acceleration
        wanted.max_jerk = jerk
        found = Trajectory(joints)
        Ruckig(joints).calculate(wanted, found)
        total += float(found.duration)
    return total


def toppra_time(problem: MinimumTime) -> float:
    """Time along the cubic spline through the waypoints without stopping, jerk free, in s.

    It may be less or more than the minimum with rests: it follows another curve.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its docstrings hold invalid escape sequences
        from toppra import SplineInterpolator, algorithm, constraint  # noqa: PLC0415 (an extra)

    points = np.array(problem.waypoints)
    velocity, acceleration, _ = problem.limits
    path = SplineInterpolator(np.linspace(0.0, 1.0, len(points)), points)
    limits = [
        constraint.JointVelocityConstraint(np.stack([-velocity, velocity], axis=1)),
        constraint.JointAccelerationConstraint(np.stack([-acceleration, acceleration], axis=1)),
    ]
    grid = np.linspace(0.0, 1.0, GRID)
    planner = algorithm.TOPPRA(limits, path, gridpoints=grid)
    return float(planner.compute_trajectory(0.0, 0.0).duration)
