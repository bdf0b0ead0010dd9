"""Running tasks on any executor, a few at a time, each finished one handed on at once."""

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, wait
from dataclasses import dataclass
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from repro.plan import Task
from repro.seeds import generator

Vector = NDArray[np.float64]
IN_FLIGHT = 4  # tasks handed out per worker, so that none waits while results are stored


@dataclass(frozen=True, slots=True, kw_only=True)
class Record:
    """What one run gave; `reason` says why a failed run has no result."""

    task: Task
    cost: float
    x: Vector
    history: Vector
    evaluations: int
    seconds: float
    reason: str | None = None


def execute(task: Task) -> Record:
    """Return the record of one run: the same bits wherever and whenever it runs.

    An exception or a cost that is not finite is recorded as a failed run with its reason.
    """
    start = time.perf_counter()
    try:
        result = task.optimiser.minimise(
            task.subject, population=task.population, rng=generator(task.stream), **_budget(task)
        )
    except Exception as error:  # noqa: BLE001 (one run's fault must not cost the others)
        return _failed(task, f"{type(error).__name__}: {error}", time.perf_counter() - start)
    seconds = time.perf_counter() - start
    if not np.isfinite(result.cost):
        return _failed(task, f"the best cost is {result.cost}", seconds)
    return Record(
        task=task,
        cost=result.cost,
        x=result.x,
        history=result.history,
        evaluations=result.evaluations,
        seconds=seconds,
    )


def _budget(task: Task) -> dict[str, int]:
    if task.evaluations is None:
        return {"iterations": task.iterations}
    return {"evaluations": task.evaluations}


def _failed(task: Task, reason: str, seconds: float) -> Record:
    nothing = np.zeros(0)
    return Record(
        task=task, cost=float("nan"), x=nothing, history=nothing, evaluations=0, seconds=seconds,
        reason=reason,
    )  # fmt: skip


def run_all(
    tasks: Sequence[Task],
    executor: Executor,
    workers: int,
    keep: Callable[[list[Record]], None],
) -> None:
    """Run the tasks and hand finished records to `keep` in batches.

    An interrupt drops what has not started, waits for what has, keeps it, and is raised again.
    """
    waiting = iter(tasks)
    unkept: dict[Future[Record], Task] = {}
    try:
        _submit(executor, waiting, workers * IN_FLIGHT, unkept)
        while unkept:
            done = wait(unkept, return_when=FIRST_COMPLETED).done
            keep([_outcome(future, unkept[future]) for future in done])
            for future in done:
                del unkept[future]
            _submit(executor, waiting, len(done), unkept)
    except KeyboardInterrupt:
        started = [future for future in unkept if not future.cancel()]
        keep([_outcome(future, unkept[future]) for future in wait(started).done])
        raise


def _outcome(future: Future[Record], task: Task) -> Record:
    """Return the record of a task; one whose worker was lost for good is a failed run."""
    try:
        return future.result()
    except CancelledError:  # the whole cluster went away
        raise
    except Exception as error:  # noqa: BLE001 (what a cluster says of a task that kills its worker)
        return _failed(task, f"its worker was lost: {type(error).__name__}: {error}", 0.0)


def _submit(
    executor: Executor, tasks: Iterator[Task], count: int, unkept: dict[Future[Record], Task]
) -> None:
    for task in islice(tasks, count):
        unkept[executor.submit(execute, task)] = task
