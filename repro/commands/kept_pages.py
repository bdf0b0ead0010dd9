"""A paper's pages kept beside the runs, so that those of a paper where nothing changed stand.

They are kept by a digest of all that they follow from: the engine's files, the installed packages,
the machine, the paper's own modules and files, what is asked for, and every row that the store has
of the paper. Papers from elsewhere than this house are not kept: what theirs rest on is not known.
"""

import base64
import hashlib
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import repro
from repro.commands.catalogue import of_this_house
from repro.commands.kept_output import FOLDER
from repro.determinism.definitions import import_closure
from repro.determinism.provenance import provenance
from repro.determinism.source_files import path_of
from repro.determinism.trees import installed, tree
from repro.model.paper import Paper
from repro.report.kept import find, keep
from repro.report.results import Made
from repro.runs.plan import Task
from repro.runs.store.store import Store
from repro.runs.studies import studies

_OF_THE_DAY = ("date", "commit")  # what the provenance of a call says besides its machine


@dataclass(frozen=True, slots=True, kw_only=True)
class Extent:
    """What is asked for of a paper: how many repeats of which experiments, in how many runs."""

    repeats: Mapping[str, int]
    runs: int
    seed: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """A paper whose pages are asked for, what gives its tasks, and what it is called."""

    paper: Paper
    tasks: Callable[[], Sequence[Task]]
    extent: Extent
    called: str = ""


def extent_of(tasks: Sequence[Task]) -> Extent:
    """Return the extent of tasks of one paper, those of an experiment in the order of repeats."""
    repeats = {task.experiment: task.repeat for task in tasks}
    return Extent(repeats=repeats, runs=len(tasks), seed=tasks[0].seed if tasks else "")


def planned_extent(
    paper: Paper, repeats: int, seed: str = "", *, protocol_only: bool = False
) -> Extent:
    """Return the extent of what `plan` gives, without planning it."""
    parts = [(experiment, repeats) for experiment in paper.experiments]
    if not protocol_only:
        parts += [(study.experiment, study.repeats) for study in studies(paper, repeats)]
    runs = sum(
        times * each.runs * len(each.problems) * len(each.algorithms) for each, times in parts
    )
    times = {each.name: times for each, times in parts if each.problems and each.algorithms}
    return Extent(repeats=times, runs=runs, seed=seed if runs else "")


def names_of(
    store: Store, asked: Sequence[Request], places: Mapping[str, Path], known: Iterable[str]
) -> dict[str, str]:
    """Return by key the names under which pages are kept; of papers of this house alone."""
    own = {
        each.paper.key: place
        for each in asked
        if (place := places.get(each.paper.key)) and of_this_house([place]) and place.exists()
    }
    rows = rows_of_papers(store) if own else None
    if rows is None:
        return {}
    keys = {*known, *(each.paper.key for each in asked)}
    return {
        each.paper.key: name_of(each, declared_by(own[each.paper.key], keys), rows)
        for each in asked
        if each.paper.key in own
    }


def declared_by(place: Path, known: Iterable[str]) -> dict[str, bytes]:
    """Return the files that declare a paper of this house, by their names.

    They are all in its folder but those that begin with the key of another one that is known,
    unless a module of the paper imports it.
    """
    folder, keys = place.parent, {*known} - {place.stem}
    own = {
        path
        for path in folder.rglob("*")
        if path.is_file()
        and "__pycache__" not in path.parts
        and path.relative_to(folder).parts[0].partition(".")[0] not in keys
    }
    module = f"{folder.name}.{place.stem}"
    own |= {path for name in import_closure(module) if (path := path_of(name))}
    return {str(path): path.read_bytes() for path in sorted(own)}


def name_of(asked: Request, files: Mapping[str, bytes], rows: Mapping[str, str]) -> str:
    """Return a digest of all that the pages of a paper follow from."""
    key = asked.paper.key
    said = (*_surroundings(), key, asked.called, str(asked.extent), rows.get(key, ""))
    digest = hashlib.sha256("\0".join(said).encode())
    for name, content in files.items():
        digest.update(f"\0{name}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()


@cache
def _surroundings() -> tuple[str, ...]:
    machine = (f"{k} {v}" for k, v in provenance().items() if k not in _OF_THE_DAY)
    return (*(tree(Path(folder)).hex() for folder in repro.__path__), *installed(), *machine)


def rows_of_papers(store: Store) -> Mapping[str, str] | None:
    """Return a digest of what the store has of each paper; None while somebody writes there.

    They are kept by a digest of the whole file, which is read faster than its rows.
    """
    whole = store.fingerprint()
    if whole is None:
        return None
    folder = store.folder / FOLDER
    if (known := find(folder, whole)) is not None:
        found: dict[str, str] = json.loads(known)
        return found
    found = store.contents()
    keep(folder, whole, json.dumps(found).encode())
    return found


def packed(made: Made) -> bytes:
    """Return all that is written of a paper as bytes."""
    files = {
        name: {"base64": base64.b64encode(content).decode()}
        if isinstance(content, bytes)
        else content
        for name, content in made.files.items()
    }
    content = {
        "entry": made.entry, "provenance": made.provenance, "files": files, "says": made.says,
        "missing": made.missing, "tasks": made.tasks,
    }  # fmt: skip
    return json.dumps(content, ensure_ascii=False).encode()


def unpacked(content: bytes) -> Made:
    """Return what was packed."""
    found = json.loads(content)
    found["files"] = {
        name: text if isinstance(text, str) else base64.b64decode(text["base64"])
        for name, text in found["files"].items()
    }
    return Made(**found)
