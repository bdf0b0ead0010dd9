"""The same tasks on a Dask cluster that exists already; only this process writes the store."""

import logging
import time
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Executor, Future
from contextlib import contextmanager
from functools import cache
from typing import Any

from repro.determinism.provenance import provenance
from repro.errors import ClusterLostError, InputError
from repro.runs.plan import Task, sources_of_run
from repro.runs.run import Record, execute
from repro.runs.workers.pickling import pack, stripped, unpack
from repro.runs.workers.process import WorkerProcess

CONNECT_SECONDS = 10
BATCH_SECONDS = 1.0  # against about 5 ms that a task costs on the scheduler
COUNT_SECONDS = 5.0  # between two looks at how many workers there are
_SAME = ("python", "packages")  # what must be the same on every machine
_environment = cache(provenance)


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, Callable[[], int]]]:
    """Yield an executor on the Dask cluster at an address, and what counts its threads.

    Raises InputError where `distributed` is not installed, nobody answers or a worker has another
    version of the engine, ClusterLostError where the scheduler goes away while tasks run.
    """
    try:
        from distributed import Client  # noqa: PLC0415 (an extra that most users lack)
    except ImportError:
        message = "--dask needs the package distributed: pip install 'repro-whales[cluster]'"
        raise InputError(message) from None
    try:
        client = Client(address, timeout=CONNECT_SECONDS)
    except (OSError, ValueError) as error:
        message = f"no Dask scheduler answers at {address!r}: {error}"
        raise InputError(message) from None
    for name in ("distributed", "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)  # a lost cluster is one line
    try:
        yield ClusterExecutor(client.get_executor(pure=False), address), _Threads(client)
    except (CancelledError, OSError) as error:
        raise _lost(address, error) from None
    finally:
        client.close(timeout=1)


class ClusterExecutor(Executor):
    """Sends batches to a Dask cluster; their records come back with the worker's environment."""

    def __init__(self, inner: Executor, address: str) -> None:
        """Wrap Dask's own executor."""
        self._inner = inner
        self._address = address

    def submit(  # type: ignore[override]
        self, _: Callable[[tuple[Task, ...]], list[Record]], tasks: tuple[Task, ...], /
    ) -> Future[list[Record]]:
        """Send a batch; ClusterLostError where the scheduler is gone."""
        try:
            asked = self._inner.submit(run_packed, pack(tasks))
        except Exception as error:  # noqa: BLE001 (a client that is closed raises what it likes)
            raise _lost(self._address, error) from None
        future: Future[list[Record]] = Future()
        future.set_running_or_notify_cancel()
        asked.add_done_callback(lambda done: self._hand_on(done, tasks, future))
        return future

    def _hand_on(
        self, done: Future[dict[str, Any]], tasks: tuple[Task, ...], future: Future[list[Record]]
    ) -> None:
        try:
            answer = done.result()
            self._check(answer, tasks)
            future.set_result(
                [
                    Record(task=task, **{**values, "environment": answer["environment"]})
                    for task, values in zip(tasks, answer["records"], strict=True)
                ]
            )
        except (ImportError, AttributeError) as error:
            message = f"a worker of the cluster at {self._address!r} has another engine: {error}"
            future.set_exception(InputError(message))
        except BaseException as error:  # noqa: BLE001 (it belongs to who asked)
            future.set_exception(error)

    def _check(self, answer: dict[str, Any], tasks: tuple[Task, ...]) -> None:
        """Raise InputError where a worker is not the same program as this."""
        here, there = _environment(), answer["environment"]
        differing = [name for name in _SAME if here[name] != there[name]]
        if answer["sources"] != _sources(tasks):
            differing.append("sources")
        if differing:
            found = "; ".join(
                f"{name}: {there.get(name, 'others')} there, {here.get(name, 'these')} here"
                for name in differing
            )
            message = f"a worker of the cluster at {self._address!r} has another engine: {found}"
            raise InputError(message)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: FBT001, FBT002 (as in the class that it is made from)
        """Do nothing: the cluster and its client belong to others."""


class _Threads:
    """Counts the threads of a cluster, now and then, as workers come and go."""

    def __init__(self, client: Any) -> None:  # noqa: ANN401 (an extra that ships no types)
        self._client = client
        self._counted = -COUNT_SECONDS
        self._count = 1

    def __call__(self) -> int:
        """Return the number of threads, at least 1, as of some seconds ago."""
        now = time.monotonic()
        if now - self._counted > COUNT_SECONDS:
            self._count = sum(self._client.nthreads().values()) or 1
            self._counted = time.monotonic()
        return self._count


def run_packed(payload: bytes) -> dict[str, Any]:
    """Return the records of a batch without their tasks, and what made them; runs on a worker."""
    tasks = unpack(payload)
    return {
        "environment": _environment(),
        "sources": _sources(tasks),
        "records": [stripped(record) for record in _made(tasks)],
    }


def _made(tasks: tuple[Task, ...]) -> Iterator[Record]:
    """Yield the records of a batch; searches of users have a process, which can be given up."""
    apart = WorkerProcess()
    try:
        for task in tasks:
            own = hasattr(task.optimiser, "prepare")
            yield apart.execute(task) if own else execute(task)
    finally:
        apart.close()


def _sources(tasks: tuple[Task, ...]) -> list[str]:
    return sorted({sources_of_run(task.optimiser, task.subject) for task in tasks})


def _lost(address: str, error: BaseException) -> ClusterLostError:
    why = type(error).__name__
    message = f"the cluster at {address!r} was lost ({why}); run the same command again"
    return ClusterLostError(message)
