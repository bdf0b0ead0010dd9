"""Progress of a proof: one line redrawn on a terminal, nothing elsewhere."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

from repro.commands.streams import draw

PAUSE = 0.2  # s between two redraws


@contextmanager
def telling(stream: TextIO) -> Iterator[Callable[[float, float], None]]:
    """Yield what a proof is to call with its bound and its motion's time, in s."""
    shown = time.monotonic()
    drawn = False

    def tell(lower: float, attained: float) -> None:
        nonlocal shown, drawn
        now = time.monotonic()
        if not stream.isatty() or now - shown < PAUSE:
            return
        shown, drawn = now, True
        gap = 100.0 * (1.0 - lower / attained)
        draw(stream, f"\rbetween {lower:.6g} and {attained:.6g} s, {gap:.2g} % apart\033[K")
        stream.flush()

    try:
        yield tell
    finally:
        if drawn:
            draw(stream, "\r\033[K")
            stream.flush()
