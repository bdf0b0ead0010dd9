"""Every algorithm, problem and paper gives the same bits, however its runs are spread and cut."""

import multiprocessing
import random
from collections.abc import Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from repro.functions import FUNCTIONS
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers import (
    DBO,
    DE,
    GA,
    GSA,
    GWO,
    PSO,
    SMA,
    WOA,
    HybridWOA,
    SlimeWOA,
    SteadyStateGA,
)
from repro.runs.moved_optima import centred, shifted
from repro.runs.plan import Task, plan
from repro.runs.run import Record, execute
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.studies import studies
from repro.runs.workers.dispatch import run_all
from tests.damages import LONG
from tests.house import PAPERS
from tests.small_papers import EXPERIMENT, PAPER
from tests.small_stores import timeless

SMALL = {"population": 24, "iterations": 3, "runs": 1}
ALGORITHMS = (
    DBO(), DE(), GA(), GSA(), GWO(), PSO(), SMA(), WOA(), HybridWOA(), SlimeWOA(), SteadyStateGA(),
)  # fmt: skip
STRIDE = 15  # prime to the number of searches, so that each of them is there
Content = dict[str, tuple[object, ...]]


def small(experiment: Experiment) -> Experiment:
    return replace(experiment, evaluations=None, **SMALL)  # type: ignore[arg-type]


def everything() -> Paper:
    """Return a paper of every algorithm on every function."""
    problems = {
        name: function.problem(function.fixed_dimension or 3)
        for name, function in FUNCTIONS.items()
    }
    algorithms = {type(algorithm).__name__: algorithm for algorithm in ALGORITHMS}
    experiment = replace(
        EXPERIMENT, problems=problems, algorithms=algorithms, proposed=next(iter(algorithms))
    )
    return replace(PAPER, experiments=(small(experiment),), results=(), claims=())


@cache
def tasks_of(key: str) -> tuple[Task, ...]:
    """Return small runs of every cell of a paper, its shifted functions among them."""
    paper = everything() if key == "everything" else all_papers()[key]
    experiments = [*paper.experiments]
    experiments += [
        replace(shifted(e, 0.1, floor=WOA(b=0.5)), name=f"{e.name} [moved]")
        for e in paper.experiments
        if centred(e)
    ]
    if LONG:  # other readings of the paper too
        experiments += [study.experiment for study in studies(paper, 10)]
    bare = replace(
        paper, experiments=tuple(map(small, experiments)), results=(), claims=(),
        motion_readings=(), assumptions=(), relations=(), figures=(), together=(),
    )  # fmt: skip
    return plan([bare], 1)


def content(records: Sequence[Record]) -> Content:
    assert {record.reason for record in records} == {None}
    return {record.task.name: timeless(record) for record in records}


@cache
def alone(key: str) -> Content:
    return content([execute(task) for task in tasks_of(key)])


def spread(tasks: Sequence[Task], executor: Executor, workers: int) -> Content:
    records: list[Record] = []
    with executor:
        run_all(tasks, executor, workers, records.extend)
    return content(records)


KEYS = ("everything", *PAPERS)


@pytest.mark.faults
@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("workers", [1, 2, 4])
def test_runs_are_the_same_in_any_number_of_threads_and_in_any_order(
    key: str, workers: int
) -> None:
    tasks = list(tasks_of(key))
    random.Random(workers).shuffle(tasks)  # noqa: S311 (an order, no secret)

    assert spread(tasks, ThreadPoolExecutor(workers), workers) == alone(key)


@pytest.mark.faults
@pytest.mark.parametrize("workers", [1, 2, 4] if LONG else [2])
def test_runs_are_the_same_in_processes(workers: int) -> None:
    tasks = [task for key in KEYS for task in tasks_of(key)[:: 1 if LONG else STRIDE]]
    random.Random(workers).shuffle(tasks)  # noqa: S311 (an order, no secret)
    spawned = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))

    found = spread(tasks, spawned, workers)

    expected = {name: text for key in KEYS for name, text in alone(key).items()}
    assert found == {name: expected[name] for name in found}
    assert len(found) == len(tasks)


@pytest.mark.faults
@pytest.mark.parametrize("key", KEYS)
def test_runs_are_the_same_after_interrupts(key: str, tmp_path: Path) -> None:
    tasks = tasks_of(key)
    cuts = 0
    with Store(tmp_path) as store:

        def stop(done: int, _to_do: int) -> None:
            if done >= len(tasks) // 3:
                raise KeyboardInterrupt

        while store.missing(tasks):
            try:
                with ThreadPoolExecutor(2) as executor:
                    run_missing(
                        store, tasks, executor=executor, workers=2, environment=dict, report=stop
                    )
            except KeyboardInterrupt:
                cuts += 1
        found = content(list(store.records(tasks)))

    assert found == alone(key)
    assert cuts >= 1
