"""What the runs of a paper are, arranged for judging, kept beside them.

It is kept by a digest of what the store has of the paper, of the runs that are asked for and of
the files that read and arrange them, so that other rules of judging or other pages read no run.
"""

import hashlib
import json
import math
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from repro.commands.kept_listing import FOLDER
from repro.determinism.source_files import path_of
from repro.determinism.trees import installed, tree
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.paper import Paper
from repro.report.kept import find, keep
from repro.runs.gather import evidence_of, gather, whole_and_followed
from repro.runs.plan import Task
from repro.runs.raw_runs import RawRun, RawRuns
from repro.runs.store.row import FLOAT, pack, vector
from repro.runs.store.store import Store
from repro.runs.studies import Study

_ROOM = "repro.runs"
_BESIDES = ("repro.model.evidence", __name__)
_NAMES = ("study", "experiment", "problem", "algorithm")
_NUMBERS = ("repeat", "run", "cost", "evaluations", "seconds")
Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class OfStore:
    """Where the runs of a paper are; `rows` is a digest of them, "" where it is not known."""

    store: Store
    paper: Paper
    besides: Sequence[Study]
    rows: str


def gathered(source: OfStore, tasks: Sequence[Task], raw: RawRuns) -> Evidence:
    """Return what `gather` does of the tasks, and note each run that was read."""
    folder = source.store.folder / FOLDER
    name = _name(source, tasks) if source.rows else ""
    content = find(folder, name) if name else None
    if content is None:
        own = RawRuns(source.besides)
        found = gather(source.store, source.paper, tasks, source.besides, own.note)
        noted: Sequence[RawRun] = own.runs()
        if name:
            keep(folder, name, b"".join(_packed(found.runs, noted)))
    else:
        runs, noted = _unpacked(content)
        found = evidence_of(source.paper, source.besides, runs)
    raw.add(noted)
    return found


def _name(source: OfStore, tasks: Sequence[Task]) -> str:
    protocol, followed = whole_and_followed(source.paper, source.besides)
    departs = [(each.experiment.name, each.departs, each.of) for each in source.besides]
    said = (*_code(), source.rows, source.paper.key, protocol, sorted(followed), departs)
    digest = hashlib.sha256("\0".join(map(str, said)).encode())
    for task in tasks:
        digest.update(task.key.encode())
    return digest.hexdigest()


@cache
def _code() -> tuple[str, ...]:
    files = [path for name in (_ROOM, *_BESIDES) if (path := path_of(name))]
    own = (hashlib.sha256(path.read_bytes()).hexdigest() for path in files[1:])
    return (tree(Path(files[0]).parent).hex(), *own, *installed())


def _packed(runs: Mapping[Cell, Runs], noted: Sequence[RawRun]) -> Iterator[bytes]:
    """Yield a line that says what follows, then all numbers as doubles, histories packed."""
    blobs: list[bytes] = []
    cells = []
    for cell, each in runs.items():
        curves = pack(_bytes(each.histories))
        shapes = [array.shape for array in (each.costs, each.points, each.histories)]
        cells.append([cell, shapes, len(curves), each.evaluations, each.seconds])
        blobs += (_bytes(each.costs), _bytes(each.points), curves)
    groups = []
    for names, group in groupby(noted, key=lambda run: [getattr(run, name) for name in _NAMES]):
        table = np.array([[getattr(run, name) for name in _NUMBERS] for run in group])
        groups.append([names, table.shape])
        blobs.append(_bytes(table))
    yield json.dumps([cells, groups]).encode() + b"\n"
    yield from blobs


def _bytes(array: Array) -> bytes:
    return array.astype(FLOAT).tobytes()


def _unpacked(content: bytes) -> tuple[dict[Cell, Runs], list[RawRun]]:
    line, _, _ = content.partition(b"\n")
    cells, groups = json.loads(line)
    place = len(line) + 1

    def taken(size: int) -> bytes:
        nonlocal place
        place += size
        return content[place - size : place]

    def array(shape: Sequence[int]) -> Array:
        return vector(taken(FLOAT.itemsize * math.prod(shape))).reshape(shape)

    runs = {}
    for (experiment, problem, algorithm), shapes, size, evaluations, seconds in cells:
        runs[experiment, problem, algorithm] = Runs(
            costs=array(shapes[0]),
            points=array(shapes[1]),
            histories=vector(zlib.decompress(taken(size))).reshape(shapes[2]),
            evaluations=evaluations,
            seconds=seconds,
        )
    return runs, [run for names, shape in groups for run in _noted(names, array(shape))]


def _noted(names: Sequence[str], table: Array) -> Iterator[RawRun]:
    own = dict(zip(_NAMES, names, strict=True))
    for repeat, run, cost, evaluations, seconds in table.tolist():
        yield RawRun(
            **own,
            repeat=int(repeat),
            run=int(run),
            cost=cost,
            evaluations=int(evaluations),
            seconds=seconds,
        )
