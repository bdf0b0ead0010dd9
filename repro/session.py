"""One session at the store: run what is missing, then gather what the runs say."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor

import numpy as np

from repro.evidence import Cell, Evidence, Runs
from repro.model import Paper
from repro.plan import Task
from repro.run import Record, run_all
from repro.store import Store


def run_missing(
    store: Store,
    tasks: Sequence[Task],
    *,
    executor: Executor,
    workers: int,
    environment: Callable[[], dict[str, object]],
    report: Callable[[int, int], None],
) -> list[Record]:
    """Run every task that the store lacks, keep each at once, and return the failed ones.

    `report` is told (done, to do) after every batch.
    """
    missing = store.missing(tasks)
    failed: list[Record] = []
    done = 0
    if missing:
        store.begin(environment())

    def keep(records: list[Record]) -> None:
        nonlocal done
        store.add(records)
        failed.extend(record for record in records if record.reason)
        done += len(records)
        report(done, len(missing))

    run_all(missing, executor, workers, keep)
    return failed


def gather(store: Store, paper: Paper, tasks: Iterable[Task]) -> Evidence:
    """Return the evidence of one paper: whole repeats only, in the order of their numbers."""
    own = [task for task in tasks if task.paper == paper.key]
    cells: dict[Cell, dict[int, list[Record]]] = defaultdict(lambda: defaultdict(list))
    for record in store.records(own):
        if record.reason is None:
            task = record.task
            cells[task.experiment, task.problem, task.algorithm][task.repeat].append(record)
    protocol = {experiment.name: experiment.runs for experiment in paper.experiments}
    runs = {cell: _whole(by_repeat, protocol[cell[0]]) for cell, by_repeat in cells.items()}
    return Evidence(paper, {cell: found for cell, found in runs.items() if found is not None})


def _whole(by_repeat: dict[int, list[Record]], runs: int) -> Runs | None:
    whole = [records for _, records in sorted(by_repeat.items()) if len(records) == runs]
    if not whole:
        return None
    return Runs(
        costs=np.array([[record.cost for record in records] for records in whole]),
        points=np.array([[record.x for record in records] for records in whole]),
        histories=np.array([[record.history for record in records] for records in whole]),
        evaluations=whole[0][0].evaluations,
    )
