import os
import random
import signal
from collections import Counter
from concurrent.futures import Executor
from pathlib import Path
from threading import Thread, active_count, current_thread

import pytest

from repro.errors import InputError
from repro.optimisers import WOA
from repro.runs.plan import Task, plan
from repro.runs.run import Record, execute, execute_all
from repro.runs.workers.dispatch import run_all
from repro.runs.workers.local import LocalExecutor, checked_workers, local, usable_cores
from tests.held_searches import Free, Telling, appears, deadly, many, on_rosenbrock, tasks_of
from tests.runs.test_run import same
from tests.runs.workers.test_process import is_alive
from tests.small_papers import Guessing


@pytest.mark.parametrize("workers", [0, -3])
def test_less_than_one_worker_is_refused(workers: int) -> None:
    with (
        pytest.raises(InputError, match=f"workers is {workers}; it must be 1 or more"),
        local(workers),
    ):
        pass


def test_more_workers_than_can_be_started_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    before, start = active_count(), Thread.start
    started: list[Thread] = []

    def third_fails(thread: Thread) -> None:
        if len(started) == 2:
            message = "can't start new thread"
            raise RuntimeError(message)
        start(thread)
        started.append(thread)

    monkeypatch.setattr(Thread, "start", third_fails)

    with (
        pytest.raises(InputError, match="workers is 9; no more than 2 can be started here"),
        local(9),
    ):
        pass

    for thread in started:
        thread.join(10)
    assert active_count() == before


def test_cores_are_those_that_this_process_may_use(monkeypatch: pytest.MonkeyPatch) -> None:
    assert 1 <= usable_cores() <= (os.cpu_count() or 1)

    monkeypatch.delattr(os, "sched_getaffinity", raising=False)

    assert usable_cores() == (os.cpu_count() or 1)


def test_workers_are_the_usable_cores_unless_they_are_named() -> None:
    assert checked_workers(None) == usable_cores()
    assert checked_workers(3) == 3
    with pytest.raises(InputError, match="workers is 0"):
        checked_workers(0)


def run(tasks: tuple[Task, ...], executor: Executor, workers: int = 2) -> dict[str, Record]:
    """Return the records of tasks by name."""
    records: list[Record] = []
    run_all(tasks, executor, workers, records.extend)
    assert len(records) == len({record.task.name for record in records})
    return {record.task.name: record for record in records}


@pytest.mark.parametrize("workers", [1, 2, 4])
@pytest.mark.parametrize("processes", [False, True])
def test_runs_give_the_same_bits_in_threads_and_processes(workers: int, processes: bool) -> None:  # noqa: FBT001
    tasks = plan([on_rosenbrock(guess=Guessing(), WOA=WOA())], 1)

    with local(workers, processes=processes) as executor:
        found = run(tasks, executor, workers)

    assert found.keys() == {task.name for task in tasks}
    assert all(same(record, execute(record.task)) for record in found.values())


def test_only_what_holds_the_interpreter_leaves_this_process() -> None:
    held, free = tasks_of(telling=Telling()), tasks_of(telling=Free())

    with local(2) as executor:
        apart, here = (
            {record.evaluations for record in executor.submit(execute_all, tasks).result()}
            for tasks in (held, free)
        )

    assert os.getpid() not in apart
    assert here == {os.getpid()}


def test_other_calls_run_in_threads_of_this_process() -> None:
    with local(2) as executor:
        names = set(executor.map(lambda _: (os.getpid(), current_thread().name[:3]), range(20)))

    assert names == {(os.getpid(), "run")}


def test_error_of_a_call_is_that_of_its_future_and_costs_no_other() -> None:
    with local(1) as executor:
        bad, good = executor.submit(int, "x"), executor.submit(int, "1")

        assert isinstance(bad.exception(), ValueError)
        assert good.result() == 1


def test_lost_process_costs_no_other_run(tmp_path: Path) -> None:
    tasks = tasks_of(telling=Telling(), deadly=deadly(tmp_path, 1), guess=Guessing())

    with local(2) as executor:
        found = run(tasks, executor)

    assert len(found) == 9
    assert [record.reason for record in found.values() if record.reason] == []


def test_task_that_kills_its_process_is_named_and_the_others_finish(tmp_path: Path) -> None:
    tasks = tasks_of(deadly=deadly(tmp_path, 3), telling=Telling())

    with local(1) as executor:
        found = run(tasks, executor, workers=1)

    assert {name: record.reason for name, record in found.items() if record.reason} == {
        tasks[0].name: "its worker died 3 times, the last time by SIGKILL"
    }
    assert len(found) == 6


def test_processes_that_are_killed_at_random_cost_nothing() -> None:
    tasks = plan([many(Telling(seconds=0.01), runs=100)], 1)
    chance = random.Random(7)  # noqa: S311 (chaos, not secrets)
    killed: list[int] = []
    records: list[Record] = []

    def keep(found: list[Record]) -> None:
        records.extend(found)
        if len(killed) < 5 and (alive := [r.evaluations for r in found if is_alive(r.evaluations)]):
            killed.append(chance.choice(alive))
            os.kill(killed[-1], signal.SIGKILL)

    with local(2) as executor:
        run_all(tasks, executor, 2, keep)

    assert len(killed) == len(set(killed)) == 5
    assert Counter(record.task.name for record in records) == Counter(t.name for t in tasks)
    assert all(record.reason is None for record in records)
    assert {record.task.name: record.cost for record in records} == {
        task.name: execute(task).cost for task in plan([many(Guessing(), runs=100)], 1)
    }


def test_cancelled_executor_ends_a_batch_after_the_run_that_it_is_at(tmp_path: Path) -> None:
    ended = tmp_path / "ended"
    tasks = plan([many(Telling(seconds=0.5, ended=str(ended)), runs=50)], 1)
    executor = LocalExecutor(1)
    started, waiting = (executor.submit(execute_all, part) for part in (tasks[:25], tasks[25:]))
    assert appears(ended)

    executor.shutdown(cancel_futures=True)

    assert 0 < len(started.result(0)) < 25
    assert waiting.cancelled()
    with pytest.raises(RuntimeError, match="shut down"):
        executor.submit(execute_all, tasks)


def test_failing_session_waits_for_no_run_and_leaves_no_process(tmp_path: Path) -> None:
    ended = tmp_path / "ended"
    endless = Telling(seconds=60.0, ended=str(ended))
    quick, slow = tasks_of(telling=Telling())[:1], tasks_of(slow=endless)[:1]

    def fail() -> int:
        with local(1) as executor:
            process = executor.submit(execute_all, quick).result()[0].evaluations
            executor.submit(execute_all, slow)
            processes.append(process)
            raise ZeroDivisionError

    processes: list[int] = []
    with pytest.raises(ZeroDivisionError):
        fail()

    assert not ended.exists()
    assert not is_alive(processes[0])


def test_finished_session_leaves_no_process() -> None:
    with local(2) as executor:
        found = run(tasks_of(telling=Telling(), also=Telling()), executor)

    assert not any(is_alive(record.evaluations) for record in found.values())
