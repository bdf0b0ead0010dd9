"""Finished runs one by one: what is published of each, and what its seed is."""

from array import array
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.plan import Task, tasks_of
from repro.runs.run import Record
from repro.runs.studies import Study, studies, study_name

PROTOCOL = "protocol"


@dataclass(frozen=True, slots=True)
class RawCell:
    """What the finished runs of one algorithm on one problem ended with, a column a field.

    `study` says in what they depart from the paper's protocol, `PROTOCOL` where in nothing;
    `experiment` is always the paper's own. `seconds` are of the machine that ran them.
    """

    study: str
    experiment: str
    problem: str
    algorithm: str
    repeat: "array[int]" = field(default_factory=lambda: array("q"))
    run: "array[int]" = field(default_factory=lambda: array("q"))
    cost: "array[float]" = field(default_factory=lambda: array("d"))
    evaluations: "array[int]" = field(default_factory=lambda: array("q"))
    seconds: "array[float]" = field(default_factory=lambda: array("d"))

    def note(self, record: Record) -> None:
        """Keep what a record ended with."""
        self.repeat.append(record.task.repeat)
        self.run.append(record.task.run)
        self.cost.append(record.cost)
        self.evaluations.append(record.evaluations)
        self.seconds.append(record.seconds)


class RawRuns:
    """The finished runs of one paper, each once, noted in whatever order they are read."""

    def __init__(self, besides: Iterable[Study]) -> None:
        """Know what runs besides the protocol."""
        self._places = {each.experiment.name: (each.departs, each.of) for each in besides}
        self._cells: dict[tuple[str, str, str], RawCell] = {}

    def note(self, record: Record) -> None:
        """Keep what a record ended with; a failed one ended with nothing."""
        task = record.task
        if record.reason is None:
            key = (task.experiment, task.problem, task.algorithm)
            if key not in self._cells:
                place = self._places.get(task.experiment, (PROTOCOL, task.experiment))
                self._cells[key] = RawCell(*place, task.problem, task.algorithm)
            self._cells[key].note(record)

    def cells(self) -> tuple[RawCell, ...]:
        """Return the cells in the order of their first record."""
        return tuple(self._cells.values())


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
