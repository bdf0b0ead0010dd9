"""A process of its own for runs that would hold the interpreter, or that may crash.

The process reads from one end of a socket pair whose other end only the driver has: when the
driver ends, however it ends, the process reads the end of the file and is gone at once.
"""

import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from queue import SimpleQueue
from threading import Event, Thread

from repro.runs.plan import Task
from repro.runs.run import Record, execute, failed, prepare, told
from repro.runs.workers.pickling import pack, stripped, unpack

ALIVE, LATE = b"alive", b"late"
TRIES = 3  # deaths of a worker that one task may cause before it is named and given up
_HOME = str(Path(__file__).parents[3])  # where our package is
# a folder of searches may hold a repro.py, numpy.py or papers/ of its own, so it comes last until
# ours are in
_PROGRAM = (
    "import sys; _, number, home, *paths = sys.argv; "
    "sys.path[:] = [home, *filter(None, sys.path), *paths]; "
    "import papers; from repro.runs.workers.process import serve; "
    "sys.path[:] = paths; serve(int(number))"
)
# one thread per run: the engine itself spreads runs over the cores
_ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


class StoppedError(Exception):
    """The process was told to stop before its run was over."""


class WorkerProcess:
    """One process, started when it is first needed and again when it has died."""

    def __init__(self) -> None:
        """Start nothing yet."""
        self._process: subprocess.Popen[bytes] | None = None
        self._connection: Connection | None = None
        self._stopped = Event()

    def execute(self, task: Task) -> Record:
        """Return the record of one run.

        A task that cannot be sent, of a class that was made up in a script say, runs here. One
        that has killed its worker three times is a failed run that says so.
        """
        try:
            payload = pack((task,))
        except (pickle.PicklingError, AttributeError, TypeError):
            return execute(task)
        for _ in range(TRIES):
            answer = self._ask(payload, task.timeout)
            if answer == LATE:
                reason = f"it did not return within {task.timeout} s"
                return failed(task, reason, task.timeout or 0.0)
            if answer is not None:
                values = pickle.loads(answer)  # noqa: S301 (from our own process)
                return execute(task) if values is None else Record(task=task, **values)
            ending = self._ending()
            if self._stopped.is_set():
                raise StoppedError
        return failed(task, f"its worker died {TRIES} times, the last time by {ending}", 0.0)

    def _ask(self, payload: bytes, timeout: float | None) -> bytes | None:
        """Return the answer of the process, None where it has died, LATE where time is over.

        The time begins anew with every sign that the process gives: it is ready, it goes on.
        """
        connection = self._connection or self._started()
        try:
            connection.send_bytes(payload)
            answer = connection.recv_bytes()
            while answer == ALIVE:
                if not connection.poll(timeout):
                    self._give_up()
                    return LATE
                answer = connection.recv_bytes()
        except (EOFError, OSError):
            return None
        return answer

    def _started(self) -> Connection:
        if self._stopped.is_set():
            raise StoppedError
        ours, theirs = Pipe()
        with theirs:
            self._process = subprocess.Popen(  # noqa: S603 (our own program)
                (sys.executable, "-c", _PROGRAM, str(theirs.fileno()), _HOME, *sys.path),
                pass_fds=(theirs.fileno(),),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,  # what a search prints is no answer of ours
                env={**os.environ, **_ONE_THREAD},
                start_new_session=True,  # Ctrl-C is for the driver, which decides what it means
            )
        self._connection = ours
        if self._stopped.is_set():  # told to stop meanwhile
            self.kill()
        return ours

    def _give_up(self) -> None:
        """End the process, so that the next run has another."""
        if self._process and self._connection:
            self._process.kill()
            self._process.wait()
            self._connection.close()
            self._connection = None

    def _ending(self) -> str:
        """Return what ended the process, and clear up behind it."""
        self.close()
        code = self._process.wait() if self._process else 0
        return signal.Signals(-code).name if code < 0 else f"exit code {code}"

    def kill(self) -> None:
        """End the process at once, from any thread; its run is lost and no other is started."""
        self._stopped.set()
        process = self._process
        if process:
            process.kill()
            process.wait()

    def close(self) -> None:
        """Let the process end, which it does when nobody can write to it."""
        if self._connection and self._process:
            self._connection.close()
            self._connection = None
            try:
                self._process.wait(5)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()


def serve(handle: int) -> None:
    """Run what arrives on a connection until its other end is closed."""
    connection = Connection(handle)
    payloads: SimpleQueue[bytes] = SimpleQueue()
    Thread(target=_listen, args=(connection, payloads), daemon=True).start()
    begun: set[object] = set()
    while True:
        connection.send_bytes(_answer(payloads.get(), begun, lambda: connection.send_bytes(ALIVE)))


def _listen(connection: Connection, payloads: SimpleQueue[bytes]) -> None:
    """Hand payloads on; end the process with its driver, even in the middle of a run."""
    with suppress(EOFError, OSError):
        while True:
            payloads.put(connection.recv_bytes())
    os._exit(0)


def _answer(payload: bytes, begun: set[object], alive: Callable[[], None]) -> bytes:
    """Return the packed record of a run, or a packed None for a task that is unknown here.

    The first run of a search that can be prepared is made twice: the time of the second is free of
    what the search loads and compiles itself. `begun` are those that have run here.
    """
    try:
        (task,) = unpack(payload)
    except Exception:  # noqa: BLE001 (whatever importing a stranger's module raises)
        return pickle.dumps(None)
    with suppress(BaseException):  # the run itself says what is wrong
        prepare(task)
    alive()
    record = _executed(task)
    search = getattr(task.optimiser, "source", None)
    if search is not None and search not in begun and record.reason is None:
        alive()
        begun.add(search)
        again = _executed(task)
        record = replace(record, seconds=min(record.seconds, again.seconds))
    return pickle.dumps(stripped(record))


def _executed(task: Task) -> Record:
    """Return the record of a run, failed where it raises what would end the process.

    No Ctrl-C arrives here: KeyboardInterrupt is the search's own.
    """
    start = time.perf_counter()
    try:
        return execute(task)
    except BaseException as error:  # noqa: BLE001 (the fault of one run, whatever it is)
        return failed(task, told(error), time.perf_counter() - start)
