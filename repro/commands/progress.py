"""Progress of a long run: one line redrawn on a terminal, plain lines elsewhere."""

import sys
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import TextIO

from repro.commands.streams import draw, one_line
from repro.runs.plan import Task
from repro.runs.run import Record
from repro.runs.store.questions import Kind
from repro.runs.time_left import TimeLeft, kind_of

PLAIN_SECONDS = 10.0  # between two plain lines
TERMINAL_SECONDS = 0.25  # between two redraws
_WIDTH = 30


class Progress:
    """Says how many runs are done, which ones go on, and how long the rest will take."""

    def __init__(self, stream: TextIO | None = None) -> None:
        """Start the clock; the stream is stderr unless another is given."""
        self._stream = stream or sys.stderr
        self._terminal = self._stream.isatty()
        self._start = self._said = time.monotonic()
        self._left = TimeLeft()
        self._total = 0
        self._at = ""

    @property
    def expecting(self) -> bool:
        """Whether runs that were expected are not done."""
        return self._left.runs > 0

    def expect(self, tasks: Iterable[Task], earlier: Mapping[Kind, float]) -> None:
        """Start the clock for these runs; `earlier` are the seconds of a run in other calls."""
        self._left.expect(tasks, earlier)
        self._total = self._left.runs
        self._start = self._said = time.monotonic()

    def note(self, record: Record) -> None:
        """Count a run that is done."""
        self._left.note(kind_of(record.task), record.seconds)
        self._at = one_line(f"{record.task.paper}, {record.task.experiment}")

    @contextmanager
    def paused(self) -> Iterator[None]:
        """Stop the clock while something else than runs goes on."""
        begun = time.monotonic()
        yield
        self._start += time.monotonic() - begun

    def __call__(self, _done: int, _of: int) -> None:
        """Show the state, unless the last one was shown a moment ago."""
        now = time.monotonic()
        left = self._left.runs
        pause = TERMINAL_SECONDS if self._terminal else PLAIN_SECONDS
        if left == self._total or (now - self._said < pause and left):
            return
        self._said = now
        share, seconds = self._left.outlook(now - self._start)
        text = (
            f"{self._total - left}/{self._total} runs ({100 * share:.0f} %), "
            f"{duration(seconds)} left: {self._at}"
        )
        if self._terminal:
            filled = int(_WIDTH * share)
            bar = "█" * filled + "·" * (_WIDTH - filled)
            draw(self._stream, f"\r{bar} {text}\033[K" + ("" if left else "\n"))
        else:
            self._stream.write(text + "\n")
        self._stream.flush()


def duration(seconds: float) -> str:
    """Return a time as it is said: "40 s", "3 min 20 s", "2 h 5 min"."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"
