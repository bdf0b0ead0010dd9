from collections import Counter
from collections.abc import Callable
from concurrent.futures import CancelledError, Executor, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from queue import SimpleQueue
from threading import Event, Lock, Timer
from typing import Any, Unpack

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from repro.errors import InputError
from repro.optimisers import WOA
from repro.optimisers.search import Budget, Problem, Result
from repro.runs.plan import Task, plan
from repro.runs.run import Record, execute
from repro.runs.workers import dispatch
from repro.runs.workers.dispatch import run_all
from tests.budgets import examples
from tests.small_papers import EXPERIMENT, PAPER, Failing, Guessing, searching

TASKS = plan([replace(PAPER, experiments=(replace(EXPERIMENT, runs=50),))], 1)


def names(tasks: tuple[Task, ...] | list[Task]) -> list[str]:
    return [task.name for task in tasks]


def kept(tasks: tuple[Task, ...], workers: int, batch_seconds: float = 0.0) -> list[Record]:
    records: list[Record] = []
    with ThreadPoolExecutor(workers) as executor:
        run_all(tasks, executor, workers, records.extend, batch_seconds=batch_seconds)
    return records


def same(first: Record, second: Record) -> bool:
    return (
        first.task is second.task
        and first.cost == second.cost
        and first.x.tobytes() == second.x.tobytes()
        and first.history.tobytes() == second.history.tobytes()
    )


@settings(deadline=None, max_examples=examples(20))
@given(st.integers(0, len(TASKS)), st.integers(1, 6), st.sampled_from([0.0, 0.001, 10.0]))
def test_every_task_is_run_exactly_once(count: int, workers: int, batch_seconds: float) -> None:
    records = kept(TASKS[:count], workers, batch_seconds)

    assert Counter(record.task.name for record in records) == Counter(names(TASKS[:count]))


def test_every_record_is_that_of_its_own_task() -> None:
    alone = {record.task.name: record for record in map(execute, TASKS)}

    assert all(same(record, alone[record.task.name]) for record in kept(TASKS, 3))


def test_failed_run_costs_no_other() -> None:
    tasks = plan([searching(good=Guessing(), bad=Failing(), worse=Failing(cost=float("nan")))], 2)

    failed = Counter(record.task.algorithm for record in kept(tasks, 2) if record.reason)

    assert failed == {"bad": 6, "worse": 6}


def test_compiled_search_gives_the_same_bits_in_any_thread() -> None:
    problem = searching(WOA=WOA())
    experiment = replace(problem.experiments[0], problems={"sphere": _sphere()}, runs=8)
    tasks = plan([replace(problem, experiments=(experiment,))], 1)

    alone = {task.name: execute(task) for task in tasks}

    assert all(same(record, alone[record.task.name]) for record in kept(tasks, 4))


def _sphere() -> Any:  # noqa: ANN401 (any problem)
    from repro.functions import FUNCTIONS  # noqa: PLC0415 (compiled only where it is needed)

    return FUNCTIONS["sphere"].problem(3)


def test_few_tasks_are_handed_out_at_a_time() -> None:
    waiting: list[int] = []

    class Counting(ThreadPoolExecutor):
        def submit(self, *args: Any, **_: Any) -> Future[Any]:  # noqa: ANN401
            future: Future[Any] = super().submit(*args)
            unfinished.append(future)
            waiting.append(sum(not known.done() for known in unfinished))
            return future

    unfinished: list[Future[Any]] = []
    with Counting(2) as executor:
        run_all(TASKS, executor, 2, lambda _: None, batch_seconds=0.0)

    assert len(waiting) == len(TASKS)
    assert max(waiting) <= 2 * dispatch.IN_FLIGHT


def test_every_finished_task_makes_room_for_another() -> None:
    class AtOnce(ThreadPoolExecutor):
        def submit(self, *args: Any, **_: Any) -> Future[Any]:  # noqa: ANN401
            future: Future[Any] = super().submit(*args)
            wait([future])
            return future

    batches: list[int] = []
    with AtOnce(2) as executor:
        run_all(
            TASKS[:50], executor, 2, lambda records: batches.append(len(records)), batch_seconds=0.0
        )

    assert batches == [6] * 8 + [2]


@dataclass(frozen=True)
class Watched:
    """A search that counts its runs and can be held back."""

    done: list[int]
    gate: Event
    lock: Lock
    identity = "held back"  # a lock has no value that could be told

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:  # noqa: ARG002
        """Wait for the gate, then count."""
        self.gate.wait(5)
        with self.lock:
            self.done.append(1)
        return Result(x=np.zeros(2), cost=1.0, history=np.zeros(1), evaluations=1)


class StopsAt(ThreadPoolExecutor):
    """An executor that is interrupted when it is handed its n-th task."""

    def __init__(self, workers: int, n: int) -> None:
        """Count down from n."""
        super().__init__(workers)
        self.left = n

    def submit(self, *args: Any, **_: Any) -> Future[Any]:  # noqa: ANN401
        """Submit, or stop."""
        self.left -= 1
        if not self.left:
            raise KeyboardInterrupt
        return super().submit(*args)


