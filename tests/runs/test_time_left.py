from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import pytest

from repro.functions import FUNCTIONS
from repro.optimisers import WOA
from repro.optimisers.libraries import CMAES
from repro.runs.plan import Task
from repro.runs.store.questions import Kind
from repro.runs.time_left import TimeLeft, kind_of

SPHERE = FUNCTIONS["sphere"].problem(2)
ONE = Task(
    paper="p", experiment="e", problem="f", algorithm="a", repeat=1, run=1, key="",
    optimiser=WOA(), subject=SPHERE, population=10, iterations=100,
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Sort:
    """Some runs of one kind that take equally long, but for the first one's compiling."""

    algorithm: str = "a"
    problem: str = "f"
    count: int = 100
    seconds: float = 0.01
    compiling: float = 0.0
    in_python: bool = False

    def tasks(self) -> list[Task]:
        """Return the runs, which are alike."""
        search = CMAES() if self.in_python else WOA()
        one = replace(ONE, algorithm=self.algorithm, problem=self.problem, optimiser=search)
        return [one] * self.count

    def taken(self) -> list[float]:
        """Return how many seconds each of them takes."""
        return [self.seconds + self.compiling, *([self.seconds] * (self.count - 1))]


some = partial(Sort, seconds=0.5e-3)
PYTHON = partial(Sort, in_python=True, count=4)
CASES: dict[str, Sequence[Sort]] = {
    "one kind": [some(count=1000)],
    "the protocol once, all of it, readings, and then what is 50 times as slow": [
        some(algorithm=f"a{k}", problem=problem, seconds=0.5e-3 * k, count=count)
        for problem, count in (("f", 40), ("f", 360), ("read otherwise", 100))
        for k in (1, 2, 3, 5)
    ]
    + [PYTHON(algorithm=f"b{k}", seconds=60e-3 * k, problem=p) for k in (1, 1.2) for p in "fgh"],
    "a first run that is compiled for seconds": [
        some(algorithm=f"a{k}", compiling=0.05, count=500) for k in range(4)
    ],
    "a machine three times as slow": [
        some(seconds=1.5e-3, count=2000), PYTHON(algorithm="b", seconds=75e-3, count=40),
    ],
}  # fmt: skip


def far_off(sorts: Sequence[Sort], earlier: Mapping[Kind, float], workers: int = 2) -> float:
    """Return by which share of the truth the time left is off at worst, from a tenth on."""
    left = TimeLeft()
    left.expect((task for sort in sorts for task in sort.tasks()), earlier)
    whole = sum(sum(sort.taken()) for sort in sorts) / workers
    now, worst = 0.0, 0.0
    for sort in sorts:
        for task, seconds in zip(sort.tasks(), sort.taken(), strict=True):
            now += seconds / workers
            left.note(kind_of(task), seconds)
            truth = whole - now
            if 0.1 * whole <= now and truth > 0.01 * whole:
                worst = max(worst, abs(left.outlook(now)[1] / truth - 1.0))
    return worst


@pytest.mark.parametrize("case", CASES)
def test_time_left_is_right_within_a_third_from_a_tenth_on_without_earlier_runs(case: str) -> None:
    assert far_off(CASES[case], {}) <= 0.3


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("factor", [0.8, 1.2])
def test_earlier_runs_tell_what_those_of_their_kind_take(case: str, factor: float) -> None:
    earlier = {
        kind_of(sort.tasks()[0]): factor * sort.seconds * (2.0 if sort.in_python else 1.0)
        for sort in CASES[case]
    }
    slow = [
        replace(sort, seconds=2.0 * sort.seconds) if sort.in_python else sort
        for sort in CASES[case]
    ]

    assert far_off(slow, earlier) <= 0.3


def test_nothing_is_left_when_every_run_is_done() -> None:
    left = TimeLeft()
    left.expect([ONE], {})

    left.note(kind_of(ONE), 2.0)

    assert (left.runs, left.outlook(2.0)) == (0, (1.0, 0.0))


def test_phase_after_another_knows_what_its_kinds_took() -> None:
    left = TimeLeft()
    left.expect([ONE] * 10, {})
    for _ in range(10):
        left.note(kind_of(ONE), 3.0)

    left.expect([ONE] * 11, {})
    left.note(kind_of(ONE), 3.0)

    assert left.outlook(1.5) == pytest.approx((1 / 11, 15.0))
