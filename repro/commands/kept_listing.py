"""A listing of this house's papers kept beside the runs, told without loading the papers.

It is kept by a digest of all that it follows from: the papers' files and the engine's but those of
the rooms that judge and write, the installed packages, what is asked for, the file of the runs and
the note of what they were made of.
"""

import hashlib
import importlib.metadata
import json
import re
import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import repro
from repro.commands import own_papers
from repro.commands.listing_text import listing_text
from repro.determinism.trees import installed, tree
from repro.report.kept import find, keep
from repro.runs.store.settled import settled_digest
from repro.runs.whole_files import read_file

FOLDER = "kept"
GROUP = "repro.papers"
MADE_OF = "made-of.json"
OTHER_ROOMS = ("audit", "judge", "report")
"""Rooms that decide no run and so no listing."""
Rows = list[dict[str, Any]]
_KEY = re.compile(r"\w+")  # anything else may be a path


def told(options: Namespace) -> bool:
    """Print the listing that is asked for if it is kept, and say whether it is.

    `options.kept` is the name under which it is, or may be from now on.
    """
    options.kept = _name(options.store, options.keys, options.repeats)
    content = find(options.store / FOLDER, options.kept) if options.kept else None
    if content is not None:
        show(json.loads(content), as_json=options.json)
    return content is not None


def keep_listing(options: Namespace, rows: Rows) -> None:
    """Keep a listing for when nothing changed."""
    if name := getattr(options, "kept", ""):
        keep(options.store / FOLDER, name, json.dumps(rows).encode())


def show(rows: Rows, *, as_json: bool) -> int:
    """Print a listing and return exit code 0."""
    sys.stdout.write(json.dumps(rows, indent=2) + "\n" if as_json else listing_text(rows))
    return 0


def _name(store: Path, keys: Sequence[str], repeats: int) -> str:
    """Return a digest of all that a listing follows from, "" where that is not known."""
    papers = own_papers.found()
    runs = settled_digest(store)
    elsewhere = importlib.metadata.entry_points(group=GROUP)
    if papers is None or runs is None or elsewhere or not all(map(_KEY.fullmatch, keys)):
        return ""
    digest = hashlib.sha256(f"listing\0{keys}\0{repeats}\0{runs}\0".encode())
    for text in installed():
        digest.update(f"{text}\0".encode())
    for folder in (*repro.__path__, *(papers.submodule_search_locations or ())):
        digest.update(tree(Path(folder), without=OTHER_ROOMS))
    digest.update(_note(store))
    return digest.hexdigest()


def _note(store: Path) -> bytes:
    try:
        return read_file(store / MADE_OF)
    except OSError:
        return b""
