"""How large a thing is that a sentence only names, as "clearly faster" does."""

from collections.abc import Iterable
from dataclasses import replace

from repro.judge.by_print import printed_sizes
from repro.judge.findings import IN_WORDS, Finding
from repro.model.paper import Paper
from repro.report.views.findings import Shown, with_unit
from repro.report.words import interval, number


def sized(found: Iterable[Shown], paper: Paper) -> list[Shown]:
    """Return what is shown of a paper's claims with the sizes of those in words."""
    return [
        replace(shown, size=size_words(shown.finding, size))
        for shown, size in zip(found, printed_sizes(paper), strict=True)
    ]


def size_words(finding: Finding, by_print: float | None) -> str:
    """Return how large it is by the printed numbers, where they tell, and by the runs."""
    if finding.printed != IN_WORDS or finding.measured is None:
        return ""
    told = [] if by_print is None else [f"by the print {with_unit(number(by_print), finding.unit)}"]
    runs = with_unit(interval(finding.measured), finding.unit)
    return ", ".join((*told, f"{'by the runs' if finding.repeats else 'as computed'} {runs}"))
