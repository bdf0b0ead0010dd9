"""Progress of a long run: one line redrawn on a terminal, plain lines elsewhere."""

import sys
import time
from typing import TextIO

from repro.commands.streams import FitForTerminal

PLAIN_SECONDS = 10.0  # between two plain lines
TERMINAL_SECONDS = 0.1  # between two redraws
_WIDTH = 30


class Progress:
    """Says how many runs are done, how fast, and how long the rest will take."""

    def __init__(self, stream: TextIO | None = None) -> None:
        """Start the clock; the stream is stderr unless another is given."""
        self._stream = stream or sys.stderr
        self._terminal = self._stream.isatty()
        self._start = self._said = time.monotonic()

    def __call__(self, done: int, total: int) -> None:
        """Show the state, unless the last one was shown a moment ago."""
        now = time.monotonic()
        last = done == total
        pause = TERMINAL_SECONDS if self._terminal else PLAIN_SECONDS
        if not done or (now - self._said < pause and not last):
            return
        self._said = now
        rate = done / max(now - self._start, 1e-9)
        text = (
            f"{done}/{total} runs ({100 * done // total} %), {rate:.0f}/s, "
            f"{(total - done) / rate:.0f} s left"
        )
        if self._terminal:
            filled = _WIDTH * done // total
            bar = "█" * filled + "·" * (_WIDTH - filled)
            text = f"\r{bar} {text}\033[K" + ("\n" if last else "")
            draw = (
                self._stream.draw
                if isinstance(self._stream, FitForTerminal)
                else self._stream.write
            )
            draw(text)
        else:
            self._stream.write(text + "\n")
        self._stream.flush()
