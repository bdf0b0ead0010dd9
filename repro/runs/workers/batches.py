"""Tasks in batches that take about equally long, so that short runs cost no more to hand out."""

from collections.abc import Iterable, Iterator

from repro.runs.plan import Task
from repro.runs.run import Record

MOST = 200  # runs of a batch, so that none is lost or late in large numbers
SMOOTHING = 0.5  # weight of the latest batch in what a run is thought to take


class Batches:
    """Hands out tasks in their order, in batches of about so many seconds.

    What a run takes is learnt from the finished runs of its cell; runs of a cell of which none is
    finished are thought to cost as much per agent and iteration as the slowest known ones, and
    before anything is known a batch is one run.
    """

    def __init__(self, tasks: Iterable[Task], seconds: float) -> None:
        """Take nothing yet: the tasks may be many more than fit in memory."""
        self._tasks = iter(tasks)
        self._seconds = seconds
        self._next: Task | None = None
        self._known: dict[tuple[str, ...], float] = {}
        self._slowest = float("inf")  # seconds per agent and iteration

    def __iter__(self) -> Iterator[tuple[Task, ...]]:
        """Return itself."""
        return self

    def __next__(self) -> tuple[Task, ...]:
        """Return the next batch."""
        batch = [self._next or next(self._tasks)]
        self._next = None
        seconds = self._estimate(batch[0])
        while len(batch) < MOST and seconds < self._seconds:
            task = next(self._tasks, None)
            if task is None:
                break
            seconds += self._estimate(task)
            if seconds > self._seconds:
                self._next = task
                break
            batch.append(task)
        return tuple(batch)

    def learn(self, records: Iterable[Record]) -> None:
        """Note how long runs took."""
        slowest = 0.0
        for record in records:
            cell = _cell(record.task)
            before = self._known.get(cell, record.seconds)
            self._known[cell] = before + SMOOTHING * (record.seconds - before)
            slowest = max(slowest, record.seconds / _size(record.task))
        if slowest:
            self._slowest = slowest

    def _estimate(self, task: Task) -> float:
        known = self._known.get(_cell(task))
        return self._slowest * _size(task) if known is None else known


def _cell(task: Task) -> tuple[str, ...]:
    return task.paper, task.experiment, task.problem, task.algorithm


def _size(task: Task) -> int:
    return max(1, task.population * task.iterations)
