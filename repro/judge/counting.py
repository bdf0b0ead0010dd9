"""What summaries count: one sentence, one constraint or one slip once, however often it shows."""

from collections import Counter
from collections.abc import Iterable

from repro.judge.verdict import Verdict

GRAVEST = (
    Verdict.CONTRADICTED,
    Verdict.NOT_RUN,
    Verdict.NOT_REPRODUCIBLE,
    Verdict.DEPENDS,
    Verdict.UNDECIDED,
    Verdict.CONSISTENT,
    Verdict.REPRODUCED,
)
"""A sentence holds where all that it says holds, so of several verdicts the first of these is its
own."""


def by_group(said: Iterable[tuple[str | None, str]]) -> dict[str, Verdict]:
    """Return the verdict of each group, from the (group, verdict) of findings; None counts not."""
    found: dict[str, Verdict] = {}
    for group, word in said:
        if group is not None:
            own = Verdict(word)
            found[group] = min(own, found.get(group, own), key=GRAVEST.index)
    return found


def counts(said: Iterable[tuple[str | None, str]]) -> Counter[str]:
    """Return how many results have each verdict."""
    return Counter(str(verdict) for verdict in by_group(said).values())
