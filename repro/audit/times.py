"""Printed times against the proved minimum of the problem."""

from collections.abc import Iterator

from repro.model.claims import CellClaim, Claim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.robotics import MinimumTime, MinimumTimeSpline
from repro.robotics.proofs.least_time import least_time
from repro.robotics.proofs.proved import LeastTime
from repro.tables.published import UNITS
from repro.tables.relations import Number, TextNumber
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import SINGLES, exact, factor, shown, span, times


def time_rows(paper: Paper) -> Iterator[AuditRow]:
    """Yield a row per printed total time that no motion under the limits can have."""
    experiments = {experiment.name: experiment for experiment in paper.experiments}
    for claim in paper.claims:
        if not isinstance(claim.measure, Statistic) or claim.measure.quantity != "total":
            continue
        name = claim.measure.problem
        problem = experiments[claim.measure.experiment].problems.get(name)
        if not isinstance(problem, MinimumTime | MinimumTimeSpline):
            continue
        least = least_time(problem)
        if least.lower_bound is None:
            continue
        bound = exact(least.lower_bound) / exact(UNITS[claim.printed.unit])
        highest = span(claim.printed).high
        if highest < bound * (1 - SINGLES):
            yield audit_row(
                paper.key,
                (_number(claim),),
                check="time-bound",
                grade=Grade.IMPOSSIBLE,
                explanation=(
                    f"printed is {claim.printed.text} {claim.printed.unit}, at most "
                    f"{shown(highest)}; the least time under the printed limits is "
                    f"{shown(bound)}, {times(factor(bound, highest))} as much "
                    f"({claim.measure.experiment}/{name}; {least.method}; "
                    f"{'; '.join(least.binding)})"
                ),
                condition=_taken_for_granted(problem, least),
            )


def _taken_for_granted(problem: MinimumTime | MinimumTimeSpline, least: LeastTime) -> str:
    """Say which reading of the motion the least time is that of."""
    if isinstance(problem, MinimumTimeSpline):
        return "the motion is the spline that is declared, and keeps the printed limits"
    if least.minimum is None:
        return "every joint is at rest at start and end, and keeps the printed limits"
    return (
        "every joint is at rest at each printed position, moves from one to the next by the "
        "printed law, and keeps the printed limits"
    )


def _number(claim: Claim) -> Number:
    if isinstance(claim, CellClaim):
        return claim.cell
    return TextNumber(printed=claim.printed, where=claim.where)
