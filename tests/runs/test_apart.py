"""Runs of plain Python: the same bits alone, in a batch, in threads and in processes."""

import random
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Unpack

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.functions import BoxProblem
from repro.optimisers import PSO, WOA
from repro.optimisers.search import Budget, Problem, Result
from repro.runs.plan import Task, plan
from repro.runs.run import Record, execute, holds_interpreter
from repro.runs.workers.dispatch import run_all
from repro.runs.workers.local import local
from tests.small_papers import EXPERIMENT, Bowl, Guessing, searching

Vector = NDArray[np.float64]


def slope(x: Vector) -> float:
    return float(x.sum())


def walk(
    cost: Callable[[Vector], float], bounds: Vector, budget: int, rng: np.random.Generator
) -> Vector:
    x: Vector = bounds.mean(axis=1)
    for _ in range(budget - 1):
        step = np.clip(x + 0.1 * rng.standard_normal(len(x)), bounds[:, 0], bounds[:, 1])
        x = min(x, step, key=cost) if budget > 2 else step
    return x


@dataclass(frozen=True, kw_only=True)
class Learning(Guessing):
    """A search that keeps what it found in earlier runs."""

    holds_interpreter: ClassVar[bool] = True
    known: list[float] = field(default_factory=list)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Guess in a box that gets smaller with every run."""
        self.known.append(0.5)
        found = Guessing(width=float(np.prod(self.known)))
        return found.minimise(problem, **budget)


SLOPE = BoxProblem(cost=slope, box=[(0.001, 1.0)] * 3)


def tasks(problem: Any = SLOPE, **algorithms: Any) -> tuple[Task, ...]:  # noqa: ANN401
    """Return three runs of each search on a problem."""
    paper = searching()
    experiment = replace(
        EXPERIMENT,
        problems={"p": problem},
        algorithms=algorithms,
        runs=3,
        proposed=next(iter(algorithms)),
    )
    return plan([replace(paper, experiments=(experiment,))], 1)


def bits(record: Record) -> tuple[object, ...]:
    """Return all that must be the same."""
    return record.reason, record.cost, record.x.tobytes(), record.history.tobytes()


def reason(problem: Any = SLOPE, **algorithm: Any) -> str:  # noqa: ANN401
    """Return why the first run failed."""
    return str(execute(tasks(problem, **algorithm)[0]).reason)


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.parametrize("processes", [False, True])
def test_plain_parts_give_the_same_bits_alone_and_on_any_workers(
    workers: int, *, processes: bool
) -> None:
    batch = tasks(walk=walk, WOA=WOA())
    records: dict[str, Record] = {}

    with local(workers, processes=processes) as executor:
        run_all(
            batch, executor, workers, lambda made: records.update({r.task.name: r for r in made})
        )

    assert [bits(records[task.name]) for task in batch] == [bits(execute(task)) for task in batch]
    assert {record.reason for record in records.values()} == {None}


def test_process_follows_from_what_is_compiled() -> None:
    compiled, plain_search = tasks(Bowl(), WOA=WOA())[0], tasks(Bowl(), walk=walk)[0]

    assert not holds_interpreter(compiled)
    assert holds_interpreter(plain_search)
    assert holds_interpreter(tasks(SLOPE, WOA=WOA())[0])


def test_state_of_a_search_does_not_reach_the_next_run() -> None:
    first, second, third = tasks(Bowl(), learning=Learning())

    alone = bits(execute(third))

    assert [execute(first).reason, execute(second).reason] == [None, None]
    assert bits(execute(third)) == alone


def test_cost_with_a_state_starts_every_run_from_the_same() -> None:
    class Counting:
        calls = 0

        def __call__(self, x: Vector) -> float:
            self.calls += 1
            return slope(x) + self.calls

    said = {reason(BoxProblem(cost=Counting(), box=[(0, 1)]), WOA=WOA()) for _ in range(2)}

    assert len(said) == 1
    assert "when asked again: the cost draws or keeps a state of its own" in said.pop()


def by_random(cost: Any, bounds: Vector, budget: int, rng: Any) -> Vector:  # noqa: ANN401, ARG001
    return bounds[:, 0] + random.random() * (bounds[:, 1] - bounds[:, 0])  # noqa: S311 (the fault)


def by_numpy(cost: Any, bounds: Vector, budget: int, rng: Any) -> Vector:  # noqa: ANN401, ARG001
    return bounds[:, 0] + np.random.rand() * (bounds[:, 1] - bounds[:, 0])  # noqa: NPY002 (the fault)


@pytest.mark.parametrize(("drawing", "name"), [(by_random, "random"), (by_numpy, "numpy.random")])
def test_draw_from_a_generator_that_all_share_is_a_fault(
    drawing: Callable[..., Vector], name: str
) -> None:
    assert f"drew from the generator of {name}, not from `rng`" in reason(mine=drawing)


def test_swarm_stays_in_the_box_of_a_slope() -> None:
    records = [execute(task) for task in tasks(PSO=PSO(), let_out=PSO(clip="last particle"))]

    assert all(record.x.min() >= 0.001 for record in records[:3])
    assert min(record.cost for record in records[3:]) < 0.003


@dataclass(frozen=True, kw_only=True)
class Odd(Guessing):
    """A search whose result is changed before it is returned."""

    change: Callable[[Result], object]

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Any:  # noqa: ANN401
        """Guess, and return something else."""
        return self.change(Guessing.minimise(self, problem, **budget))


def test_result_of_lists_and_numpy_numbers_is_one_of_vectors_and_numbers() -> None:
    def loose(r: Result) -> Result:
        lists: Any = {"x": r.x.tolist(), "history": list(r.history)}
        return replace(r, cost=np.float64(r.cost), evaluations=np.int64(r.evaluations), **lists)  # type: ignore[arg-type]

    plain, odd = (
        bits(execute(tasks(SLOPE, guess=search)[0])) for search in (Guessing(), Odd(change=loose))
    )

    assert plain == odd


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        ({"cost": None}, "reports the cost None, which is not one number"),
        ({"cost": np.zeros(2)}, "reports the cost array([0., 0.]), which is not one number"),
        ({"evaluations": 2.5}, "reports 2.5 evaluations, which is no whole number"),
        ({"x": None}, "the best point has shape (), not (3,)"),
        ({"x": "here"}, "could not convert string to float"),
        ({"history": [[1.0]]}, "the history has shape (1, 1), not (5,)"),
    ],
)
def test_result_that_is_no_result_is_told_in_one_line(changes: dict[str, Any], fault: str) -> None:
    said = reason(mine=Odd(change=lambda r: replace(r, **changes)))

    assert fault in said
    assert "\n" not in said


@pytest.mark.parametrize(
    ("problem", "fault"),
    [
        (Bowl(centre=("a", "b")), "data must be numbers of shape (k,), not "),  # type: ignore[arg-type]
        (Bowl(centre=()), "bounds must be finite pairs lower <= upper of shape (n, 2), not "),
    ],
)
def test_bounds_and_data_that_cannot_be_are_the_reason_of_the_run(
    problem: Bowl, fault: str
) -> None:
    (task, *_) = tasks(Bowl(), WOA=WOA())

    assert fault in str(execute(replace(task, subject=problem)).reason)
