"""Finished runs one by one: what is published of each, and what its seed is."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.plan import Task, tasks_of
from repro.runs.run import Record
from repro.runs.studies import Study, studies, study_name

PROTOCOL = "protocol"
Place = tuple[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class RawRun:
    """What one finished run ended with.

    `study` says in what the run departs from the paper's protocol, `PROTOCOL` where in nothing;
    `experiment` is always the paper's own. `seconds` are of the machine that ran it.
    """

    study: str
    experiment: str
    problem: str
    algorithm: str
    repeat: int
    run: int
    cost: float
    evaluations: int
    seconds: float


class RawRuns:
    """The finished runs of one paper, each once, noted in whatever order they are read."""

    def __init__(self, besides: Iterable[Study]) -> None:
        """Know what runs besides the protocol."""
        self._places = places(besides)
        self._cells: dict[tuple[str, str, str], dict[tuple[int, int], RawRun]] = {}

    def note(self, record: Record) -> None:
        """Keep what a record ended with; a failed one ended with nothing."""
        task = record.task
        if record.reason is None:
            cell = self._cells.setdefault((task.experiment, task.problem, task.algorithm), {})
            cell[task.repeat, task.run] = raw_run(record, self._places)

    def add(self, runs: Iterable[RawRun]) -> None:
        """Keep runs that were noted before."""
        for each in runs:
            cell = ran_as(each.study, each.experiment), each.problem, each.algorithm
            self._cells.setdefault(cell, {})[each.repeat, each.run] = each

    def runs(self) -> tuple[RawRun, ...]:
        """Return the runs, cells in the order of their first record, by repeat and run in each."""
        return tuple(run for cell in self._cells.values() for _, run in sorted(cell.items()))


def places(besides: Iterable[Study]) -> Mapping[str, Place]:
    """Return by the name of each study's experiment what it departs in and from which one."""
    return {study.experiment.name: (study.departs, study.of) for study in besides}


def raw_run(record: Record, known: Mapping[str, Place]) -> RawRun:
    """Return what is published of a record; `known` are the places of studies."""
    task = record.task
    study, experiment = known.get(task.experiment, (PROTOCOL, task.experiment))
    return RawRun(
        study=study,
        experiment=experiment,
        problem=task.problem,
        algorithm=task.algorithm,
        repeat=task.repeat,
        run=task.run,
        cost=record.cost,
        evaluations=record.evaluations,
        seconds=record.seconds,
    )


def ran_as(study: str, experiment: str) -> str:
    """Return the name that an experiment has in the store and in the names of its runs."""
    return experiment if study == PROTOCOL else study_name(experiment, study)


def drawn_as(paper: Paper, besides: Iterable[Study]) -> dict[str, str]:
    """Return the experiments that draw the random numbers of another, and of which."""
    experiments = (*paper.experiments, *(study.experiment for study in besides))
    return {each.name: each.drawn_as for each in experiments if each.drawn_as}


def experiments_of(paper: Paper, repeats: int) -> dict[str, Experiment]:
    """Return by name what is run of a paper in so many repeats; of two with one the first."""
    besides = (study.experiment for study in studies(paper, repeats))
    return {each.name: each for each in reversed((*paper.experiments, *besides))}


def every_task(paper: Paper, repeats: int, only: str = "") -> Iterator[Task]:
    """Yield every run that a store with so many repeats may hold of a paper, cell by cell.

    They are of all experiments, or of the one whose name is given. A study may have been repeated
    as often as the protocol to decide what it turns.
    """
    besides = (study.experiment for study in studies(paper, repeats))
    wanted = (each for each in (*paper.experiments, *besides) if only in {"", each.name})
    yield from tasks_of(paper, ((each, repeats) for each in wanted))
