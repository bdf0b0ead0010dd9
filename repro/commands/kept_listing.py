"""A listing of this house's papers kept beside the runs, told without loading the papers.

It is kept by a digest of all that it follows from: the engine's and the papers' files, the
installed packages, what is asked for, the file of the runs and the note of what they were made of.
"""

import hashlib
import importlib.metadata
import importlib.util
import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import repro
from repro.determinism.trees import installed, tree
from repro.report.kept import find, keep
from repro.runs.store.settled import settled_digest

FOLDER = "kept"
GROUP = "repro.papers"
MADE_OF = "made-of.json"
Rows = list[dict[str, Any]]
_KEY = re.compile(r"\w+")  # anything else may be a path


def kept_listing(store: Path, keys: Sequence[str], repeats: int, make: Callable[[], Rows]) -> Rows:
    """Return what was kept of a listing; else what `make` returns, which is kept if it is whole."""
    name = _name(store, keys, repeats)
    content = find(store / FOLDER, name) if name else None
    if content is not None:
        found: Rows = json.loads(content)
        return found
    rows = make()
    if name and (not keys or {row["key"] for row in rows} == set(keys)):
        keep(store / FOLDER, name, json.dumps(rows).encode())
    return rows


def _name(store: Path, keys: Sequence[str], repeats: int) -> str:
    """Return a digest of all that a listing follows from, "" where that is not known."""
    papers = importlib.util.find_spec("papers")
    runs = settled_digest(store)
    elsewhere = importlib.metadata.entry_points(group=GROUP)
    if papers is None or runs is None or elsewhere or not all(map(_KEY.fullmatch, keys)):
        return ""
    digest = hashlib.sha256(f"listing\0{keys}\0{repeats}\0{runs}\0".encode())
    for text in installed():
        digest.update(f"{text}\0".encode())
    for folder in (*repro.__path__, *(papers.submodule_search_locations or ())):
        digest.update(tree(Path(folder)))
    digest.update(_note(store))
    return digest.hexdigest()


def _note(store: Path) -> bytes:
    try:
        return (store / MADE_OF).read_bytes()
    except OSError:
        return b""
