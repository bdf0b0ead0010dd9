"""Whether all that a store holds stands in its file, and what that is, told without reading it."""

import hashlib
from pathlib import Path

from repro.runs.store.lock import lock_to_read

NAME = "runs.sqlite"


def is_settled(path: Path) -> bool:
    """Return whether all that is stored stands in the file, and nothing in a journal beside it."""
    journal = path.with_name(f"{path.name}-wal")
    return not (journal.exists() and journal.stat().st_size)


def settled_digest(folder: Path) -> str | None:
    """Return a digest of a store's file; None without one, or while somebody writes there."""
    path = folder / NAME
    lock = lock_to_read(folder)
    if lock is None:
        return None
    try:
        if not path.is_file() or not is_settled(path):
            return None
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None
    finally:
        lock.close()
