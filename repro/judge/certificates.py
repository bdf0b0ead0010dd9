"""Proved minima of the trajectory problems, and how far printed times lie from them."""

from dataclasses import asdict, dataclass

from repro.model.claims import CellClaim, Claim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.robotics import MinimumTime, MinimumTimeSpline, PathFitting
from repro.robotics.proofs.least_time import least_norms, least_time
from repro.robotics.proofs.proved import LeastTime
from repro.tables.published import UNITS


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedTime:
    """A printed total time in s and its ratio to the certified minimum."""

    label: str
    time: float
    ratio: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate:
    """A LeastTime of one problem of a paper, beside the times that are printed of it."""

    paper: str
    problem: str
    minimum: float | None
    lower_bound: float | None
    attained: float | None
    method: str
    at: tuple[float, ...]
    binding: tuple[str, ...]
    printed: tuple[PrintedTime, ...]
    gap: float | None = None
    box: tuple[float, float] | None = None
    explanation: str = ""


def certify(paper: Paper) -> tuple[Certificate, ...]:
    """Return one certificate per trajectory problem of the paper, and one per other reading.

    The path fits of an experiment, which minimise no time, share one that only explains.
    """
    as_run = [
        ((experiment.name, name), f"{experiment.name}/{name}", problem)
        for experiment in paper.experiments
        for name, problem in experiment.problems.items()
    ]
    as_read = [
        (reading.of, f"{'/'.join(reading.of)}, {reading.name}", reading.problem)
        for reading in paper.motion_readings
    ]
    motions = tuple(
        _certificate(paper, of, label, least_time(problem))
        for of, label, problem in (*as_run, *as_read)
        if isinstance(problem, MinimumTime | MinimumTimeSpline)
    )
    return motions + tuple(
        _certificate(paper, None, experiment.name, least_norms(fits))
        for experiment in paper.experiments
        if (fits := [p for p in experiment.problems.values() if isinstance(p, PathFitting)])
    )


def _certificate(
    paper: Paper, of: tuple[str, str] | None, label: str, least: LeastTime
) -> Certificate:
    return Certificate(
        paper=paper.key,
        problem=label,
        printed=_printed(paper, of, least.minimum) if of and least.minimum else (),
        gap=least.gap,
        **asdict(least),
    )


def _printed(paper: Paper, of: tuple[str, str], total: float) -> tuple[PrintedTime, ...]:
    """Return the printed times of the problem: those of tables, and others that the text has."""
    claims = [
        claim
        for claim in paper.claims
        if isinstance(claim.measure, Statistic)
        and claim.measure.cell[:2] == of
        and claim.measure.quantity == "total"
    ]
    tabled = {claim.printed.si for claim in claims if claim.place}
    return tuple(
        PrintedTime(
            label=_label(claim), time=claim.printed.si / UNITS["s"], ratio=claim.printed.si / total
        )
        for claim in claims
        if claim.place or claim.printed.si not in tabled
    )


def _label(claim: Claim) -> str:
    return f"{claim.table.label}, {claim.row}" if isinstance(claim, CellClaim) else claim.where
