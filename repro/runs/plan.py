"""Everything that is to be run, in order, each run with a name, a seed and a key."""

import hashlib
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Any, overload

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

HELD = 200_000  # runs, of 0.25 kB
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


@dataclass(frozen=True, slots=True, kw_only=True)
class _Cell:
    """The runs of one algorithm on one problem of an experiment, `repeats` times over."""

    paper: str
    experiment: Experiment
    problem: str
    algorithm: str
    repeats: int
    seed: str
    inputs: str  # a digest of all that decides the outcome but the seeds

    def __len__(self) -> int:
        return self.repeats * self.experiment.runs

    def task(self, number: int) -> Task:
        """Return a run, counted from 0 repeat by repeat."""
        before, after = divmod(number, self.experiment.runs)
        repeat, run = before + 1, after + 1
        each, drawn_as = self.experiment, self.experiment.drawn_as
        place = (self.seed, self.paper, each.name, self.problem, self.algorithm, repeat, run)
        return Task(
            paper=self.paper,
            experiment=each.name,
            problem=self.problem,
            algorithm=self.algorithm,
            repeat=repeat,
            run=run,
            key=_digest(self.inputs, *place, *((drawn_as,) if drawn_as else ())),
            optimiser=each.algorithms[self.algorithm],
            subject=each.problems[self.problem],
            population=each.population,
            iterations=each.iterations,
            evaluations=each.evaluations,
            seed=self.seed,
            drawn_as=drawn_as,
        )


class _LongPlan(Sequence[Task]):
    """Runs that are made again whenever they are asked for, and so take no memory."""

    def __init__(self, cells: Sequence[_Cell]) -> None:
        self._cells = cells
        self._ends = list(accumulate(map(len, cells)))

    def __len__(self) -> int:
        return self._ends[-1] if self._ends else 0

    def __iter__(self) -> Iterator[Task]:
        return (cell.task(number) for cell in self._cells for number in range(len(cell)))

    @overload
    def __getitem__(self, index: int) -> Task: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Task]: ...
    def __getitem__(self, index: int | slice) -> Task | Sequence[Task]:
        if isinstance(index, slice):
            return tuple(self[k] for k in range(*index.indices(len(self))))
        position = range(len(self))[index]
        at = bisect_right(self._ends, position)
        return self._cells[at].task(position - (self._ends[at - 1] if at else 0))

    def of(self, paper: str) -> Sequence[Task]:
        """Return the runs of one paper."""
        return _held_if_short([cell for cell in self._cells if cell.paper == paper])


def plan(
    papers: Iterable[Paper], repeats: int, seed: str = "", *, protocol_only: bool = False
) -> tuple[Task, ...]:
    """Return every run of the papers' protocols, `repeats` times over, then of their studies.

    Repeats are counted from 1; `seed` is a master seed, which makes every run another one.
    """
    return tuple(planned(papers, repeats, seed, protocol_only=protocol_only))


def planned(
    papers: Iterable[Paper], repeats: int, seed: str = "", *, protocol_only: bool = False
) -> Sequence[Task]:
    """Return what `plan` does, however long it is.

    More than `HELD` runs are not held, but made again in each pass over them.
    """
    check_repeats(repeats)
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
    cells = [
        cell
        for paper, experiment, times in (*protocols, *besides)
        for cell in _cells(paper.key, experiment, times, seed, memory)
    ]
    return _held_if_short(cells)


def of_paper(tasks: Sequence[Task], paper: str) -> Sequence[Task]:
    """Return the runs of one paper among those planned; many are made again in each pass."""
    if isinstance(tasks, _LongPlan):
        return tasks.of(paper)
    return tuple(task for task in tasks if task.paper == paper)


def _held_if_short(cells: Sequence[_Cell]) -> Sequence[Task]:
    found = _LongPlan(cells)
    return tuple(found) if len(found) <= HELD else found


def deeper_tasks(
    paper: Paper, besides: Iterable[Study], depths: Mapping[Cell, int], seed: str = ""
) -> tuple[Task, ...]:
    """Return every run of some cells of studies, so many times over each."""
    memory: Memory = {}
    return tuple(
        task
        for study in besides
        for cell in _cells(paper.key, study.experiment, 0, seed, memory)
        if (depth := depths.get((study.experiment.name, cell.problem, cell.algorithm)))
        for task in _LongPlan([replace(cell, repeats=depth)])
    )


def tasks_of(
    paper: Paper, experiments: Iterable[tuple[Experiment, int]], seed: str = ""
) -> Iterator[Task]:
    """Yield every run of experiments, so many times over each, cell by cell."""
    memory: Memory = {}
    for experiment, times in experiments:
        yield from _LongPlan(list(_cells(paper.key, experiment, times, seed, memory)))


def _cells(
    paper: str, experiment: Experiment, repeats: int, seed: str, memory: Memory
) -> Iterator[_Cell]:
    for problem in experiment.problems:
        for algorithm in experiment.algorithms:
            yield _Cell(
                paper=paper,
                experiment=experiment,
                problem=problem,
                algorithm=algorithm,
                repeats=repeats,
                seed=seed,
                inputs=made_of(experiment, problem, algorithm, memory).digest,
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


def check_repeats(repeats: int) -> None:
    """Raise InputError where a number of repeats is none."""
    if repeats < 1:
        message = f"repeats is {repeats}; it must be 1 or more"
        raise InputError(message)
