"""What is run besides the papers' protocols.

Other readings of them, optima moved aside, baselines, and equal budgets.
"""

from collections.abc import Container, Iterable
from dataclasses import dataclass, replace
from typing import Literal

from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers.random_search import RandomSearch
from repro.runs.baseline_study import with_baselines
from repro.runs.equal_budget import EQUAL_BUDGET, at_equal_evaluations
from repro.runs.moved_optima import IN_PLACE, SHARES, centred, shift_name, shifted
from repro.runs.readings import own_part, readings

Kind = Literal["reading", "shift", "baseline", "equal budget"]
WORDS: dict[Kind, str] = {
    "reading": "other readings",
    "shift": "moved optima",
    "equal budget": "equal budgets",
    "baseline": "baselines",
}
ENOUGH = 10  # repeats of the protocol, before which baselines and equal budgets are not run


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """An experiment that departs from one of the protocol, and how often it is repeated.

    `of` names the experiment of the protocol, `departs` says in what this one differs from it.
    """

    kind: Kind
    of: str
    departs: str
    experiment: Experiment
    repeats: int


def studies(paper: Paper, repeats: int) -> tuple[Study, ...]:
    """Return what is run besides the protocol when that is repeated `repeats` times.

    A single repeat is a quick look, for which nothing else is run; baselines and equal budgets are
    not run before the protocol is repeated ten times, and of a control nothing but its readings.
    """
    if repeats < 2:
        return ()
    if paper.control:
        return _readings(paper, repeats)
    besides = _fair(paper, repeats) if repeats >= ENOUGH else ()
    return (*_readings(paper, repeats), *_shifts(paper), *besides)


def kinds_of(others: Iterable[Study], run: Container[str]) -> tuple[str, ...]:
    """Return in words which kinds of studies are among the experiments that were run."""
    kinds = {study.kind for study in others if study.experiment.name in run}
    return tuple(words for kind, words in WORDS.items() if kind in kinds)


def study_name(experiment: str, departs: str) -> str:
    """Return the name of an experiment that departs from one of the protocol."""
    return f"{experiment} [{departs}]"


def _readings(paper: Paper, repeats: int) -> tuple[Study, ...]:
    return tuple(
        Study(
            kind="reading",
            of=experiment.name,
            departs=reading.name,
            experiment=replace(part, name=study_name(experiment.name, reading.name)),
            repeats=repeats if all(a.full_depth for a in reading.alternatives) else 1,
        )
        for reading in readings(paper)
        for experiment in paper.experiments
        if (part := own_part(experiment, reading))
    )


def _shifts(paper: Paper) -> tuple[Study, ...]:
    return tuple(
        Study(
            kind="shift",
            of=experiment.name,
            departs=shift_name(share),
            experiment=replace(
                shifted(experiment, share, floor=RandomSearch()),
                name=study_name(experiment.name, shift_name(share)),
            ),
            repeats=1,  # as many pairs of runs as the paper's tables have
        )
        for experiment in paper.experiments
        if centred(experiment)
        for share in (IN_PLACE, *SHARES)
    )


def _fair(paper: Paper, repeats: int) -> tuple[Study, ...]:
    """Return the algorithms at equal evaluations, then the baselines, of every experiment."""
    equal = [(e, at_equal_evaluations(e)) for e in paper.experiments]
    return (
        *(_departing(e, "equal budget", EQUAL_BUDGET, again) for e, again in equal if again),
        *(
            _departing(e, "baseline", study, beside)
            for e in paper.experiments
            for study, beside in with_baselines(e, repeats).items()
        ),
    )


def _departing(of: Experiment, kind: Kind, departs: str, experiment: Experiment) -> Study:
    named = replace(experiment, name=study_name(of.name, departs))
    return Study(kind=kind, of=of.name, departs=departs, experiment=named, repeats=1)
