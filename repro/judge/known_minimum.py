"""The least cost that a problem has, where it is known by formula or by proof."""

from collections.abc import Sequence
from dataclasses import dataclass

from repro.functions import BenchmarkProblem, BoxProblem
from repro.judge.certificates import Certificate
from repro.robotics import MinimumTime, MinimumTimeSpline, PathFitting
from repro.robotics.fixed_penalties import cheapest

CERTIFIED = "certified optimum"


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownMinimum:
    """The least cost of a problem, and how it is known."""

    value: float
    how: str

    @property
    def is_time(self) -> bool:
        """Whether it is a proved time, in s."""
        return self.how == CERTIFIED


def known_minimum(
    label: str, problem: object, certificates: Sequence[Certificate] = ()
) -> KnownMinimum | None:
    """Return the least cost of a problem, None where it is not known.

    `label` is "experiment/problem", by which a certificate names it.
    """
    if isinstance(problem, BenchmarkProblem):
        return KnownMinimum(value=problem.minimum, how="minimum of the function")
    if isinstance(problem, BoxProblem):
        declared = problem.minimum
        return None if declared is None else KnownMinimum(value=declared, how="as declared")
    if isinstance(problem, PathFitting):
        inside = problem.allows(problem.nearest())
        return KnownMinimum(value=problem.least_cost(), how="least squares") if inside else None
    if isinstance(problem, MinimumTime) and problem.handling == "fixed penalties":
        return KnownMinimum(value=cheapest(problem).cost, how="least fitness, by cases")
    if isinstance(problem, MinimumTime | MinimumTimeSpline) and problem.handling != "penalty":
        # the proved bound and not the motion found, which a search may come below by its margin
        proved = [
            c.lower_bound
            for c in certificates
            if c.problem == label and c.minimum is not None and c.lower_bound is not None
        ]
        return KnownMinimum(value=proved[0], how=CERTIFIED) if proved else None
    return None
