"""Calls side by side, in copies of this process: what they find comes back as bytes.

A call may ask the first process for what only that one can do, and waits until it is done.
"""

import multiprocessing
import signal
import sys
import threading
import warnings
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

Ask = Callable[[bytes], None]
"""What a call asks by: it returns when the first process has done what it was asked for."""

Call = Callable[[Ask], bytes]
_NO_MORE = -1
_FOUND, _ASKS = b"=", b"?"


def side_by_side(
    calls: Sequence[Call], workers: int, do: Callable[[int, bytes], None]
) -> list[bytes | None]:
    """Return what each call returns, in their order; so many are at work at once.

    `do` is what this process does for a call, by its number, that asks; what it raises ends all.

    The first are begun first. A copy makes one call after another, so that what several load or
    work out is found once in each. It is None for a call that failed or whose process died, and
    for all where no copy can be made, or one would be of no use: whoever asks makes those calls
    itself, and has their errors.
    """
    found: list[bytes | None] = [None] * len(calls)
    if workers < 2 or len(calls) < 2 or not _can_be_copied():
        return found
    left = deque(range(len(calls)))
    running: dict[Connection, tuple[int, BaseProcess]] = {}
    try:
        while running or left:
            while len(running) < workers and left:
                connection, process = _copy(calls)
                running[connection] = _begun(connection, left), process
            for connection in [each for each in running if each in wait(list(running))]:
                number, process = running[connection]
                said = _received(connection)
                if said and said.startswith(_ASKS):
                    do(number, said.removeprefix(_ASKS))
                    _done(connection)
                    continue
                del running[connection]
                found[number] = said and said.removeprefix(_FOUND)
                if found[number] is not None and left:
                    running[connection] = _begun(connection, left), process
                else:
                    _end(connection)
                    process.join()
    finally:
        for _, process in running.values():
            process.kill()
    return found


@contextmanager
def beside(call: Callable[[], object]) -> Iterator[None]:
    """Have a copy of this process make a call meanwhile, as far as it gets; nothing comes back."""
    if not _can_be_copied():
        yield
        return
    process = _started(_quietly, call)
    try:
        yield
    finally:
        process.kill()
        process.join()


def _quietly(call: Callable[[], object]) -> None:
    _unstirred()
    with suppress(BaseException):
        call()


def _begun(connection: Connection, left: deque[int]) -> int:
    """Have a copy make the next call, and return its number."""
    number = left.popleft()
    with suppress(OSError):  # of a copy that is dead: nothing will be received of it
        connection.send(number)
    return number


def _done(connection: Connection) -> None:
    with suppress(OSError):  # of a copy that died while it waited
        connection.send(None)


def _can_be_copied() -> bool:
    """Return whether this process may be forked: macOS' own libraries do not stand it."""
    known = "fork" in multiprocessing.get_all_start_methods() and sys.platform != "darwin"
    return known and threading.active_count() == 1


def _copy(calls: Sequence[Call]) -> tuple[Connection, BaseProcess]:
    ours, theirs = multiprocessing.Pipe()
    with theirs:
        return ours, _started(_answer, calls, theirs)


def _started(target: Callable[..., None], *arguments: object) -> BaseProcess:
    context = multiprocessing.get_context("fork")
    process = context.Process(target=target, args=arguments, daemon=True)
    with warnings.catch_warnings():
        # of threads of libraries, which hold no lock of ours
        warnings.simplefilter("ignore", DeprecationWarning)
        process.start()
    return process


def _end(connection: Connection) -> None:
    """Have a copy end, if it has not; later copies have this end of the pipe, too."""
    with connection, suppress(OSError):
        connection.send(_NO_MORE)


def _answer(calls: Sequence[Call], connection: Connection) -> None:
    """Send what each call returns that is asked for, and nothing more once one raises."""
    _unstirred()

    def ask(what: bytes) -> None:
        connection.send_bytes(_ASKS + what)
        connection.recv()

    with suppress(BaseException):
        while (number := connection.recv()) != _NO_MORE:
            connection.send_bytes(_FOUND + calls[number](ask))


def _unstirred() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the first process
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _received(connection: Connection) -> bytes | None:
    with suppress(EOFError, OSError):
        return connection.recv_bytes()
    return None
