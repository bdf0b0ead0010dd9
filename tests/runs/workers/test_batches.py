from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.workers.batches import MOST, Batches
from tests.small_papers import EXPERIMENT, PAPER

RUNS = 300
TASKS = plan([replace(PAPER, experiments=(replace(EXPERIMENT, runs=RUNS),))], 1)
GUESS, WIDE = TASKS[:RUNS], TASKS[RUNS:]


def taking(task: Task, seconds: float) -> Record:
    nothing = np.zeros(0)
    return Record(task=task, cost=1.0, x=nothing, history=nothing, evaluations=1, seconds=seconds)


def test_batch_is_one_run_before_anything_is_known() -> None:
    batches = Batches(TASKS, 10.0)

    assert [next(batches), next(batches)] == [(TASKS[0],), (TASKS[1],)]


def test_batch_takes_about_as_long_as_asked() -> None:
    batches = Batches(TASKS, 1.0)
    batches.learn([taking(TASKS[0], 0.099)])

    assert next(batches) == TASKS[:10]


def test_run_of_a_new_cell_is_thought_to_cost_what_the_slowest_known_costs_per_evaluation() -> None:
    threefold = tuple(replace(task, population=task.population * 3) for task in WIDE)
    batches = Batches(threefold, 1.0)
    batches.learn([taking(GUESS[0], 0.033), taking(GUESS[1], 0.011)])

    assert len(next(batches)) == 10


def test_batch_may_hold_runs_of_several_cells() -> None:
    batches = Batches((GUESS[0], WIDE[0], GUESS[1]), 1.0)
    batches.learn([taking(GUESS[0], 0.1), taking(WIDE[0], 0.8)])

    assert next(batches) == (GUESS[0], WIDE[0], GUESS[1])


def test_slow_run_ends_the_batch_before_it() -> None:
    batches = Batches((GUESS[0], WIDE[0], GUESS[1]), 1.0)
    batches.learn([taking(GUESS[0], 0.1), taking(WIDE[0], 5.0)])

    assert [*batches] == [(GUESS[0],), (WIDE[0],), (GUESS[1],)]


def test_latest_runs_count_most() -> None:
    batches = Batches(TASKS, 1.0)
    batches.learn([taking(TASKS[0], 64.0)])
    batches.learn([taking(TASKS[0], 0.0)] * 10)

    assert len(next(batches)) == 16


def test_batch_of_runs_that_take_no_time_is_bounded() -> None:
    batches = Batches(TASKS, 1.0)
    batches.learn([taking(TASKS[0], 0.0)])

    assert len(next(batches)) == MOST < RUNS


@given(st.lists(st.floats(0.0, 2.0), max_size=30), st.integers(0, len(TASKS)), st.floats(0.0, 3.0))
def test_every_task_is_in_one_batch_and_in_order(
    durations: list[float], count: int, seconds: float
) -> None:
    batches = Batches(TASKS[:count], seconds)
    found: list[Task] = []
    learnt = iter(durations)

    for batch in batches:
        found += batch
        batches.learn([taking(batch[0], next(learnt, 0.1))])

    assert found == list(TASKS[:count])


def test_nothing_is_taken_before_it_is_asked_for() -> None:
    def planned() -> Iterator[Task]:
        yield TASKS[0]
        pytest.fail("a second task was taken")

    assert next(Batches(planned(), 1.0)) == (TASKS[0],)
