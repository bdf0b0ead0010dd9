import pickle
from dataclasses import dataclass, replace

import numpy as np
import pytest

from repro.commands.catalogue import all_papers
from repro.determinism.compiled import COST, ready
from repro.optimisers import WOA
from repro.runs.plan import plan
from repro.runs.run import Record, execute
from repro.runs.workers.pickling import pack, stripped, unpack
from tests.small_papers import Guessing, searching
from tests.small_problems import small


def test_every_task_of_every_paper_comes_back_as_it_was() -> None:
    every = plan(all_papers().values(), 1)
    first = {(task.paper, task.experiment, task.problem, task.algorithm): task for task in every}
    tasks = tuple(first.values())

    for before, after in zip(tasks, unpack(pack(tasks)), strict=True):
        assert after.name == before.name
        assert after.optimiser == before.optimiser
        assert repr(after.subject.identity) == repr(before.subject.identity)
        assert after.subject.data.tobytes() == before.subject.data.tobytes()
        assert after.subject.kernel is before.subject.kernel  # the same machine code, not a copy


def test_tasks_of_a_cell_share_what_they_have_in_common() -> None:
    tasks = tuple(plan(all_papers().values(), 1)[:100])

    assert len(pack(tasks)) < 100 * 400 + 2 * len(pack(tasks[:1]))


def test_kernel_that_no_module_names_travels_whole() -> None:
    task = plan([searching(WOA=WOA())], 1)[0]
    noting = small("rosenbrock")
    unnamed = replace(task, subject=replace(noting, scratch=len(noting.data)))

    (again,) = unpack(pack((unnamed,)))

    costs = [
        ready(task.subject.kernel, COST)(np.array([1.0, -2.0, 3.0]), task.subject.data)
        for task in (again, unnamed)
    ]
    assert costs[0] == costs[1] > 0.0


def test_task_of_a_class_that_nobody_else_can_find_is_refused() -> None:
    @dataclass(frozen=True)
    class Hidden(Guessing):
        pass

    with pytest.raises((pickle.PicklingError, AttributeError)):
        pack((plan([searching(hidden=Hidden())], 1)[0],))


def test_stripped_record_is_whole_again_with_its_task() -> None:
    record = execute(plan([searching(guess=Guessing())], 1)[0])

    again = Record(task=record.task, **pickle.loads(pickle.dumps(stripped(record))))  # noqa: S301

    assert again.task is record.task
    assert again.cost == record.cost
    assert np.array_equal(again.x, record.x)
    assert np.array_equal(again.history, record.history)
    assert "task" not in stripped(record)
