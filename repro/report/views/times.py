"""What the pages show of times beside a certificate."""

from collections.abc import Iterable
from functools import partial

from repro.judge.certificates import Certificate
from repro.judge.judgement import Judgement
from repro.judge.times_beside import times_beside
from repro.judge.times_found import FoundTime
from repro.model.identifiers import anchor
from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.times import times_plot
from repro.report.outside_times import outside_times
from repro.report.words import number


def time_cells(certificate: Certificate, found: Iterable[FoundTime]) -> list[tuple[str, str, str]]:
    """Return label, seconds and ratio to the minimum of printed, found and outside times."""
    rows = [(f"printed: {p.label}", p.time, p.ratio) for p in certificate.printed]
    for each in found:
        label = f"re-run: {each.algorithm}, all repeats,"
        rows.append((f"{label} mean", each.mean, each.mean_ratio))
        rows.append((f"{label} best", each.least, each.least_ratio))
    rows += outside_times(certificate)
    return [(label, number(time), f"{ratio:.4f}") for label, time, ratio in rows]


def times_drawn(judgement: Judgement) -> tuple[tuple[str, Drawing], ...]:
    """Return the drawing of each motion's times, with the name of its data."""
    return tuple(
        (
            anchor("times", each.proved.certificate),
            drawing(
                partial(times_plot, each),
                title=f"Times of {each.proved.certificate}",
                identifier=anchor(judgement.paper.key, "times", each.proved.certificate),
            ),
        )
        for each in times_beside(judgement)
    )
