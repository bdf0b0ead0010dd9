"""Calls side by side, each in a copy of this process: what they find comes back as bytes."""

import multiprocessing
import signal
import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

Call = Callable[[], bytes]


def side_by_side(calls: Sequence[Call], workers: int) -> list[bytes | None]:
    """Return what each call returns, in their order; so many are at work at once.

    The first are begun first. It is None for a call that failed or whose process died, and for all
    where no copy can be made, or one would be of no use: whoever asks makes those calls itself,
    and has their errors.
    """
    found: list[bytes | None] = [None] * len(calls)
    if workers < 2 or len(calls) < 2 or not _can_be_copied():
        return found
    running: dict[Connection, tuple[int, BaseProcess]] = {}
    begun = 0
    try:
        while running or begun < len(calls):
            while len(running) < workers and begun < len(calls):
                connection, process = _copy(calls[begun])
                running[connection] = begun, process
                begun += 1
            for connection in [each for each in running if each in wait(list(running))]:
                number, process = running.pop(connection)
                found[number] = _received(connection)
                process.join()
    finally:
        for _, process in running.values():
            process.kill()
    return found


def _can_be_copied() -> bool:
    """Return whether this process may be forked: macOS' own libraries do not stand it."""
    known = "fork" in multiprocessing.get_all_start_methods() and sys.platform != "darwin"
    return known and threading.active_count() == 1


def _copy(call: Call) -> tuple[Connection, BaseProcess]:
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_answer, args=(call, theirs), daemon=True)
    with theirs, warnings.catch_warnings():
        # of threads of libraries, which hold no lock of ours
        warnings.simplefilter("ignore", DeprecationWarning)
        process.start()
    return ours, process


def _answer(call: Call, connection: Connection) -> None:
    """Send what a call returns, and nothing where it raises."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the first process
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    with suppress(BaseException):
        connection.send_bytes(call())


def _received(connection: Connection) -> bytes | None:
    with connection, suppress(EOFError, OSError):
        return connection.recv_bytes()
    return None
