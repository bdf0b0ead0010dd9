"""What becomes of a number under other readings, in the words of the pages."""

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from repro.judge.findings import Finding
from repro.judge.turning import ReadingOutcome
from repro.judge.verdict import HELD
from repro.model.identifiers import anchor
from repro.report.views.line_plot import drawn_ends
from repro.report.words import interval, verdict_words


@dataclass(frozen=True, slots=True, kw_only=True)
class ShownReading:
    """What becomes of a number under another reading, as the pages show it.

    `held` is what may turn a verdict; the `note` says why a reading may not; `drawn` are the ends
    of its interval for the line plot.
    """

    reading: str
    measured: str
    verdict: str
    kind: str
    repeats: int
    held: bool
    note: str
    drawn: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Turn:
    """A reading or setting on which a verdict turns, and what comes out under it.

    A setting has several outcomes: that of each value that was tried.
    """

    name: str
    outcomes: tuple[ShownReading, ...]


def shown_reading(found: ReadingOutcome, digits: int, ruled_out: Collection[str]) -> ShownReading:
    """Return an outcome in words, in so many digits; `ruled_out` are names of readings."""
    note = (
        "too few runs to rule anything out" if not all(map(math.isfinite, found.measured)) else ""
    )
    if found.reading in ruled_out:
        note = "the text rules it out"
    return ShownReading(
        reading=found.reading,
        measured=interval(found.measured, digits),
        verdict=verdict_words(found.verdict, found.side),
        kind=anchor(found.verdict),
        repeats=found.repeats,
        held=found.verdict in HELD and not note,
        note=note,
        drawn=drawn_ends(found.measured),
    )


def turns_of(
    finding: Finding, readings: Sequence[ShownReading], settings: Mapping[str, Sequence[str]]
) -> tuple[Turn, ...]:
    """Return what a finding turns on, with the outcomes among its readings."""
    return tuple(
        Turn(
            name=name,
            outcomes=tuple(
                one
                for one in readings
                if one.reading == name or one.reading in settings.get(name, ())
            ),
        )
        for name in finding.turns_on
    )
