"""Which readings and open settings turn a verdict between held and contradicted."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from repro.judge.verdict import HELD, Verdict
from repro.model.assumptions import Assumption
from repro.model.tolerances import Interval
from repro.runs.readings import Reading
from repro.statistics.rank_sum import holm

LEVEL = 0.05


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingOutcome:
    """What becomes of a number under another reading of the paper, by the reading's name."""

    reading: str
    verdict: Verdict
    side: str | None
    measured: Interval
    repeats: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Weighed:
    """What is shown of a number under a `reading`, None for the paper as it is re-run.

    `p` is the two-sided chance that a table of its runs comes into the accepted band or beyond.
    """

    shown: ReadingOutcome
    reading: Reading | None
    p: float

    @property
    def held(self) -> bool:
        """Whether the number is reproduced or consistent."""
        return self.shown.verdict in HELD

    @property
    def contradicted(self) -> bool:
        """Whether the number is contradicted."""
        return self.shown.verdict is Verdict.CONTRADICTED

    @property
    def bounded(self) -> bool:
        """Whether its runs say how far others may lie, on either side."""
        return bool(np.isfinite(self.shown.measured).all())

    @property
    def allowed(self) -> bool:
        """Whether the text allows the reading."""
        return self.reading is None or not self.reading.ruled_out


def turned(own: Weighed, others: Sequence[Weighed]) -> tuple[str, ...]:
    """Return the names of the readings and settings on which a verdict turns.

    A number is contradicted where every reading contradicts it, so a reading that holds it counts
    without more, unless its runs are too few to rule anything out. Of many readings some contradict
    by chance, so one that contradicts what is held counts only if it does at the 5 % level with
    Holm's correction for all that bear on the number. A setting whose neighbouring values lead past
    the number on either side leads through it. On what the text rules out nothing turns.
    """
    others = [other for other in others if other.allowed]
    holding = [other for other in others if other.held and other.bounded]
    opposed = _surely_contradicting(others)
    if own.held:
        return _names(opposed)
    if own.contradicted:
        return _names(holding) or tuple(dict.fromkeys(_passed(own, others)))
    return _names([*holding, *opposed]) if holding and opposed else ()


def seeming(own: Weighed, others: Sequence[Weighed]) -> tuple[Weighed, ...]:
    """Return the outcomes that would turn the verdict, whether or not that is sure yet."""
    if own.held:
        return tuple(other for other in others if other.contradicted and other.allowed)
    if own.contradicted:
        return tuple(other for other in others if other.held and other.allowed)
    return ()


def _surely_contradicting(others: Sequence[Weighed]) -> list[Weighed]:
    if not others:
        return []
    corrected = holm(np.array([other.p for other in others]))
    return [
        other
        for other, p in zip(others, corrected, strict=True)
        if other.contradicted and p < LEVEL
    ]


def _names(outcomes: Sequence[Weighed]) -> tuple[str, ...]:
    return tuple(outcome.shown.reading for outcome in outcomes)


def _passed(own: Weighed, others: Sequence[Weighed]) -> Iterator[str]:
    """Return the open settings of which two neighbouring values miss the number on either side."""
    settings: dict[str, list[tuple[float, str | None]]] = {}
    for other in others:
        found = _alone(other)
        if found and found[0].at is not None:
            points = settings.setdefault(found[0].what, [(found[0].at, own.shown.side)])
            points.append((found[1], other.shown.side))
    for what, points in settings.items():
        for (_, before), (_, after) in pairwise(sorted(points, key=lambda point: point[0])):
            if {before, after} == {"lower", "higher"}:
                yield what


def _alone(outcome: Weighed) -> tuple[Assumption, float] | None:
    """Return the open setting and its value, of a reading that changes nothing besides."""
    reading = outcome.reading
    if reading is None or len(reading.of) != 1 or not reading.of[0].open:
        return None
    at = reading.alternatives[0].at
    return None if at is None else (reading.of[0], at)
