"""Standard streams: fit for a terminal whatever a text holds, and no end of the work behind them.

Their reader may leave, their disk be full, they may be closed or know few letters: what cannot be
said is not said, and the call ends with the code that its work deserves.
"""

import io
import json
import os
import sys
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, TextIO, cast

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_LINES = "\n\t"
# control characters, directions and joiners that are not seen, halves of pairs, other line ends
_UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}


def for_terminal(text: str) -> str:
    """Return a text that moves no cursor and turns no line: what is not seen is spelt out.

    It is spelt as JSON spells it, so that JSON stays what it was.
    """
    if text.isascii() and text.replace("\n", "").isprintable():
        return text
    return "".join(_spelt(c) for c in text)


def one_line(text: str) -> str:
    """Return such a text whose own ends of lines are spelt out, too."""
    return for_terminal(text).replace("\n", r"\n")


def draw(stream: TextIO, text: str) -> None:
    """Write a text that moves the cursor, of our own, to whatever stream."""
    (stream.draw if isinstance(stream, FitForTerminal) else stream.write)(text)


def _spelt(c: str) -> str:
    hidden = unicodedata.category(c) in _UNSEEN and c not in _LINES
    return json.dumps(c)[1:-1] if hidden else c


class Unread(io.FileIO):
    """A stream that says nothing once it cannot be written: the work behind it ends as ever."""

    def write(self, data: "ReadableBuffer", /) -> int:
        """Write, to nowhere from the first time on that nobody reads or no room is left."""
        try:
            return super().write(data) or 0
        except OSError:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self.fileno())
            os.close(nowhere)
            return memoryview(data).nbytes


class FitForTerminal(io.TextIOBase):
    """A stream of text for a terminal, before another one."""

    def __init__(self, stream: TextIO) -> None:
        """Stand before a stream."""
        self._stream = stream

    def write(self, text: str, /) -> int:
        """Write a text, spelt out where it would do more than be read."""
        self.draw(for_terminal(text))
        return len(text)

    def draw(self, text: str) -> None:
        """Write a text as it is, which may move the cursor; letters that are not there as codes."""
        with suppress(OSError, ValueError):  # the second of a stream that somebody closed
            known = getattr(self._stream, "encoding", None) or "utf-8"
            self._stream.write(text.encode(known, "backslashreplace").decode(known))

    def flush(self) -> None:
        """Hand on what is written."""
        with suppress(OSError, ValueError):
            self._stream.flush()

    def isatty(self) -> bool:
        """Say whether somebody looks at it."""
        with suppress(OSError, ValueError):
            return self._stream.isatty()
        return False

    def writable(self) -> bool:
        """Say that it can be written."""
        return True

    def fileno(self) -> int:
        """Return the number of the file behind it."""
        return self._stream.fileno()

    @property
    def encoding(self) -> str:  # type: ignore[override]
        """The letters that the stream behind it knows."""
        return getattr(self._stream, "encoding", None) or "utf-8"


@contextmanager
def shown_streams() -> Iterator[None]:
    """Let standard output and standard error be such streams while the block runs."""
    before = sys.stdout, sys.stderr
    out, err = (FitForTerminal(_lasting(stream, k)) for k, stream in enumerate(before, 1))
    sys.stdout, sys.stderr = cast("TextIO", out), cast("TextIO", err)
    try:
        yield
    finally:
        out.flush()
        err.flush()
        sys.stdout, sys.stderr = before


def _lasting(stream: TextIO | None, number: int) -> TextIO:
    """Return a standard stream as one whose reader may leave; any other as it is."""
    if stream is None:  # closed before we began: else the next file that is opened took its place
        with suppress(OSError):
            _fill(number)
        return open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123 (as long as the call)
    if stream not in (sys.__stdout__, sys.__stderr__) or not isinstance(stream, io.TextIOWrapper):
        return stream
    with suppress(OSError):
        stream.flush()
    raw = Unread(stream.fileno(), "w", closefd=False)
    return io.TextIOWrapper(
        io.BufferedWriter(raw),
        encoding=stream.encoding,
        errors="backslashreplace",
        line_buffering=stream.line_buffering,
    )


def _fill(number: int) -> None:
    """Let the number of a closed standard stream stand for nowhere."""
    try:
        os.fstat(number)
    except OSError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        if nowhere != number:
            os.dup2(nowhere, number)
            os.close(nowhere)
