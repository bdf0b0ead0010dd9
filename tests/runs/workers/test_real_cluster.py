"""A real Dask scheduler and worker processes on loopback; `nox -s cluster` runs all of it."""

import os
import socket
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from functools import partial
from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from repro.determinism.provenance import provenance
from repro.errors import ClusterLostError, InputError
from repro.runs.plan import Task, plan
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.workers.dask_cluster import BATCH_SECONDS, cluster
from repro.runs.workers.local import local
from tests.held_searches import Held, Telling, deadly, many, tasks_of

pytest.importorskip("distributed", reason="the extra `cluster` is not installed")

ROOT = Path(__file__).parents[3]
WHOLE = os.environ.get("REPRO_CLUSTER") == "whole"
WORKERS = 4
IDLE_SECONDS = 3
PATIENCE_SECONDS = 5
STARTING_SECONDS = 60  # a busy machine takes a while to load Dask
SAME = "key, paper, experiment, problem, algorithm, repeat, run, cost, x, evaluations, reason, y"
"""Columns that say what a run gave; how long it took is another matter."""

Report = Callable[[int, int], None]


class Dask:
    """A scheduler and its workers, each a process that can be killed."""

    def __init__(self, folder: Path) -> None:
        """Choose a port that is free."""
        self.folder = folder
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.workers: list[subprocess.Popen[bytes]] = []

    def start(self, workers: int, nanny: str = "--no-nanny") -> None:
        """Start the scheduler and workers of one thread each; a nanny replaces those that die."""
        self.scheduler = self._start("dask_scheduler", "--port", str(self.port))
        limit = time.monotonic() + STARTING_SECONDS
        while not self._listens() and time.monotonic() < limit:
            time.sleep(0.1)
        self.workers = [
            self._start(
                "dask_worker", self.address, "--nthreads", "1", nanny, "--death-timeout", "30"
            )
            for _ in range(workers)
        ]

    def _listens(self) -> bool:
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def _start(self, program: str, *arguments: str) -> subprocess.Popen[bytes]:
        options = (*arguments, "--host", "127.0.0.1", "--no-dashboard")
        return subprocess.Popen(
            (sys.executable, "-m", f"distributed.cli.{program}", *options),
            cwd=self.folder,
            env={**os.environ, "PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1"},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def stop(self) -> None:
        """Kill whatever still runs."""
        for process in self.workers:
            process.terminate()  # so that a nanny takes its worker along
        for process in (*self.workers, self.scheduler):
            with suppress(subprocess.TimeoutExpired):
                process.wait(PATIENCE_SECONDS if process is not self.scheduler else 0)
            process.kill()
            process.wait()


@pytest.fixture
def dask(tmp_path: Path) -> Iterator[Dask]:
    """Return a cluster that is started by the test and killed after it."""
    dask = Dask(tmp_path)
    yield dask
    dask.stop()


def run(store: Path, tasks: tuple[Task, ...], dask: Dask | None, report: Report) -> int:
    """Run what a store lacks on a cluster, or here, and return the number of failed runs."""
    with Store(store) as opened:
        if dask is None:
            with local(2) as executor:
                failed = run_missing(
                    opened,
                    tasks,
                    executor=executor,
                    workers=2,
                    environment=provenance,
                    report=report,
                )
        else:
            with cluster(dask.address) as (executor, threads):
                failed = run_missing(
                    opened,
                    tasks,
                    executor=executor,
                    workers=threads,
                    environment=provenance,
                    report=report,
                    batch_seconds=BATCH_SECONDS if WHOLE else 0.1,
                )
    return len(failed)


def rows(store: Path) -> list[tuple[object, ...]]:
    """Return what the runs of a store gave."""
    query = f"select {SAME}, json from run join curve using (id) join env on env.id = run.env"  # noqa: S608
    with closing(sqlite3.connect(store / "runs.sqlite")) as database:
        return sorted(database.execute(query))


def quiet(_done: int, _total: int) -> None:
    """Say nothing."""


def protocol() -> tuple[Task, ...]:
    """Return every run of all papers, or those of one problem, and runs that hold Python."""
    papers = all_papers()
    if WHOLE:
        return (*plan(papers.values(), 1), *plan([many(Held(), 30)], 1))
    # every worker loads the code of every search on every problem that it meets
    part = (task for task in plan([papers["smwoa2022"]], 1) if task.problem == "F1")
    return (*part, *tasks_of(guess=Held()))


def test_cluster_that_loses_workers_and_its_scheduler_gives_the_rows_of_this_machine(
    dask: Dask, tmp_path: Path
) -> None:
    tasks = protocol()
    dask.start(WORKERS)

    def lose(done: int, total: int) -> None:
        alive = [worker for worker in dask.workers if worker.poll() is None]
        if len(alive) > WORKERS - 2 and done > total * (WORKERS + 1 - len(alive)) // 10:
            alive[0].kill()
        if done > total // 2:
            dask.scheduler.kill()

    with pytest.raises(ClusterLostError, match="run the same command again") as lost:
        run(tmp_path / "far", tasks, dask, lose)
    kept = len(rows(tmp_path / "far"))
    killed = sum(worker.poll() is not None for worker in dask.workers)
    dask.stop()
    dask.start(2)
    states: list[int] = []
    failed = run(tmp_path / "far", tasks, dask, lambda done, _total: states.append(done))
    run(tmp_path / "near", tasks, None, quiet)

    assert lost.value.exit_code == 75
    assert killed >= 2
    assert len(tasks) // 2 < kept < len(tasks)
    assert states[-1] == len(tasks) - kept
    assert failed == 0
    assert rows(tmp_path / "far") == rows(tmp_path / "near")
    assert len(rows(tmp_path / "far")) == len(tasks)


def test_task_that_kills_its_workers_is_named_and_the_others_finish(
    dask: Dask, tmp_path: Path
) -> None:
    (tmp_path / "lives").mkdir()
    tasks = (
        *tasks_of(deadly=deadly(tmp_path / "lives", 8))[:1],
        *tasks_of(telling=Telling()),
    )
    dask.start(2, "--nanny")

    failed = run(tmp_path / "store", tasks, dask, quiet)

    assert failed == 1
    with Store(tmp_path / "store") as store:
        reasons = {record.task.name: record.reason for record in store.records(tasks)}
    assert "KilledWorker" in str(reasons.pop(tasks[0].name))
    assert list(reasons.values()) == [None] * 3


def test_cluster_without_the_papers_is_refused_in_one_line(dask: Dask, tmp_path: Path) -> None:
    dask.start(1)
    here = tmp_path / "here"  # not where the workers are started
    here.mkdir()
    (here / "only_here.py").write_text(
        "from tests.small_papers import Guessing\nclass Here(Guessing): pass\n"
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(here)
        import only_here  # type: ignore[import-not-found]  # noqa: PLC0415

    with pytest.raises(InputError, match="has another engine: No module named 'only_here'"):
        run(tmp_path / "store", tasks_of(here=only_here.Here()), dask, quiet)


def spent_by(processes: tuple[int, ...]) -> float:
    """Return the processor time of processes, in s."""
    stats = (Path(f"/proc/{process}/stat").read_text(encoding="utf-8") for process in processes)
    ticks = (int(part) for stat in stats for part in stat.rpartition(")")[2].split()[11:13])
    return sum(ticks) / os.sysconf("SC_CLK_TCK")


@pytest.mark.cluster
def test_handing_runs_out_costs_less_than_a_twentieth_of_making_them(
    dask: Dask, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tasks = plan([all_papers()["smwoa2022"]], 1)
    first, rest = tasks[::60], [task for k, task in enumerate(tasks) if k % 60]
    dask.start(2)
    overhead = dask.scheduler.pid, os.getpid()
    compute = tuple(worker.pid for worker in dask.workers)

    with Store(tmp_path / "store") as store, cluster(dask.address) as (executor, threads):
        go = partial(run_missing, store, executor=executor, workers=threads, report=quiet)
        go(first, environment=provenance)  # loads and compiles everything
        start = spent_by(overhead)
        time.sleep(IDLE_SECONDS)
        idle = (spent_by(overhead) - start) / IDLE_SECONDS
        before = time.monotonic(), spent_by(overhead), spent_by(compute)
        go(rest, environment=provenance, batch_seconds=BATCH_SECONDS)
        after = time.monotonic(), spent_by(overhead), spent_by(compute)

    # of the processors, so that what else the machine does is no cost of the cluster
    wall, handing, making = (end - start for start, end in zip(before, after, strict=True))
    handing -= idle * wall  # what Dask spends on no runs at all
    with capsys.disabled():
        sys.stdout.write(f"\n{handing:.2f} s to hand out what took {making:.1f} s to make\n")
    assert handing < 0.05 * making
