"""Proved minima of the trajectory problems, and how far printed times lie from them."""

from dataclasses import dataclass

import numpy as np

from repro.claims import CellClaim
from repro.measures import Statistic
from repro.model import Paper
from repro.published import UNITS
from repro.robotics import MinimumTime
from repro.robotics.rest_to_rest import DERIVATIVES


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedTime:
    """A printed total time in s and its ratio to the certified minimum."""

    label: str
    time: float
    ratio: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate:
    """The proved minimum time of one problem, in s.

    `lower_bound` is proved, `attained` is the time of a motion checked to obey; `at` are its
    durations; `binding` names the joint and limit that hold each segment back.
    """

    paper: str
    problem: str
    minimum: float | None
    lower_bound: float | None
    attained: float | None
    method: str
    at: tuple[float, ...]
    binding: tuple[str, ...]
    printed: tuple[PrintedTime, ...]
    explanation: str = ""


def certify(paper: Paper) -> tuple[Certificate, ...]:
    """Return one certificate per trajectory problem of the paper."""
    return tuple(
        _rest_to_rest(paper, experiment.name, name, problem)
        for experiment in paper.experiments
        for name, problem in experiment.problems.items()
        if isinstance(problem, MinimumTime)
    )


def _rest_to_rest(paper: Paper, experiment: str, name: str, problem: MinimumTime) -> Certificate:
    at = problem.shortest()
    total = float(at.sum())
    return Certificate(
        paper=paper.key,
        problem=f"{experiment}/{name}",
        minimum=total,
        lower_bound=total,
        attained=total,
        method=(
            "closed form: in each segment a joint that moves D in time T peaks at f·D/T^m, so T is "
            "at least (f·D/limit)^(1/m) for every joint and limit, and the greatest of these obeys"
        ),
        at=tuple(float(t) for t in at),
        binding=tuple(_binding(problem, k) for k in range(problem.segments)),
        printed=_printed(paper, experiment, name, total),
    )


def _binding(problem: MinimumTime, segment: int) -> str:
    times = problem.times_to_keep()[segment]
    derivative, joint = np.unravel_index(np.argmax(times), times.shape)
    kind = DERIVATIVES[int(derivative) + 1]
    limit = problem.limits[derivative, joint]
    return f"segment {segment + 1}: {kind} of joint {joint + 1} (limit {limit:g})"


def _printed(paper: Paper, experiment: str, name: str, total: float) -> tuple[PrintedTime, ...]:
    return tuple(
        PrintedTime(
            label=f"{claim.table.label}, {claim.row}",
            time=claim.printed.si / UNITS["s"],
            ratio=claim.printed.si / total,
        )
        for claim in paper.claims
        if isinstance(claim, CellClaim)
        and isinstance(claim.measure, Statistic)
        and (claim.measure.experiment, claim.measure.problem) == (experiment, name)
        and claim.measure.quantity == "total"
    )
