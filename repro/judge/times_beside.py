"""Whole times of a motion side by side: printed, re-run, proved, and those of baselines."""

from collections.abc import Iterator
from dataclasses import dataclass

from repro.judge.judgement import Judgement
from repro.judge.outside_box import inside_box
from repro.judge.proved_times import TOTAL, ProvedTime, algorithm_of, printed_times, proved_times
from repro.judge.times_found import ROUNDING
from repro.model.tolerances import Interval
from repro.optimisers.libraries import BASELINES
from repro.runs.baseline_study import STUDY_OF
from repro.runs.studies import study_name
from repro.tables.published import UNITS


@dataclass(frozen=True, slots=True, kw_only=True)
class TimeBeside:
    """One search on a motion; times in s.

    `printed` is that of the paper, None for a baseline. `value` is what the runs give, with the
    `interval` of tables to come, or of a baseline the mean, least and greatest of its runs.
    """

    name: str
    baseline: bool
    printed: float | None
    value: float | None
    interval: Interval | None


@dataclass(frozen=True, slots=True, kw_only=True)
class TimesBeside:
    """Every time that is known of one motion."""

    proved: ProvedTime
    rows: tuple[TimeBeside, ...]

    @property
    def breaks_limits(self) -> bool:
        """Whether any time is below the bound, so that no motion of it keeps the limits."""
        times = [time for row in self.rows for time in (row.printed, row.value) if time is not None]
        bound = self.proved.bound
        return bound is not None and min(times) < bound * (1.0 - ROUNDING)


def times_beside(judgement: Judgement) -> tuple[TimesBeside, ...]:
    """Return the times of each motion of which one is proved and one is printed."""
    return tuple(
        TimesBeside(proved=proved, rows=(*_own(judgement, proved), *_others(judgement, proved)))
        for proved in proved_times(judgement)
        if proved.printed is not None
    )


def _own(judgement: Judgement, proved: ProvedTime) -> Iterator[TimeBeside]:
    for position, claim in printed_times(judgement, proved.experiment, proved.problem):
        finding = judgement.findings[position]
        factor = UNITS[claim.printed.unit] / UNITS["s"]
        low, high = finding.measured or (0.0, 0.0)
        yield TimeBeside(
            name=algorithm_of(claim),
            baseline=False,
            printed=claim.printed.value * factor,
            value=None if finding.value is None else finding.value * factor,
            interval=(low * factor, high * factor) if finding.measured else None,
        )


def _others(judgement: Judgement, proved: ProvedTime) -> Iterator[TimeBeside]:
    evidence = judgement.evidence
    for name in BASELINES:
        cell = study_name(proved.experiment, STUDY_OF[name]), proved.problem, name
        if cell not in evidence.runs:
            continue
        times = evidence.values(cell, TOTAL)[inside_box(evidence, cell)]
        if times.size:
            yield TimeBeside(
                name=name,
                baseline=True,
                printed=None,
                value=float(times.mean()),
                interval=(float(times.min()), float(times.max())),
            )
