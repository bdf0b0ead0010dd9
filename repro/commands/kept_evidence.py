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
from repro.runs.gather import (
    cell_of,
    evidence_of,
    followed_cells,
    gather,
    is_measured,
    known_experiments,
)
from repro.runs.plan import Task
from repro.runs.raw_runs import NUMBERS, RawCell, RawRuns
from repro.runs.store.row import FLOAT, pack, vector
from repro.runs.store.store import Store
from repro.runs.studies import Study

_ROOM = "repro.runs"
_BESIDES = ("repro.model.evidence", __name__)
_NAMES = ("study", "experiment", "problem", "algorithm")
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
        noted: Sequence[RawCell] = own.cells()
        if name:
            keep(folder, name, b"".join(_packed(found.runs, noted)))
    else:
        runs, noted = _unpacked(content)
        found = evidence_of(source.paper, source.besides, runs)
    raw.add(noted)
    return found


def _name(source: OfStore, tasks: Sequence[Task]) -> str:
    known = known_experiments(source.paper, source.besides)
    followed = followed_cells(source.paper, source.besides)
    cells = [
        (cell, known[cell[0]].runs, cell in followed, is_measured(known[cell[0]], *cell[1:]))
        for cell, _ in groupby(tasks, key=cell_of)
        if cell[0] in known
    ]
    departs = [(each.experiment.name, each.departs, each.of) for each in source.besides]
    said = (*_code(), source.rows, source.paper.key, cells, departs)
    digest = hashlib.sha256("\0".join(map(str, said)).encode())
    for task in tasks:
        digest.update(task.key.encode())
    return digest.hexdigest()


@cache
def _code() -> tuple[str, ...]:
    files = [path for name in (_ROOM, *_BESIDES) if (path := path_of(name))]
    own = (hashlib.sha256(path.read_bytes()).hexdigest() for path in files[1:])
    return (tree(Path(files[0]).parent).hex(), *own, *installed())


def _packed(runs: Mapping[Cell, Runs], noted: Sequence[RawCell]) -> Iterator[bytes]:
    """Yield a line that says what follows, then all numbers as they are, but histories packed."""
    blobs: list[bytes] = []
    cells = []
    for cell, each in runs.items():
        curves = pack(_bytes(each.histories))
        shapes = [array.shape for array in (each.costs, each.points, each.histories)]
        cells.append([cell, shapes, len(curves), each.evaluations, each.seconds])
        blobs += (_bytes(each.costs), _bytes(each.points), curves)
    blobs += (getattr(cell, name).tobytes() for cell in noted for name in NUMBERS)
    names = [[[getattr(each, name) for name in _NAMES], len(each.run)] for each in noted]
    yield json.dumps([cells, names]).encode() + b"\n"
    yield from blobs


def _bytes(array: Array) -> bytes:
    return array.astype(FLOAT).tobytes()


def _unpacked(content: bytes) -> tuple[dict[Cell, Runs], list[RawCell]]:
    line, _, _ = content.partition(b"\n")
    cells, names = json.loads(line)
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
    noted = [RawCell(*own) for own, _ in names]
    for cell, (_, count) in zip(noted, names, strict=True):
        for name in NUMBERS:
            column = getattr(cell, name)
            column.frombytes(taken(count * column.itemsize))
    return runs, noted
