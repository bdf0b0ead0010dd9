import os
import re
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from threading import Timer
from typing import ClassVar

import pytest

from repro.runs.plan import Task
from repro.runs.run import Record, execute
from repro.runs.workers.process import StoppedError, WorkerProcess
from tests.held_searches import Interrupting, Telling, deadly, tasks_of
from tests.runs.test_run import same
from tests.small_papers import LOST, Failing, Guessing

ROOT = Path(__file__).parents[3]


@pytest.fixture
def worker() -> Iterator[WorkerProcess]:
    """Return a worker whose process is gone after the test."""
    worker = WorkerProcess()
    yield worker
    worker.kill()


def is_alive(process: int) -> bool:
    """Return whether a process runs; one that waits to be buried does not."""
    try:
        state = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2]
    except FileNotFoundError:
        return False
    return state.split()[0] != "Z"


def test_run_in_a_process_gives_the_bits_of_one_here(worker: WorkerProcess) -> None:
    for task in tasks_of(guess=Guessing(), wide=Guessing(width=3.0)):
        assert same(worker.execute(task), execute(task))


def test_one_process_makes_many_runs(worker: WorkerProcess) -> None:
    made_in = {worker.execute(task).evaluations for task in tasks_of(telling=Telling())}

    assert len(made_in) == 1
    assert os.getpid() not in made_in


def test_fault_of_a_run_is_its_outcome(worker: WorkerProcess) -> None:
    record = worker.execute(tasks_of(bad=Failing())[0])

    assert record.reason == LOST


@pytest.mark.parametrize(("prepared", "text"), [(False, "enough"), (True, "")])
def test_search_that_interrupts_is_a_failed_run_and_its_process_lives_on_in_silence(
    worker: WorkerProcess, capfd: pytest.CaptureFixture[str], *, prepared: bool, text: str
) -> None:
    first = worker.execute(tasks_of(telling=Telling())[0]).evaluations

    record = worker.execute(tasks_of(bad=Interrupting(prepared=prepared))[0])

    said = rf"KeyboardInterrupt: {text} \(held_searches.py, line \d+\)"
    assert re.fullmatch(said, record.reason or ""), record.reason
    assert worker.execute(tasks_of(telling=Telling())[0]).evaluations == first
    assert capfd.readouterr().err == ""


def test_task_that_cannot_travel_runs_here(worker: WorkerProcess) -> None:
    @dataclass(frozen=True)
    class Hidden(Telling):
        holds_interpreter: ClassVar[bool] = True

        def minimise(self, problem: object, **budget: object) -> object:  # type: ignore[override]
            return Telling().minimise(problem, **budget)  # type: ignore[arg-type]

    assert worker.execute(tasks_of(hidden=Hidden())[0]).evaluations == os.getpid()  # type: ignore[arg-type]


def test_task_of_a_module_that_the_process_lacks_runs_here(
    worker: WorkerProcess, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "brought_along.py").write_text(
        "from tests.held_searches import Telling\nclass Brought(Telling): pass\n"
    )
    with monkeypatch.context() as patch:
        patch.syspath_prepend(tmp_path)
        import brought_along  # type: ignore[import-not-found]  # noqa: PLC0415

    record = worker.execute(tasks_of(brought=brought_along.Brought())[0])

    assert record.evaluations == os.getpid()


@pytest.mark.parametrize("lives", [1, 2])
def test_run_whose_process_dies_is_made_again(
    worker: WorkerProcess, tmp_path: Path, lives: int
) -> None:
    task = tasks_of(guess=deadly(tmp_path, lives))[0]

    record = worker.execute(task)

    assert list(tmp_path.iterdir()) == []
    assert record.reason is None
    assert same(record, harmless(task))


def harmless(task: Task) -> Record:
    """Return what the same run gives that kills nothing."""
    (plain,) = (other for other in tasks_of(guess=Guessing()) if other.name == task.name)
    return replace(execute(plain), task=task)


def test_task_that_kills_every_process_is_named_after_three_tries(
    worker: WorkerProcess, tmp_path: Path
) -> None:
    record = worker.execute(tasks_of(guess=deadly(tmp_path, 5))[0])

    assert record.reason == "its worker died 3 times, the last time by SIGKILL"
    assert len(list(tmp_path.iterdir())) == 2
    assert worker.execute(tasks_of(telling=Telling())[0]).reason is None


def test_process_that_is_killed_from_outside_is_replaced(worker: WorkerProcess) -> None:
    quick, slow = tasks_of(telling=Telling())[0], tasks_of(slow=Telling(seconds=0.5))[0]
    first = worker.execute(quick).evaluations

    Timer(0.2, os.kill, (first, signal.SIGKILL)).start()
    record = worker.execute(slow)

    assert record.reason is None
    assert record.evaluations not in {first, os.getpid()}


def test_worker_that_is_told_to_stop_gives_its_run_up_and_starts_no_other(
    tmp_path: Path,
) -> None:
    ended = tmp_path / "ended"
    worker = WorkerProcess()
    worker.execute(tasks_of(telling=Telling())[0])
    Timer(0.2, worker.kill).start()

    for _ in range(2):
        with pytest.raises(StoppedError):
            worker.execute(tasks_of(slow=Telling(seconds=60.0, ended=str(ended)))[0])

    assert not ended.exists()


def test_closed_worker_leaves_no_process() -> None:
    worker = WorkerProcess()
    process = worker.execute(tasks_of(telling=Telling())[0]).evaluations

    worker.close()

    assert not is_alive(process)


def test_process_ends_with_its_driver_in_the_middle_of_a_run() -> None:
    program = """
        from repro.runs.workers.process import WorkerProcess
        from tests.held_searches import Telling, tasks_of
        worker = WorkerProcess()
        print(worker.execute(tasks_of(telling=Telling())[0]).evaluations, flush=True)
        worker.execute(tasks_of(slow=Telling(seconds=600.0))[0])
    """
    with subprocess.Popen(
        (sys.executable, "-c", textwrap.dedent(program)), cwd=ROOT, stdout=subprocess.PIPE
    ) as driver:
        assert driver.stdout is not None
        process = int(driver.stdout.readline())
        time.sleep(0.2)  # until it is at the slow run
        assert is_alive(process)
        driver.kill()

    limit = time.monotonic() + 120  # seconds for a busy machine; it takes a moment
    while is_alive(process) and time.monotonic() < limit:
        time.sleep(0.02)
    alive = is_alive(process)
    with suppress(ProcessLookupError):
        os.kill(process, signal.SIGKILL)
    assert not alive
