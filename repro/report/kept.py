"""What was made before, kept in a folder by a digest of all that it follows from.

It saves time and nothing else: what cannot be read, or is not what was written under its name, is
made again, and a folder that cannot be written keeps nothing.
"""

import hashlib
import os
import re
from contextlib import suppress
from pathlib import Path

from repro.errors import InputError
from repro.runs.whole_files import read_file, write_file

MOST = 1 << 27
"""Bytes that are kept; what was not used for longest goes first."""
_ENDING = ".kept"
_NAME = re.compile(r"[0-9a-f]{64}")


def find(folder: Path, name: str) -> bytes | None:
    """Return what is kept under a name; None where nothing is, or not what was written there."""
    path = folder / f"{name}{_ENDING}"
    try:
        digest, _, content = read_file(path).partition(b"\n")
        if digest != _digest(name, content):
            return None
        os.utime(path)
    except OSError:
        return None
    return content


def keep(folder: Path, name: str, content: bytes) -> None:
    """Keep a content under a digest as its name, where the folder can be written."""
    with suppress(InputError, OSError):
        place = f"{folder.name}/{name}{_ENDING}"
        write_file(folder.parent, place, _digest(name, content) + b"\n" + content)
        _drop_oldest(folder)


def _digest(name: str, content: bytes) -> bytes:
    return hashlib.sha256(name.encode() + b"\n" + content).hexdigest().encode()


def _drop_oldest(folder: Path) -> None:
    """Delete files of ours until no more than `MOST` bytes are left."""
    ours = (path for path in folder.glob(f"*{_ENDING}") if _NAME.fullmatch(path.stem))
    found = [(path.lstat(), path) for path in ours]
    left = sum(stat.st_size for stat, _ in found)
    for stat, path in sorted(found, key=lambda each: each[0].st_mtime_ns):
        if left <= MOST:
            break
        path.unlink(missing_ok=True)
        left -= stat.st_size
