"""One run and its record: the same bits wherever and whenever it is made."""

import sysconfig
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.plain_costs import releases_interpreter
from repro.optimisers.search import HoldsInterpreter, Result, hands_to_search
from repro.runs.apart import GlobalDraws, fresh
from repro.runs.plan import Task
from repro.runs.rules import conduct, fault

Vector = NDArray[np.float64]
_SHOWN = 300  # characters of a message that a reason shows
_ENGINE = str(Path(__file__).parents[1])
_LIBRARIES = tuple(sysconfig.get_path(name) for name in ("stdlib", "purelib", "platlib"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Record:
    """What one run gave; `reason` says why a failed run has no result.

    `environment` is that of the machine where it was made, None for this one.
    """

    task: Task
    cost: float
    x: Vector
    history: Vector
    evaluations: int
    seconds: float
    reason: str | None = None
    environment: Mapping[str, object] | None = None


def execute(task: Task) -> Record:
    """Return the record of one run: the same bits wherever and whenever it runs.

    An exception, a cost that is not finite, and a search that breaks its rules (see `conduct`)
    are recorded as a failed run with its reason.
    """
    start = time.perf_counter()
    try:
        prepare(task)
        start = time.perf_counter()
        result, reason, seconds = _made(task)
    except (Exception, SystemExit) as error:  # noqa: BLE001 (one run's fault costs no other)
        return failed(task, told(error), time.perf_counter() - start)
    if reason:
        return failed(task, reason, seconds)
    return Record(
        task=task,
        cost=result.cost,
        x=result.x,
        history=result.history,
        evaluations=result.evaluations,
        seconds=seconds,
    )


def _made(task: Task) -> tuple[Result, str | None, float]:
    """Return what a search found, what is wrong with it, and how many seconds it took."""
    start = time.perf_counter()
    plain = holds_interpreter(task)
    shared = _watched(task) if plain else None  # compiled code cannot reach them
    budget = _budget(task)
    result, given = conduct(
        fresh(task.optimiser) if plain else task.optimiser,
        fresh(task.subject) if plain else task.subject,
        task.stream,
        population=task.population,
        **budget,
    )
    seconds = time.perf_counter() - start
    reason = (shared.fault() if shared else None) or fault(
        result,
        given,
        optimiser=task.optimiser,
        population=task.population,
        iterations=budget.get("iterations"),
        evaluations=task.evaluations,
    )
    return result, reason, seconds


def _watched(task: Task) -> GlobalDraws | None:
    """Return the shared generators, as they are; None where a run may draw from them."""
    return None if getattr(task.optimiser, "seeds_shared", False) else GlobalDraws()


def prepare(task: Task) -> None:
    """Load and compile what a search that can be prepared needs: its time is that of its runs."""
    make_ready = getattr(task.optimiser, "prepare", None)
    if callable(make_ready):
        make_ready(task.subject)


def _budget(task: Task) -> dict[str, int]:
    if task.evaluations is None:
        return {"iterations": task.iterations}
    return {"evaluations": task.evaluations}


def told(error: BaseException) -> str:
    """Return what was raised, in one line, and the line of the user's own code that did."""
    says = " ".join(str(error).split())
    shown = says if len(says) <= _SHOWN else f"{says[:_SHOWN]}…"
    return f"{type(error).__name__}: {shown}{_own_line(error)}"


def _own_line(error: BaseException) -> str:
    """Return the file and line, in brackets, that was reached last outside of all libraries.

    Where everything is installed it is the first line that this engine called.
    """
    frames = [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if not frame.filename.startswith(_ENGINE) and Path(frame.filename).is_file()
    ]
    own = [frame for frame in frames if not frame.filename.startswith(_LIBRARIES)]
    if not frames:
        return ""
    frame = own[-1] if own else frames[0]
    return f" ({Path(frame.filename).name}, line {frame.lineno})"


def failed(task: Task, reason: str, seconds: float) -> Record:
    """Return the record of a run that has no result."""
    nothing = np.zeros(0)
    return Record(
        task=task, cost=float("nan"), x=nothing, history=nothing, evaluations=0, seconds=seconds,
        reason=reason,
    )  # fmt: skip


def holds_interpreter(task: Task) -> bool:
    """Return whether a run keeps other threads from running, so that it needs its own process.

    A search or a problem may say so by `holds_interpreter`. Of those that do not, a search does
    unless its `minimise` hands a kernel to `repro.optimisers.search.search`, and a problem does
    unless its cost is compiled.
    """
    return _holds(task.optimiser, hands_to_search) or _holds(
        task.subject, lambda subject: releases_interpreter(subject.kernel)
    )


def _holds(part: Any, is_free: Callable[[Any], bool]) -> bool:  # noqa: ANN401 (the user's own)
    if isinstance(part, HoldsInterpreter):
        return part.holds_interpreter
    return not is_free(part)


def execute_all(tasks: tuple[Task, ...]) -> list[Record]:
    """Return the records of a batch, in order; what executors are handed."""
    return [execute(task) for task in tasks]
