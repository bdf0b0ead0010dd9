"""Memory does not grow with the runs: planning, looking up what is missing, running, storing."""

import tracemalloc
from collections.abc import Callable
from concurrent.futures import Executor, Future
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from repro.commands.kept_pages import Request, extent_of
from repro.commands.written_pages import pages
from repro.runs import plan as planning
from repro.runs.plan import Task, of_paper, plan, planned
from repro.runs.run import Record
from repro.runs.session import run_missing
from repro.runs.store import questions
from repro.runs.store.store import Store
from tests.small_papers import PAPER

NOTHING = np.zeros(1)
FEW, MANY = 100, 500  # repeats
GROWTH = 1.5  # of the peak, for five times the runs
OF_A_RUN = 400  # bytes: what is published of it, as numbers and as text; a task has 250 more


@pytest.fixture(autouse=True)
def _nothing_is_held(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(planning, "HELD", 0)
    monkeypatch.setattr(questions, "HELD", 0)


def peak(call: Callable[[], object]) -> int:
    """Return the most bytes that a call holds at once."""
    tracemalloc.start()
    try:
        call()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


class Inventing(Executor):
    """Gives a record for each task at once, out of thin air."""

    def submit(  # type: ignore[override]
        self, _: object, tasks: tuple[Task, ...], /
    ) -> Future[list[Record]]:
        """Return what is done already."""
        future: Future[list[Record]] = Future()
        future.set_result([
            Record(task=task, cost=1.0, x=NOTHING, history=NOTHING, evaluations=1, seconds=0.01)
            for task in tasks
        ])  # fmt: skip
        return future


def made(folder: Path, repeats: int) -> None:
    """Run everything, in batches, and ask what is missing after that."""
    tasks = planned([PAPER], repeats)
    with Store(folder) as store:
        failed = run_missing(
            store, tasks, executor=Inventing(), workers=1, environment=dict,
            report=lambda *_: None, batch_seconds=0.1,
        )  # fmt: skip
        assert not failed
        assert not any(store.lacking(tasks))


def test_plan_that_is_not_held_is_the_one_that_is() -> None:
    long = planned([PAPER], 3)

    assert not isinstance(long, tuple)
    assert tuple(long) == plan([PAPER], 3) == tuple(long[k] for k in range(len(long)))
    assert long[-4:2:-2] == tuple(long)[-4:2:-2]
    with pytest.raises(IndexError):
        long[len(long)]


def test_runs_of_one_paper_are_the_same_whether_the_plan_is_held(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    papers = [PAPER, replace(PAPER, key="other2020")]
    long = of_paper(planned(papers, 3), "other2020")

    assert not isinstance(long, tuple)
    assert tuple(long) == of_paper(plan(papers, 3), "other2020")
    monkeypatch.setattr(planning, "HELD", 10**6)
    assert of_paper(planned(papers, 3), "other2020") == tuple(long)
    assert of_paper(planned(papers, 3), "third2020") == ()


def test_five_times_the_runs_take_no_more_memory(tmp_path: Path) -> None:
    made(tmp_path / "first", FEW)  # loads and compiles what it needs
    few, many = (
        peak(lambda repeats=repeats: made(tmp_path / str(repeats), repeats))  # type: ignore[misc]
        for repeats in (FEW, MANY)
    )

    assert many < GROWTH * few


def test_judging_and_writing_hold_little_of_each_run(tmp_path: Path) -> None:
    peaks, counts = [], []
    for repeats in (FEW, FEW, MANY):  # the first one loads and compiles what it needs
        folder = tmp_path / str(repeats)
        tasks = planned([PAPER], repeats)
        made(folder, repeats)
        request = Request(paper=PAPER, tasks=lambda tasks=tasks: tasks, extent=extent_of(tasks))  # type: ignore[misc]
        with Store(folder, writing=False) as store:
            peaks.append(peak(partial(pages, store, request)))
        counts.append(len(tasks))

    grown = (peaks[2] - peaks[1]) / (counts[2] - counts[1])

    assert grown < OF_A_RUN
