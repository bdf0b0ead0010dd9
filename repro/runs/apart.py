"""What keeps runs in plain Python apart: each starts from the same state and draws its own."""

import copy
import random
import threading
from typing import TypeVar

import numpy as np

T = TypeVar("T")


def fresh(part: T) -> T:
    """Return a search or problem as it was declared, whatever an earlier run would do to it."""
    try:
        return copy.deepcopy(part)
    except Exception:  # noqa: BLE001 (whatever refuses to be copied is used as it is)
        return part


class GlobalDraws:
    """The generators that all of a program shares, as they were when this was made.

    They are watched in a main thread alone, as in a process of its own: beside a run in another
    thread, whoever keeps a cluster together may draw.
    """

    def __init__(self) -> None:
        """Note their states."""
        watched = threading.current_thread() is threading.main_thread()
        self._before = _states() if watched else {}

    def fault(self) -> str | None:
        """Return which of them was drawn from since, in words; None where none was."""
        now = _states() if self._before else {}
        drawn = [name for name, state in now.items() if state != self._before[name]]
        if not drawn:
            return None
        return f"the search, or the cost, drew from the generator of {drawn[0]}, not from `rng`"


def _states() -> dict[str, object]:
    kind, words, *rest = np.random.get_state()  # noqa: NPY002 (to see whether others use it)
    return {
        "random": random.getstate(),
        "numpy.random": (kind, np.asarray(words).tobytes(), *rest),
    }
