"""What a paper leaves open: what was chosen, and among which alternatives."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from repro.model.claims import Claim
from repro.model.experiment import Experiment
from repro.model.known_words import known_words, shown_value


@dataclass(frozen=True, slots=True, kw_only=True)
class Alternative:
    """Another choice than ours: what it changes, or why it cannot be tried.

    `name` is short and unique in its paper; the runs are named by it. `algorithms` maps
    (experiment, algorithm) and `problems` maps (experiment, problem) to what takes its place: an
    object, or the fields to replace. `protocol` maps an experiment to fields of it to replace
    (population, iterations, runs). `claims` take the place of the claims on the same cells or
    sentences. `at` is the value of an open setting. It runs as deep as the protocol where
    `full_depth` says so. One that the text has `ruled_out` is run and shown as a note: no verdict
    may turn on it.
    """

    says: str
    name: str = ""
    ruled_out: bool = False
    at: float | None = None
    full_depth: bool = False
    algorithms: Mapping[tuple[str, str], Any] = field(default_factory=dict)
    problems: Mapping[tuple[str, str], Any] = field(default_factory=dict)
    protocol: Mapping[str, Mapping[str, int]] = field(default_factory=dict)
    claims: tuple[Claim, ...] = ()
    untried: str = ""

    def __str__(self) -> str:
        """Return what the pages say of it."""
        return self.says

    @property
    def changes(self) -> bool:
        """Whether it changes anything that can be judged again."""
        return bool(self.algorithms or self.problems or self.protocol or self.claims)


@dataclass(frozen=True, slots=True, kw_only=True)
class Assumption:
    """A value or rule that the paper leaves open: what we chose, among what, and why.

    `open` says that nothing in the paper narrows it down: the alternatives are then points of the
    range that is tried, and `at` is the value chosen, where the setting is a number.
    """

    what: str
    chosen: str
    alternatives: tuple[Alternative, ...]
    because: str
    where: str
    open: bool = False
    at: float | None = None


def alternative_faults(
    assumptions: Iterable[Assumption], together: Iterable[str], experiments: Iterable[Experiment]
) -> Iterator[str]:
    """Yield what is wrong with the alternatives of a paper and with those that are tried together.

    What an alternative changes is asked of the experiments, their names alone.
    """
    runs = {experiment.name: experiment for experiment in experiments}
    declared = [each for assumption in assumptions for each in assumption.alternatives]
    names = Counter(alternative.name for alternative in declared if alternative.changes)
    for alternative in declared:
        place = f"alternative {alternative.says!r}"
        if bool(alternative.untried) == alternative.changes:
            yield f"{place} needs either something that it changes, or why it is not tried"
        if alternative.changes and (not alternative.name or "/" in alternative.name):
            yield f"{place} needs a name without '/', not {alternative.name!r}"
        if alternative.changes and names[alternative.name] > 1:
            yield f"{place}: another alternative has the name {alternative.name!r} too"
        yield from (f"{place}: {fault}" for fault in _changes_of_nothing(alternative, runs))
    for name in together:
        if name not in names:
            yield f"together: no alternative that changes anything is {name!r}; " + known_words(
                name, names
            )


def _changes_of_nothing(alternative: Alternative, runs: Mapping[str, Experiment]) -> Iterator[str]:
    for kind, changes in (
        ("problem", alternative.problems),
        ("algorithm", alternative.algorithms),
    ):
        for place in changes:
            if not isinstance(place, tuple) or len(place) != 2:
                yield f"{kind}s: {shown_value(place)} is no pair (experiment, {kind})"
                continue
            name, each = place
            if name not in runs:
                yield f"no experiment {name!r}; {known_words(name, runs)}"
                continue
            known = getattr(runs[name], f"{kind}s")
            if each not in known:
                yield f"experiment {name!r} has no {kind} {each!r}; {known_words(each, known)}"
    for name in alternative.protocol:
        if name not in runs:
            yield f"no experiment {name!r}; {known_words(name, runs)}"
