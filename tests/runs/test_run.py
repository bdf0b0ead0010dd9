import importlib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from repro.runs.plan import plan
from repro.runs.run import Record, execute, execute_all, holds_interpreter
from tests.held_searches import Telling
from tests.small_papers import EXPERIMENT, LOST, PAPER, Bowl, Failing, Guessing, searching

TASKS = plan([replace(PAPER, experiments=(replace(EXPERIMENT, runs=50),))], 1)

LOST_SEARCH = """import json


def told(text):
    return json.loads(text)


def search(cost, bounds, budget, rng):
    return told("no json")
"""


def same(first: Record, second: Record) -> bool:
    return (
        first.task is second.task
        and first.cost == second.cost
        and first.x.tobytes() == second.x.tobytes()
        and first.history.tobytes() == second.history.tobytes()
    )


def test_run_gives_the_same_bits_every_time() -> None:
    assert all(same(execute(task), execute(task)) for task in TASKS[:4])


def test_record_is_what_the_search_returned() -> None:
    record = execute(TASKS[0])

    assert record.reason is None
    assert record.cost == record.history[-1]
    assert record.cost == pytest.approx(TASKS[0].subject.kernel(record.x, TASKS[0].subject.data))
    assert (record.history.shape, record.evaluations) == ((5,), 20)
    assert record.seconds > 0.0


def test_runs_differ_from_each_other() -> None:
    assert len({execute(task).cost for task in TASKS}) == len(TASKS)


@pytest.mark.parametrize(
    ("cost", "reason"),
    [
        (None, LOST),
        (float("nan"), "the best cost is nan at x = [0.0, 0.0]"),
        (float("inf"), "the best cost is inf"),
        (float("-inf"), "the best cost is -inf"),
    ],
)
def test_run_without_a_finite_cost_fails_with_its_reason(cost: float | None, reason: str) -> None:
    record = execute(plan([searching(bad=Failing(cost=cost))], 1)[0])

    assert record.reason == reason
    assert np.isnan(record.cost)
    assert record.x.size == record.history.size == record.evaluations == 0


def test_batch_gives_a_record_for_each_task_in_order() -> None:
    records = execute_all(TASKS[:5])

    assert [record.task for record in records] == list(TASKS[:5])
    assert all(same(record, execute(record.task)) for record in records)


def test_search_or_problem_says_that_it_holds_the_interpreter() -> None:
    class Held(Bowl):
        holds_interpreter = True

    telling, guessing = (plan([searching(a=search)], 1)[0] for search in (Telling(), Guessing()))

    assert holds_interpreter(telling)
    assert not holds_interpreter(guessing)
    assert holds_interpreter(replace(guessing, subject=Held()))


def test_an_error_is_told_with_the_last_line_of_the_users_own_code(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "lost_search.py").write_text(LOST_SEARCH)
    monkeypatch.syspath_prepend(tmp_path)
    search: Any = importlib.import_module("lost_search").search

    record = execute(plan([searching(bad=search)], 1)[0])

    assert (record.reason or "").startswith("JSONDecodeError: Expecting value")
    assert (record.reason or "").endswith(" (lost_search.py, line 5)")
