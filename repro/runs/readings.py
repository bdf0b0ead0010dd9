"""Other ways to read a paper: its alternatives one at a time, and some of them together."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

from repro.model.assumptions import Alternative, Assumption
from repro.model.claims import CellClaim, Claim
from repro.model.experiment import Experiment
from repro.model.paper import Paper


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """The paper under one alternative, or under several together.

    `of` are the assumptions that it departs from, in the order of `alternatives`.
    """

    alternatives: tuple[Alternative, ...]
    of: tuple[Assumption, ...]

    @property
    def name(self) -> str:
        """The short name, by which its runs are named."""
        return " + ".join(alternative.name for alternative in self.alternatives)

    @property
    def says(self) -> str:
        """What is read otherwise, as a phrase."""
        return "; ".join(
            f"{assumption.what}: {alternative.says}"
            for assumption, alternative in zip(self.of, self.alternatives, strict=True)
        )

    @property
    def ruled_out(self) -> bool:
        """Whether the text does not allow it, so that it is a note."""
        return any(alternative.ruled_out for alternative in self.alternatives)

    def touching(
        self, experiment: str, problem: str | None = None, algorithm: str | None = None
    ) -> "Reading":
        """Return what of it changes an experiment, or one cell of it, whose runs it names."""
        kept = [
            (alternative, assumption)
            for alternative, assumption in zip(self.alternatives, self.of, strict=True)
            if _touches(alternative, experiment, problem, algorithm)
        ]
        return Reading(alternatives=tuple(a for a, _ in kept), of=tuple(o for _, o in kept))


def _touches(
    alternative: Alternative, experiment: str, problem: str | None, algorithm: str | None
) -> bool:
    parts = ((alternative.algorithms, algorithm), (alternative.problems, problem))
    return experiment in alternative.protocol or any(
        name == experiment and asked in (None, part)
        for changes, asked in parts
        for name, part in changes
    )


def readings(paper: Paper) -> tuple[Reading, ...]:
    """Return every alternative that changes anything, then those of `together` combined.

    Two alternatives of one assumption exclude each other and are never combined.
    """
    single = [
        Reading(alternatives=(alternative,), of=(assumption,))
        for assumption in paper.assumptions
        for alternative in assumption.alternatives
        if alternative.changes
    ]
    chosen = [reading for reading in single if reading.name in paper.together]
    joint = [
        Reading(
            alternatives=tuple(reading.alternatives[0] for reading in group),
            of=tuple(reading.of[0] for reading in group),
        )
        for size in range(2, len(chosen) + 1)
        for group in combinations(chosen, size)
        if len({reading.of[0].what for reading in group}) == size
    ]
    return (*single, *joint)


def applied(experiment: Experiment, reading: Reading) -> Experiment:
    """Return the whole experiment as the reading has it, under its own name."""
    algorithms, problems = dict(experiment.algorithms), dict(experiment.problems)
    protocol: dict[str, int] = {}
    for alternative in reading.alternatives:
        _change(algorithms, alternative.algorithms, experiment.name)
        _change(problems, alternative.problems, experiment.name)
        protocol |= alternative.protocol.get(experiment.name, {})
    changes: dict[str, Any] = {"algorithms": algorithms, "problems": problems, **protocol}
    return replace(experiment, **changes)


def _change(parts: dict[str, Any], changes: Mapping[tuple[str, str], Any], experiment: str) -> None:
    """Put what the changes say in the place of what is there."""
    for (name, part), change in changes.items():
        if name == experiment:
            fields = isinstance(change, Mapping)
            parts[part] = replace(parts[part], **change) if fields else change


def changed_part(experiment: Experiment, reading: Reading) -> Experiment | None:
    """Return the part of the experiment that must run again; None where nothing must."""
    whole = applied(experiment, reading)
    algorithms = _different(experiment.algorithms, whole.algorithms)
    problems = _different(experiment.problems, whole.problems)
    if any(experiment.name in alternative.protocol for alternative in reading.alternatives):
        return whole
    if not algorithms and not problems:
        return None
    if not algorithms:
        return replace(whole, problems=problems)
    if not problems:
        return replace(whole, algorithms=algorithms)
    return whole


def own_part(experiment: Experiment, reading: Reading) -> Experiment | None:
    """Return the part of the experiment with runs of the reading's own; None where there is none.

    Where fewer than all of its alternatives bear on a cell, that smaller reading has its runs.
    """
    part = changed_part(experiment, reading)
    if part is None:
        return None
    cells = [
        (problem, algorithm)
        for problem in part.problems
        for algorithm in part.algorithms
        if len(reading.touching(experiment.name, problem, algorithm).of) == len(reading.of)
    ]
    return (
        replace(
            part,
            problems={name: part.problems[name] for name in dict.fromkeys(p for p, _ in cells)},
            algorithms={name: part.algorithms[name] for name in dict.fromkeys(a for _, a in cells)},
        )
        if cells
        else None
    )


def _different(before: Mapping[str, Any], after: Mapping[str, Any]) -> dict[str, Any]:
    return {name: part for name, part in after.items() if part is not before[name]}


def claims_under(paper: Paper, reading: Reading) -> tuple[Claim, ...]:
    """Return the paper's claims with those in place that the reading brings along."""
    own = {
        _identity(claim): claim
        for alternative in reading.alternatives
        for claim in alternative.claims
    }
    return tuple(own.get(_identity(claim), claim) for claim in paper.said)


def _identity(claim: Claim) -> tuple[str, str, str] | str:
    if isinstance(claim, CellClaim):
        return claim.table.label, claim.row, claim.column
    return claim.claim
