"""What a call printed, kept beside the runs and printed again while nothing changed.

It is kept by a digest of all that it follows from: what is asked for, the papers' files, the
engine's, and the installed packages; where runs are counted, the file of the runs and the note of
what they were made of; where pages are written, these and the machine. It is told without loading
a paper. Papers from elsewhere than this house are not kept: what theirs rests on is not known.
"""

import hashlib
import importlib.metadata
import os
import platform
import re
import sys
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import repro
from repro.commands import own_papers
from repro.commands.arguments import STORE
from repro.determinism.settings import settings
from repro.determinism.trees import installed, tree
from repro.report.kept import find, keep
from repro.runs.store.settled import settled_digest
from repro.runs.whole_files import read_file

FOLDER = "kept"
GROUP = "repro.papers"
MADE_OF = "made-of.json"
_NAMES = "surrogateescape"  # a folder may have a name that is no text
_KEY = re.compile(r"\w+")  # anything else may be a path
_PROCESSOR = re.compile(r"^(?:model name|model|flags|Features|CPU \w+)\t*:.*$", re.MULTILINE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rests:
    """What the output of a command rests on besides the papers; not on rooms that are `without`."""

    without: tuple[str, ...] = ()
    runs: bool = False
    pages: bool = False


KEPT = {
    "audit": Rests(),
    "list": Rests(without=("audit", "judge", "report"), runs=True),
    "reproduce": Rests(runs=True, pages=True),
}
"""The commands whose output is kept."""


def told(options: Namespace) -> bool:
    """Print what a call printed before if nothing changed since, and say whether it is so."""
    options.sources = _sources(options) if options.command in KEPT else ""
    name = _name(options)
    content = find(_store(options) / FOLDER, name) if name else None
    if content is not None:
        sys.stdout.write(content.decode(errors=_NAMES))
    return content is not None


def tell(options: Namespace, text: str) -> None:
    """Print the output of a call that went well, and keep it for when nothing changed."""
    sys.stdout.write(text)
    if name := "" if getattr(options, "faulty", False) else _name(options):
        keep(_store(options) / FOLDER, name, text.encode(errors=_NAMES))


def _sources(options: Namespace) -> str:
    """Return a digest of what is asked for and of all files that answer, "" where not known."""
    papers = own_papers.found()
    elsewhere = importlib.metadata.entry_points(group=GROUP)
    if papers is None or elsewhere or not all(map(_KEY.fullmatch, options.keys)):
        return ""
    asked = {k: v for k, v in vars(options).items() if k not in ("named", "sources")}
    printed = getattr(sys.stdout, "encoding", "")  # letters that it lacks are spelt otherwise
    digest = hashlib.sha256(f"{sorted(asked.items())}\0{printed}\0".encode())
    for text in installed():
        digest.update(f"{text}\0".encode())
    for folder in (*repro.__path__, *(papers.submodule_search_locations or ())):
        digest.update(tree(Path(folder), without=KEPT[options.command].without))
    return digest.hexdigest()


def _name(options: Namespace) -> str:
    """Return a digest of all that the output follows from, "" where that is not known."""
    store = _store(options)
    if not getattr(options, "sources", "") or not store.is_dir():
        return ""
    rests, digest = KEPT[options.command], hashlib.sha256(options.sources.encode())
    if rests.runs:
        runs = settled_digest(store)
        if runs is None:
            return ""
        digest.update(runs.encode() + b"\0" + _note(store))
    if rests.pages:
        try:
            digest.update(tree(options.reports))
        except OSError:
            return ""
        for text in _machine():
            digest.update(f"{text}\0".encode())
    return digest.hexdigest()


def _store(options: Namespace) -> Path:
    return getattr(options, "store", STORE)


def _note(store: Path) -> bytes:
    try:
        return read_file(store / MADE_OF)
    except OSError:
        return b""


def _machine() -> Iterator[object]:
    """Yield all that a machine's part of the provenance follows from, without loading numba."""
    yield platform.uname()[0::4]
    yield platform.libc_ver()
    yield os.cpu_count()
    yield settings()
    information = Path("/proc/cpuinfo")
    if information.exists():
        yield sorted(set(_PROCESSOR.findall(information.read_text(encoding="utf-8"))))
    yield platform.processor()
