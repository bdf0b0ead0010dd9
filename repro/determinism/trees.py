"""What files and packages there are, as digests, told without loading any of them."""

import hashlib
import importlib.metadata
import sys
from collections.abc import Iterator
from pathlib import Path


def tree(folder: Path) -> bytes:
    """Return a digest of the names and the bytes of all files in a folder but compiled ones."""
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            content = path.read_bytes()
            digest.update(f"{path.relative_to(folder)}\0{len(content)}\0".encode())
            digest.update(content)
    return digest.digest()


def installed() -> Iterator[str]:
    """Yield the version of Python and of every installed package."""
    yield sys.version
    for distribution in importlib.metadata.distributions():
        yield f"{distribution.name} {distribution.version}"
