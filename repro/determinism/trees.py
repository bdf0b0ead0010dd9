"""What files and packages there are, as digests, told without loading any of them."""

import hashlib
import importlib.metadata
import sys
from collections.abc import Collection, Iterator
from pathlib import Path


def tree(folder: Path, without: Collection[str] = ()) -> bytes:
    """Return a digest of the names and the bytes of all files in a folder but compiled ones.

    What is `without` of it are files and folders by the first part of their place.
    """
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        place = path.relative_to(folder)
        wanted = "__pycache__" not in path.parts and place.parts[0] not in without
        if wanted and path.is_file():
            content = path.read_bytes()
            digest.update(f"{place}\0{len(content)}\0".encode())
            digest.update(content)
    return digest.digest()


def installed() -> Iterator[str]:
    """Yield the version of Python and of every installed package."""
    yield sys.version
    for distribution in importlib.metadata.distributions():
        yield f"{distribution.name} {distribution.version}"
