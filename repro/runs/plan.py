"""Everything that is to be run, in order, each run with a name, a seed and a key."""

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from repro.determinism.source_digests import Told, together, told
from repro.errors import DeclarationError, InputError
from repro.model.evidence import Cell
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers.search import Optimiser
from repro.runs.rules import conduct, fault
from repro.runs.studies import Study, studies

Memory = dict[tuple[str, int], tuple[object, Told]]
"""What objects are, each by its place and the number of the object."""

_RULES = (conduct, fault)  # by which every run is made and judged sound


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One run of one algorithm on one problem."""

    paper: str
    experiment: str
    problem: str
    algorithm: str
    repeat: int
    run: int
    key: str
    optimiser: Optimiser
    subject: Any
    population: int
    iterations: int
    evaluations: int | None = None
    seed: str = ""
    drawn_as: str = ""
    timeout: float | None = None  # seconds after which a run is given up; no part of its key

    @property
    def name(self) -> str:
        """The name of the run, which no other has; another master seed stands before it."""
        return self._named(self.experiment)

    @property
    def stream(self) -> str:
        """The name that seeds the run: its own, or that of the run whose numbers it draws."""
        return self._named(self.drawn_as or self.experiment)

    def _named(self, experiment: str) -> str:
        parts = (self.paper, experiment, self.problem, self.algorithm, self.repeat, self.run)
        return "/".join(map(str, (self.seed, *parts) if self.seed else parts))


def plan(
    papers: Iterable[Paper], repeats: int, seed: str = "", *, protocol_only: bool = False
) -> tuple[Task, ...]:
    """Return every run of the papers' protocols, `repeats` times over, then of their studies.

    Repeats are counted from 1; `seed` is a master seed, which makes every run another one.
    """
    if repeats < 1:
        message = f"repeats is {repeats}; it must be 1 or more"
        raise InputError(message)
    memory: Memory = {}
    declared = tuple(papers)
    protocols = [
        (paper, experiment, repeats) for paper in declared for experiment in paper.experiments
    ]
    besides = [
        (paper, study.experiment, study.repeats)
        for paper in declared
        for study in (() if protocol_only else studies(paper, repeats))
    ]
    return tuple(
        task
        for paper, experiment, times in (*protocols, *besides)
        for problem in experiment.problems
        for algorithm in experiment.algorithms
        for task in _cell(
            paper.key, experiment, problem, algorithm, repeats=times, seed=seed, memory=memory
        )
    )


def deeper_tasks(
    paper: Paper, besides: Iterable[Study], depths: Mapping[Cell, int], seed: str = ""
) -> tuple[Task, ...]:
    """Return every run of some cells of studies, so many times over each."""
    memory: Memory = {}
    return tuple(
        task
        for study in besides
        for problem in study.experiment.problems
        for algorithm in study.experiment.algorithms
        if (cell := (study.experiment.name, problem, algorithm)) in depths
        for task in _cell(
            paper.key,
            study.experiment,
            problem,
            algorithm,
            repeats=depths[cell],
            seed=seed,
            memory=memory,
        )
    )


def tasks_of(
    paper: Paper, experiments: Iterable[tuple[Experiment, int]], seed: str = ""
) -> Iterator[Task]:
    """Yield every run of experiments, so many times over each, cell by cell."""
    memory: Memory = {}
    for experiment, times in experiments:
        for problem in experiment.problems:
            for algorithm in experiment.algorithms:
                yield from _cell(
                    paper.key,
                    experiment,
                    problem,
                    algorithm,
                    repeats=times,
                    seed=seed,
                    memory=memory,
                )


def _cell(
    paper: str,
    experiment: Experiment,
    problem: str,
    algorithm: str,
    *,
    repeats: int,
    seed: str,
    memory: Memory,
) -> Iterable[Task]:
    inputs = made_of(experiment, problem, algorithm, memory).digest
    for repeat in range(1, repeats + 1):
        for run in range(1, experiment.runs + 1):
            place = (seed, paper, experiment.name, problem, algorithm, repeat, run)
            drawn_as = (experiment.drawn_as,) if experiment.drawn_as else ()
            yield Task(
                paper=paper,
                experiment=experiment.name,
                problem=problem,
                algorithm=algorithm,
                repeat=repeat,
                run=run,
                key=_digest(inputs, *place, *drawn_as),
                optimiser=experiment.algorithms[algorithm],
                subject=experiment.problems[problem],
                population=experiment.population,
                iterations=experiment.iterations,
                evaluations=experiment.evaluations,
                seed=seed,
                drawn_as=experiment.drawn_as,
            )


def made_of(experiment: Experiment, problem: str, algorithm: str, memory: Memory) -> Told:
    """Return all that decides the outcome of runs but their seeds.

    `memory` is of one call: what an object is it tells once. Raises DeclarationError, naming the
    place, for an algorithm or a problem that cannot be told.
    """
    optimiser, subject = experiment.algorithms[algorithm], experiment.problems[problem]
    try:
        parts = (_once(memory, "algorithm", optimiser), _once(memory, "problem", subject))
    except DeclarationError as error:
        message = f"{experiment.name}, {algorithm!r} on {problem!r}: {error}"
        raise DeclarationError(message) from None
    budget = told(
        population=experiment.population,
        iterations=experiment.iterations,
        evaluations=experiment.evaluations,
    )
    return together(*parts, _once(memory, "rules", _RULES), budget)


def sources_of_run(optimiser: object, subject: Any) -> str:  # noqa: ANN401 (any problem)
    """Return a digest of all source code that decides what a run of a search gives."""
    memory: Memory = {}
    objects = {"algorithm": optimiser, "problem": subject, "rules": _RULES}
    return together(*(_once(memory, *pair) for pair in objects.items())).sources


def _once(memory: Memory, place: str, value: object) -> Told:
    """Return what an object is; the memory keeps it, so that no other takes its number."""
    if (place, id(value)) not in memory:
        more = {"kernel": value.kernel} if hasattr(value, "kernel") else {}
        memory[place, id(value)] = (value, told(**{place: value}, **more))
    return memory[place, id(value)][1]


def _digest(*parts: object) -> str:
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()
