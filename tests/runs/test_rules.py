"""Objectives and searches that misbehave: named, recorded, and costing no other run."""

import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Any, Unpack

import numpy as np
import pytest

from repro import optimisers
from repro.determinism.compiled import jit
from repro.functions import FUNCTIONS
from repro.functions.shifted import ShiftedProblem
from repro.optimisers import DBO, DE, GA, GSA, WOA, SteadyStateGA
from repro.optimisers.gravitational import _masses
from repro.optimisers.search import Budget, Problem, Result, Spending
from repro.runs.plan import plan
from repro.runs.rules import Given
from repro.runs.run import Record, execute
from repro.runs.workers.dispatch import run_all
from tests.runs.test_run import same
from tests.small_papers import EXPERIMENT, PAPER, Bowl, Guessing, Vector, searching
from tests.small_problems import small

Change = Callable[[Result, Problem], Result]


@dataclass(frozen=True, kw_only=True)
class Rogue(Guessing):
    """A search whose result is tampered with."""

    tamper: Change

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Search, then tamper."""
        return self.tamper(super().minimise(problem, **budget), problem)


@dataclass(frozen=True, kw_only=True)
class Odd(Bowl):
    """A bowl with another cost."""

    value: Callable[[], float]

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (as in the protocol)
        """The cost."""
        return lambda _x, _data: self.value()


def spoil_bounds(result: Result, problem: Problem) -> Result:
    problem.bounds[0, 0] = -9.0
    return result


def spoil_data(result: Result, problem: Problem) -> Result:
    problem.data[0] = 9.0
    return result


def stop(*_: object) -> Any:  # noqa: ANN401
    raise SystemExit(7)


def nothing(*_: object) -> Any:  # noqa: ANN401
    return None


ROGUES: dict[str, tuple[Change, str]] = {
    "outside": (lambda r, _: replace(r, x=np.array([0.0, 1.5])), "the search left the box: coordi"),
    "nowhere": (
        lambda r, _: replace(r, x=np.array([np.nan, 0.0])),
        "coordinate 1 is nan, not -1.0",
    ),
    "shape": (lambda r, _: replace(r, x=np.zeros(3)), "the best point has shape (3,), not (2,)"),
    "history": (lambda r, _: replace(r, history=np.zeros(3)), "history has shape (3,), not (5,)"),
    "greedy": (lambda r, _: replace(r, evaluations=25), "spent 25 evaluations of at most 24"),
    "idle": (lambda r, _: replace(r, evaluations=0), "spent 0 evaluations of at most 24"),
    "liar": (lambda r, _: replace(r, cost=r.cost / 2), "the search reports the cost 0."),
    "bounds": (spoil_bounds, "changed the bounds or data that it was given"),
    "data": (spoil_data, "changed the bounds or data that it was given"),
    "exit": (stop, "SystemExit: 7"),
    "none": (nothing, "AttributeError: 'NoneType' object has no attribute 'cost'"),
    "text": (lambda r, _: replace(r, cost="low"), "TypeError: "),  # type: ignore[arg-type]
    "endless": (lambda r, _: replace(r, cost=math.inf), "the best cost is inf"),
}


def raising() -> float:
    message = "the model broke down"
    raise ArithmeticError(message)


OBJECTIVES: dict[str, tuple[Callable[[], float], str]] = {
    "nan": (lambda: math.nan, "the best cost is nan at x = ["),
    "infinity": (lambda: math.inf, "the best cost is inf"),
    "minus infinity": (lambda: -math.inf, "the best cost is -inf"),
    "raises": (raising, "ArithmeticError: the model broke down"),
    "unsteady": (iter(range(10**6)).__next__, "the search reports the cost "),
}


def ran(problem: Problem, **algorithms: Any) -> dict[str, list[Record]]:  # noqa: ANN401
    """Return the records of each algorithm on a problem."""
    experiment = replace(
        EXPERIMENT, problems={"p": problem}, algorithms=algorithms, proposed=next(iter(algorithms))
    )
    tasks = plan([replace(PAPER, experiments=(experiment,), results=(), claims=())], 1)
    records: list[Record] = []
    with ThreadPoolExecutor(2) as executor:
        run_all(tasks, executor, 2, records.extend)
    return {
        name: [record for record in records if record.task.algorithm == name] for name in algorithms
    }


@pytest.mark.parametrize("kind", ROGUES)
def test_rogue_search_is_named_and_costs_no_other_run(kind: str) -> None:
    tamper, reason = ROGUES[kind]

    records = ran(Bowl(), rogue=Rogue(tamper=tamper), good=Guessing())

    assert all(reason in str(record.reason) for record in records["rogue"])
    alone = [execute(record.task) for record in records["good"]]
    assert all(map(same, records["good"], alone))
    assert [record.reason for record in records["good"]] == [None] * 3


@pytest.mark.parametrize("kind", OBJECTIVES)
def test_odd_objective_is_named_as_the_outcome_of_its_runs(kind: str) -> None:
    value, reason = OBJECTIVES[kind]

    records = ran(Odd(value=value), guess=Guessing())["guess"]

    assert all(str(record.reason).startswith(reason) for record in records)
    assert all(math.isnan(record.cost) and record.x.size == 0 for record in records)


def test_objective_that_never_improves_is_a_run_with_a_flat_curve() -> None:
    records = ran(Odd(value=lambda: 3.0), guess=Guessing())["guess"]

    assert [(record.reason, record.history.tolist()) for record in records] == [
        (None, [3.0] * 5)
    ] * 3


def test_objective_that_changes_its_data_is_named() -> None:
    records = ran(small("rosenbrock"), WOA=WOA())["WOA"]

    assert all("changed the bounds or data" in str(record.reason) for record in records)


def test_search_may_leave_the_box_or_spend_more_where_it_says_so() -> None:
    @dataclass(frozen=True, kw_only=True)
    class Twice(Rogue):
        def spending(self, population: int) -> Spending:
            return Spending(start=1, each=2 * population)

    wide = Rogue(width=4.0, tamper=lambda r, _: r)
    twice = Twice(tamper=lambda r, _: replace(r, evaluations=41))
    more = Twice(tamper=lambda r, _: replace(r, evaluations=42))

    records = ran(Bowl(), wide=wide, twice=twice, more=more)

    assert [record.reason for record in (*records["wide"], *records["twice"])] == [None] * 6
    assert all("42 evaluations of at most 41" in str(record.reason) for record in records["more"])


@pytest.mark.parametrize("name", [name for name in optimisers.__all__ if name[0].isupper()])
def test_every_algorithm_keeps_the_rules(name: str) -> None:
    kind = getattr(optimisers, name)
    if not hasattr(kind, "minimise") or getattr(kind, "_is_protocol", False):
        return
    experiment = replace(EXPERIMENT, population=30, algorithms={name: kind()}, proposed=name)
    for function in ("rosenbrock", "foxholes"):
        problem = FUNCTIONS[function].problem(2)
        made = replace(experiment, problems={"p": problem})
        for task in plan([replace(PAPER, experiments=(made,), results=(), claims=())], 1):
            assert execute(task).reason is None


def _never(x: Vector, data: Vector) -> float:  # noqa: ARG001
    return math.nan


@dataclass(frozen=True, kw_only=True)
class Compiled(Bowl):
    """A bowl with a compiled cost."""

    kernel: Any = None


NEVER = Compiled(kernel=jit(_never))


@pytest.mark.parametrize("algorithm", [DBO(), DE(), GA(), GSA(), SteadyStateGA(), WOA()], ids=repr)
def test_compiled_search_without_a_finite_cost_fails_by_name(algorithm: Any) -> None:  # noqa: ANN401
    result = searching()
    experiment = replace(
        result.experiments[0], problems={"p": NEVER}, algorithms={"a": algorithm}, population=24
    )
    for task in plan([replace(result, experiments=(experiment,))], 1):
        assert str(execute(task).reason).startswith(
            ("the best cost is nan at x", "the best cost is inf")
        )


@pytest.mark.parametrize(
    ("costs", "masses"),
    [
        ([1.0, 2.0, 3.0], [2 / 3, 1 / 3, 0.0]),
        ([1.0, 2.0, 3.0, math.inf, math.nan], [2 / 3, 1 / 3, 0.0, 0.0, 0.0]),
        ([math.inf, 5.0], [0.0, 1.0]),
        ([math.nan, math.inf], [0.0, 0.0]),
    ],
)
def test_agents_without_a_finite_cost_have_no_mass(costs: list[float], masses: list[float]) -> None:
    assert _masses(np.array(costs)).tolist() == pytest.approx(masses)


def test_bounds_and_data_of_one_run_are_its_own() -> None:
    problem = small("rosenbrock")
    given = Given.of(problem, "a run")
    given.data[0] = 5.0

    assert problem.data[0] == 0.0
    assert given.identity == problem.identity
    assert given.cost(np.ones(3)) == problem.cost([1.0, 1.0, 1.0])


@pytest.mark.parametrize("name", ["sphere", "rastrigin"])
def test_cost_may_write_where_its_problem_says_so(name: str) -> None:
    shifted = ShiftedProblem(problem=FUNCTIONS[name].problem(3), share=0.2)
    task = replace(plan([PAPER], 1)[0], optimiser=WOA(), subject=shifted)

    assert execute(task).reason is None
    given = Given.of(shifted, "a run")
    given.data[: shifted.scratch] += 1.0
    assert given.is_as_it_was
    given.data[shifted.scratch] += 1.0
    assert not given.is_as_it_was
