"""What is said of compiled code before any run."""

from repro.commands.shown_rows import warn
from repro.determinism import compiled


def say_whether_kept() -> None:
    """Say where compiled code cannot be kept: every call compiles it again then."""
    if compiled.KEPT is None:
        warn(
            "compiled code cannot be kept, so every call compiles again: no folder can be written; "
            "name one in NUMBA_CACHE_DIR"
        )
