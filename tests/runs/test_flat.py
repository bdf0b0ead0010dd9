"""Memory does not grow with the runs: planning, looking up what is missing, running, storing."""

import tracemalloc
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from repro.runs import plan as planning
from repro.runs.plan import plan, planned
from repro.runs.session import run_missing
from repro.runs.store import questions
from repro.runs.store.store import Store
from tests.small_papers import PAPER

FEW, MANY = 40, 400  # repeats
GROWTH = 1.5  # of the peak, for ten times the runs


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


def made(folder: Path, repeats: int) -> None:
    """Run everything, in batches, and ask what is missing after that."""
    tasks = planned([PAPER], repeats)
    with Store(folder) as store, ThreadPoolExecutor(1) as executor:
        failed = run_missing(
            store, tasks, executor=executor, workers=1, environment=dict,
            report=lambda *_: None, batch_seconds=0.01,
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


def test_ten_times_the_runs_take_no_more_memory(tmp_path: Path) -> None:
    made(tmp_path / "first", 1)  # loads and compiles what it needs
    few, many = (
        peak(lambda repeats=repeats: made(tmp_path / str(repeats), repeats))  # type: ignore[misc]
        for repeats in (FEW, MANY)
    )

    assert many < GROWTH * few
