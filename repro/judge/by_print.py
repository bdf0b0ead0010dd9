"""What a measure comes to by the printed numbers alone, beside what the runs give."""

import math
from dataclasses import replace

import numpy as np

from repro.errors import ReproError
from repro.model.evidence import Evidence
from repro.model.measures.measure import ALL, Measure, Measured, Statistic
from repro.model.paper import Paper
from repro.statistics.summary import STATISTICS
from repro.tables.published import UNITS


def printed_evidence(paper: Paper) -> Evidence:
    """Return evidence without a run, in which each statistic that is printed has that value.

    Of a statistic that is printed twice, the first counts.
    """
    known: dict[object, object] = {}
    for claim in paper.said:
        of = claim.measure
        if not isinstance(of, Statistic) or not math.isfinite(claim.printed.value):
            continue
        value = Measured(value=claim.printed.si, draws=np.array([claim.printed.si]), repeats=0)
        if of.statistic in STATISTICS:
            together = known.setdefault(replace(of, statistic=ALL), {})
            if isinstance(together, dict):
                together.setdefault(of.statistic, value)
        else:
            known.setdefault(of, value)
    return Evidence(paper.key, paper.experiments, {}, known)


def by_print(measure: Measure | None, printed: Evidence) -> float | None:
    """Return what a measure is by the printed numbers, in SI units; None where one is missing.

    None also for what is computed from inputs, of which the print of the results says nothing.
    """
    if measure is None or not measure.cells():
        return None
    try:
        return measure.measure(printed).value
    except (KeyError, ReproError):
        return None


def printed_sizes(paper: Paper) -> tuple[float | None, ...]:
    """Return what each claim's measure is by the printed numbers, in the claim's unit."""
    printed = printed_evidence(paper)
    sizes = (by_print(claim.measure, printed) for claim in paper.said)
    return tuple(
        None if size is None else size / UNITS[claim.printed.unit]
        for claim, size in zip(paper.said, sizes, strict=True)
    )
