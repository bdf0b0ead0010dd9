"""What the pages show of times beside a certificate."""

from collections.abc import Iterable

from repro.judge.certificates import Certificate
from repro.judge.times_found import FoundTime
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
