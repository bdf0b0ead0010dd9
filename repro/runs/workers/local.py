"""Where tasks run on this machine: threads, each with a process at hand where it needs one."""

import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager, suppress
from queue import Empty, SimpleQueue
from threading import Event, Thread
from typing import Any, ParamSpec, TypeVar

from repro.errors import InputError
from repro.runs.plan import Task
from repro.runs.run import Record, execute, execute_all, holds_interpreter
from repro.runs.workers.process import StoppedError, WorkerProcess

P = ParamSpec("P")
T = TypeVar("T")
_Work = tuple[Future[Any], Callable[..., Any], tuple[Any, ...], dict[str, Any]]


def usable_cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def checked_workers(workers: int | None) -> int:
    """Return the number of workers, the usable cores for None; InputError below 1."""
    if workers is None:
        return usable_cores()
    if workers < 1:
        message = f"workers is {workers}; it must be 1 or more"
        raise InputError(message)
    return workers


class LocalExecutor(Executor):
    """Threads of this process; runs that hold the interpreter go to a process per thread.

    Compiled searches release the interpreter lock and stay in their thread, unless `processes`
    sends every run to a process. A process that dies costs the run that it was at, which is tried
    again; none outlives the driver.
    """

    def __init__(self, workers: int, *, processes: bool = False) -> None:
        """Start the threads; InputError for less than one worker, or more than can be started."""
        self._processes = processes
        self._work: SimpleQueue[_Work | None] = SimpleQueue()
        self._stopped = Event()
        self._workers = [WorkerProcess() for _ in range(checked_workers(workers))]
        # daemons: an interrupt must not have to wait for a run of an hour
        self._threads = [
            Thread(target=self._serve, args=(worker,), name=f"run-{k}", daemon=True)
            for k, worker in enumerate(self._workers, 1)
        ]
        for started, thread in enumerate(self._threads):
            try:
                thread.start()
            except RuntimeError:
                for _ in range(started):
                    self._work.put(None)
                message = f"workers is {workers}; no more than {started} can be started here"
                raise InputError(message) from None

    def submit(
        self, function: Callable[P, T], /, *arguments: P.args, **named: P.kwargs
    ) -> Future[T]:
        """Queue a call; RuntimeError after `shutdown`."""
        if self._stopped.is_set():
            message = "the executor is shut down"
            raise RuntimeError(message)
        future: Future[T] = Future()
        self._work.put((future, function, arguments, named))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: FBT001, FBT002 (as in the class that it is made from)
        """Take no more work; on cancel also end each batch after the run that it is at."""
        if cancel_futures:
            self._stopped.set()
            with suppress(Empty):
                while True:
                    if work := self._work.get_nowait():
                        work[0].cancel()
        for _ in self._threads:
            self._work.put(None)
        if wait:
            for thread in self._threads:
                thread.join()
        self._stopped.set()

    def kill(self) -> None:
        """Take no more work and give up what runs in processes; threads are left to themselves."""
        self.shutdown(wait=False, cancel_futures=True)
        for worker in self._workers:
            worker.kill()

    def _serve(self, worker: WorkerProcess) -> None:
        while work := self._work.get():
            future, function, arguments, named = work
            if future.set_running_or_notify_cancel():
                try:
                    if function is execute_all:
                        future.set_result(self._execute(worker, *arguments))
                    else:
                        future.set_result(function(*arguments, **named))
                except BaseException as error:  # noqa: BLE001 (it belongs to who asked)
                    future.set_exception(error)
            del work, future, arguments  # while it waits, a thread keeps no results alive
        worker.close()

    def _execute(self, worker: WorkerProcess, tasks: tuple[Task, ...]) -> list[Record]:
        """Return the records of a batch, of its first runs only where it is told to stop."""
        records: list[Record] = []
        for task in tasks:
            if self._stopped.is_set() and records:
                break
            try:
                apart = self._processes or holds_interpreter(task)
                records.append(worker.execute(task) if apart else execute(task))
            except StoppedError:
                break
        return records


@contextmanager
def local(workers: int, *, processes: bool = False) -> Iterator[Executor]:
    """Yield an executor on this machine, whose processes are ended whatever happens."""
    executor = LocalExecutor(workers, processes=processes)
    try:
        yield executor
        executor.shutdown()
    finally:
        executor.kill()