def interrupted(
    executor: Executor, *, stop: Callable[[], None] = lambda: None, held: float = 0.0
) -> tuple[list[Record], int]:
    """Return the records that an interrupted call keeps, and how many runs it made.

    `stop` is called before records are kept; no run ends before `held` seconds have passed.
    """
    watched = Watched([], Event(), Lock())
    paper = searching(watched=watched)
    tasks = plan([replace(paper, experiments=(replace(paper.experiments[0], runs=50),))], 1)
    records: list[Record] = []

    def keep(finished: list[Record]) -> None:
        stop()
        records.extend(finished)

    Timer(held, watched.gate.set).start()
    with executor, pytest.raises(KeyboardInterrupt):
        run_all(tasks, executor, 2, keep, batch_seconds=0.0)
    assert len({record.task.name for record in records}) == len(records)
    return records, len(watched.done)


def at_call(n: int) -> Callable[[], None]:
    calls: list[None] = []

    def stop() -> None:
        calls.append(None)
        if len(calls) == n:
            raise KeyboardInterrupt

    return stop


@pytest.mark.parametrize("n", [1, 3])
def test_interrupt_while_records_are_kept_keeps_every_finished_run(n: int) -> None:
    records, made = interrupted(ThreadPoolExecutor(2), stop=at_call(n))

    assert 0 < len(records) == made < 50


def test_interrupt_while_waiting_keeps_every_finished_run(monkeypatch: pytest.MonkeyPatch) -> None:
    stop = at_call(3)

    class Stopping(SimpleQueue[Any]):
        def get(self, *args: Any, **named: Any) -> Any:  # noqa: ANN401
            stop()
            return super().get(*args, **named)

    monkeypatch.setattr("repro.runs.workers.dispatch.SimpleQueue", Stopping)

    records, made = interrupted(ThreadPoolExecutor(2))

    assert 0 < len(records) == made < 50


@pytest.mark.parametrize("n", [5, 12])
def test_interrupt_while_tasks_are_handed_out_keeps_every_finished_run(n: int) -> None:
    records, made = interrupted(StopsAt(2, n))

    assert 0 < len(records) == made < n


def test_interrupt_drops_what_has_not_started() -> None:
    records, made = interrupted(StopsAt(2, 5), held=0.3)

    assert len(records) == made == 2


class Losing(ThreadPoolExecutor):
    """Loses the worker of every batch with certain runs, as a cluster does that they kill."""

    def __init__(self, workers: int, *deadly: int) -> None:
        """Note which runs are deadly."""
        super().__init__(workers)
        self.deadly = set(deadly)
        self.batches: list[list[int]] = []

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **_: Any) -> Future[Any]:  # noqa: ANN401
        """Run the batch, or say that its worker is gone."""
        runs = [task.run for task in arguments[0]]
        self.batches.append(runs)
        if self.deadly.isdisjoint(runs):
            return super().submit(function, *arguments)
        gone: Future[Any] = Future()
        gone.set_exception(RuntimeError("the worker is gone"))
        return gone


@pytest.mark.parametrize("batch_seconds", [0.0, 10.0])
def test_task_whose_worker_is_lost_is_named_and_costs_no_other(batch_seconds: float) -> None:
    found: list[Record] = []

    with Losing(2, 7, 40) as executor:
        run_all(TASKS[:50], executor, 2, found.extend, batch_seconds=batch_seconds)

    assert Counter(record.task.name for record in found) == Counter(names(TASKS[:50]))
    reasons = {record.task.run: record.reason for record in found if record.reason}
    assert reasons == dict.fromkeys(
        (7, 40), "its worker was lost: RuntimeError: the worker is gone"
    )


def test_batch_whose_worker_is_lost_is_tried_once_more_run_by_run() -> None:
    with Losing(1, 30) as executor:
        run_all(TASKS[:50], executor, 1, lambda _: None, batch_seconds=10.0)

    (lost,) = [runs for runs in executor.batches if 30 in runs and len(runs) > 1]
    assert executor.batches[-len(lost) :] == [[run] for run in lost]


@pytest.mark.parametrize("error", [CancelledError(), InputError("another engine")])
def test_whole_cluster_that_is_lost_or_unfit_ends_the_call(error: Exception) -> None:
    class Gone(ThreadPoolExecutor):
        def submit(self, *_: Any, **__: Any) -> Future[Any]:  # noqa: ANN401
            gone: Future[Any] = Future()
            gone.set_exception(error)
            return gone

    with pytest.raises(type(error)), Gone(1) as executor:
        run_all(TASKS[:3], executor, 1, lambda _: None)


def test_number_of_workers_may_grow_while_tasks_run() -> None:
    counts = iter([1, 1] + [4] * 1000)
    waiting: list[int] = []

    class Growing(ThreadPoolExecutor):
        def submit(self, *args: Any, **_: Any) -> Future[Any]:  # noqa: ANN401
            future: Future[Any] = super().submit(*args)
            flying.append(future)
            waiting.append(sum(not known.done() for known in flying))
            return future

    flying: list[Future[Any]] = []
    with Growing(1) as executor:
        run_all(TASKS, executor, lambda: next(counts), lambda _: None, batch_seconds=0.0)

    assert dispatch.IN_FLIGHT < max(waiting) <= 4 * dispatch.IN_FLIGHT


def test_tasks_are_taken_as_they_are_needed() -> None:
    taken: list[Task] = []
    most: list[int] = []
    kept: list[Record] = []

    def planned() -> Any:  # noqa: ANN401
        for task in TASKS:
            taken.append(task)
            yield task

    def keep(records: list[Record]) -> None:
        most.append(len(taken) - len(kept))
        kept.extend(records)

    with ThreadPoolExecutor(1) as executor:
        run_all(planned(), executor, 1, keep, batch_seconds=0.0)

    assert len(kept) == len(TASKS)
    assert max(most) <= dispatch.IN_FLIGHT
