"""Whether a search's runs come out again: a sampled one made anew, alone, after another, otherwise.

Each is made in a fresh process, so that what one leaves behind reaches no other.
"""

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Literal, Unpack

import numpy as np

from repro.determinism.seeds import generator
from repro.errors import InputError
from repro.optimisers.search import Budget, Problem, Result
from repro.runs.plan import Task
from repro.runs.run import Record, execute
from repro.runs.verify import Outcome, compare
from repro.runs.workers.process import StoppedError, WorkerProcess

Kind = Literal[
    "hidden randomness",
    "state between runs",
    "identical runs",
    "uncounted evaluations",
    "mean against chance",
]
SALT = "otherwise"
_NOTED = "it is to be said that "


@dataclass(frozen=True, slots=True, kw_only=True)
class Warned:
    """Something that a reader of a comparison must know."""

    kind: Kind
    says: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Probe:
    """An entrant whose shared generators are seeded with a salt, after another run of it or none.

    With `tells` it fails with what is to be said of how the run was counted, if there is anything.
    """

    holds_interpreter: ClassVar[bool] = True
    seeds_shared: ClassVar[bool] = True
    entrant: Any
    salt: str = ""
    after: str = ""
    tells: bool = False

    def prepare(self, problem: Problem) -> None:
        """Load the search and compile the cost."""
        self.entrant.prepare(problem)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return what the entrant finds; see there."""
        if self.after:
            first: Any = {**budget, "rng": generator(self.after)}
            self.entrant.noted(problem, first)
        result: Result
        result, note = self.entrant.noted(problem, budget, self.salt)
        if self.tells and note:
            raise InputError(_NOTED + note)
        return result


def probed(tasks: Sequence[Task], stored: dict[str, Record], executor: Executor) -> list[Warned]:
    """Return what a sampled run of each search says of it; `tasks` are finished and `stored`.

    The sample is the last run of the first problem on which there are several.
    """
    searches: dict[str, list[Task]] = {}
    for task in tasks:
        if task.key in stored and stored[task.key].reason is None:
            searches.setdefault(task.algorithm, []).append(task)
    asked = []
    for own in searches.values():
        task = _sampled(own)
        processes = (
            # what is said of the count needs no process that nothing ran in before
            [_probe(task), _probe(task, tells=True)],
            [_probe(task, salt=SALT)],
            [_probe(task, after=_another(own, task).stream)],
        )
        asked.append((task, [executor.submit(_apart, probes) for probes in processes]))
    found: list[Warned] = []
    for task, futures in asked:
        (alone, counted), (otherwise,), (after,) = (future.result() for future in futures)
        found += told(stored[task.key], alone, otherwise, after, counted)
    return found


def _sampled(tasks: Sequence[Task]) -> Task:
    """Return the last run of the first cell."""
    first = tasks[0]
    place = (first.paper, first.experiment, first.problem)
    return [t for t in tasks if (t.paper, t.experiment, t.problem) == place][-1]


def _another(tasks: Sequence[Task], task: Task) -> Task:
    """Return a run of another seed; the same where there is one alone."""
    return next((t for t in tasks if t.stream != task.stream), task)


def _probe(task: Task, **kind: Any) -> Task:  # noqa: ANN401 (fields of a probe)
    timeout = None if task.timeout is None else task.timeout * (2 if "after" in kind else 1)
    return replace(task, optimiser=Probe(entrant=task.optimiser, **kind), timeout=timeout)


def _apart(tasks: Sequence[Task]) -> list[Record]:
    """Return the records of runs one after another in a process that does nothing else."""
    worker = WorkerProcess()
    try:
        return [worker.execute(task) for task in tasks]
    except StoppedError:
        return list(map(execute, tasks))
    finally:
        worker.close()


def told(
    stored: Record, alone: Record, otherwise: Record, after: Record, counted: Record
) -> Iterator[Warned]:
    """Yield what differs between a run and the same made again."""
    run, name = stored.task.name, stored.task.algorithm
    if _differ(alone, otherwise):
        end, differs = _ends(alone, otherwise)
        yield Warned(
            kind="hidden randomness",
            says=f"{name} draws from what it was not given: run {run} ends {end}, and {differs} "
            "with other global seeds; only `rng` is seeded by the run",
        )
    elif _differ(alone, after) or _differ(alone, stored):
        other = after if _differ(alone, after) else stored
        end, differs = _ends(alone, other)
        yield Warned(
            kind="state between runs",
            says=f"{name} remembers earlier runs: run {run} ends {end} when it is made alone, and "
            f"{differs} after another",
        )
    if counted.reason and _NOTED in counted.reason:
        note = counted.reason.partition(_NOTED)[2]
        yield Warned(
            kind="uncounted evaluations",
            says=f"{name} counts otherwise than its cost: {note}; shown is what was counted",
        )


def _differ(one: Record, other: Record) -> bool:
    """Return whether two records of one run are not the same bits."""
    if one.reason or other.reason:
        return one.reason != other.reason
    return compare(one, other).outcome is not Outcome.MATCH


def _ends(one: Record, other: Record) -> tuple[str, str]:
    """Return how each of two records ends, by what differs between them."""
    first, second = _end(one), _end(other)
    if first != second:
        return first, second
    if one.evaluations != other.evaluations:
        return _counted(one, first), _counted(other, first)
    if one.x.tobytes() != other.x.tobytes():
        return first, "at another point of the same cost"
    return first, "there by another way"


def _counted(record: Record, end: str) -> str:
    count = record.evaluations
    return f"{end} with {count} evaluation{'' if count == 1 else 's'}"


def _end(record: Record) -> str:
    return f"in a failure ({record.reason})" if record.reason else f"at {record.cost!r}"


def identical(tasks: Sequence[Task], stored: dict[str, Record]) -> list[Warned]:
    """Return which searches gave the very same run under several seeds."""
    cells: dict[tuple[str, str, str, str], list[bytes]] = {}
    for task in tasks:
        record = stored.get(task.key)
        if record is not None and record.reason is None:
            cell = (task.algorithm, task.paper, task.experiment, task.problem)
            bits = np.concatenate([record.history, record.x, [record.cost]]).tobytes()
            cells.setdefault(cell, []).append(bits)
    same: dict[str, list[str]] = {}
    for (name, *place), runs in cells.items():
        if len(set(runs)) < len(runs):
            text = f"{'/'.join(place)} ({len(set(runs))} different of {len(runs)})"
            same.setdefault(name, []).append(text)
    return [
        Warned(
            kind="identical runs",
            says=f"{name} gives the same run under other seeds: {_some(places)}; as one "
            "does that draws nothing from `rng`: its runs are no sample",
        )
        for name, places in same.items()
    ]


def _some(places: Sequence[str], most: int = 4) -> str:
    more = f" and {len(places) - most} more" if len(places) > most else ""
    return ", ".join(places[:most]) + more
