"""From stored runs to the evidence of one paper."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from itertools import groupby

import numpy as np

from repro.functions import BenchmarkProblem
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers.search import LeavesBox
from repro.runs.plan import Task
from repro.runs.run import Record
from repro.runs.store.store import Store
from repro.runs.studies import Study


def gather(
    store: Store,
    paper: Paper,
    tasks: Iterable[Task],
    besides: Iterable[Study] = (),
    note: Callable[[Record], None] = lambda _: None,
) -> Evidence:
    """Return the evidence of one paper: whole repeats only, in the order of their numbers.

    `note` is told of every record that is read, those of a repeat that is not whole among them.
    Tasks of one cell stand together, so that no more than one cell's records are held at once.
    """
    studies = tuple(besides)
    others = tuple(study.experiment for study in studies)
    known = {experiment.name: experiment for experiment in (*paper.experiments, *others)}
    followed = {
        cell
        for claim in paper.claims
        if claim.measure and claim.measure.follows
        for cell in claim.measure.cells()
    }
    # under another reading a claim follows the searches of that reading
    followed |= {
        (study.experiment.name, problem, algorithm)
        for study in studies
        for experiment, problem, algorithm in followed
        if study.kind == "reading" and study.of == experiment
    }
    runs: dict[Cell, Runs] = {}
    own = (task for task in tasks if task.paper == paper.key and task.experiment in known)
    for cell, group in groupby(own, key=cell_of):
        found = _whole(
            _noted(store.records(group), note),
            known[cell[0]].runs,
            follow=cell in followed,
            measure=_is_measured(known[cell[0]], *cell[1:]),
        )
        if found:
            runs[cell] = found
    return Evidence(paper.key, (*others, *paper.experiments), runs)


def _noted(records: Iterable[Record], note: Callable[[Record], None]) -> Iterator[Record]:
    for record in records:
        note(record)
        yield record


def cell_of(task: Task) -> Cell:
    """Return the cell that a run is of."""
    return task.experiment, task.problem, task.algorithm


def _is_measured(experiment: Experiment, problem: str, algorithm: str) -> bool:
    """Whether more is asked of the points where runs end than what they cost."""
    search = experiment.algorithms[algorithm]
    leaves = isinstance(search, LeavesBox) and search.leaves_box
    return leaves or not isinstance(experiment.problems[problem], BenchmarkProblem)


def _whole(records: Iterable[Record], runs: int, *, follow: bool, measure: bool) -> Runs | None:
    """Return the whole repeats; histories and points of all of them, or of the first alone."""
    by_repeat: dict[int, list[Record]] = defaultdict(list)
    for record in records:
        if record.reason is None:
            by_repeat[record.task.repeat].append(record)
    whole = [records for _, records in sorted(by_repeat.items()) if len(records) == runs]
    if not whole:
        return None
    return Runs(
        costs=np.array([[record.cost for record in records] for records in whole]),
        points=np.array(
            [[record.x for record in records] for records in whole[: None if measure else 1]]
        ),
        histories=np.array(
            [[record.history for record in records] for records in whole[: None if follow else 1]]
        ),
        evaluations=whole[0][0].evaluations,
        seconds=float(np.median([record.seconds for records in whole for record in records])),
    )
