from dataclasses import replace

import numpy as np
import pytest

from repro.runs.honesty import Warned, told
from repro.runs.run import Record, failed
from tests.held_searches import tasks_of
from tests.small_papers import Guessing

TASK = tasks_of(guess=Guessing())[0]
ALONE = Record(
    task=TASK,
    cost=0.29,
    x=np.array([0.5, 0.2]),
    history=np.array([0.4, 0.29]),
    evaluations=20,
    seconds=0.1,
)
OTHERS = {
    "cost": (replace(ALONE, cost=0.3), "at 0.29", "at 0.3"),
    "evaluations": (
        replace(ALONE, evaluations=1),
        "at 0.29 with 20 evaluations",
        "at 0.29 with 1 evaluation",
    ),
    "point": (
        replace(ALONE, x=np.array([0.2, 0.5])),
        "at 0.29",
        "at another point of the same cost",
    ),
    "history": (replace(ALONE, history=np.array([0.5, 0.29])), "at 0.29", "there by another way"),
    "failure": (failed(TASK, "lost", 0.1), "at 0.29", "in a failure (lost)"),
}


def says(otherwise: Record, after: Record) -> list[Warned]:
    return list(told(ALONE, ALONE, otherwise, after, ALONE))


def test_run_that_comes_out_again_is_told_nothing_of() -> None:
    assert says(ALONE, ALONE) == []


@pytest.mark.parametrize("name", OTHERS)
def test_run_that_comes_out_otherwise_is_told_by_what_differs(name: str) -> None:
    other, end, differs = OTHERS[name]
    (state,), (hidden,) = says(ALONE, other), says(other, ALONE)

    assert (
        f"{TASK.name} ends {end} when it is made alone, and {differs} after another" in state.says
    )
    assert f"{TASK.name} ends {end}, and {differs} with other global seeds;" in hidden.says
