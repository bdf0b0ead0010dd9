"""Compiled code: what is said of it before any run, and how it comes about sooner."""

import os
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path

from repro import optimisers
from repro.commands.shown_rows import warn
from repro.determinism import compiled
from repro.runs.plan import Task
from repro.runs.run import execute
from repro.runs.workers.local import usable_cores
from repro.runs.workers.side_by_side import beside

_FOLDER = Path(optimisers.__file__).parent.name  # in which numba keeps what is of this package


def say_whether_kept() -> None:
    """Say where compiled code cannot be kept: every call compiles it again then."""
    if compiled.KEPT is None:
        warn(
            "compiled code cannot be kept, so every call compiles again: no folder can be written; "
            "name one in NUMBA_CACHE_DIR"
        )


def compiling_ahead(*groups: Sequence[Task]) -> AbstractContextManager[None]:
    """Have a copy of this process compile, where no search is compiled yet.

    One process compiles one function at a time, so the copy begins at the other end: with the last
    run of the first group, then of the next. Each finds in the folder what the other has compiled.
    """
    folder = compiled.KEPT
    known = not groups or folder is None or any(folder.glob(f"{_FOLDER}_*/*.nbi"))
    if known or usable_cores() < 2:
        return nullcontext()
    return beside(partial(_compile, groups))


def _compile(groups: Sequence[Sequence[Task]]) -> None:
    first = os.getppid()
    for tasks in groups:
        for task in reversed([*_one_of_each(tasks)]):
            if os.getppid() != first:  # it was killed
                return
            execute(replace(task, iterations=1, evaluations=None))


def _one_of_each(tasks: Sequence[Task]) -> Iterator[Task]:
    """Yield a run of each pair of a search of ours and a cost."""
    seen = set()
    for task in tasks:
        pair = type(task.optimiser), task.subject.kernel
        if pair not in seen and pair[0].__module__.startswith(f"{optimisers.__name__}."):
            seen.add(pair)
            yield task
