"""A cost that draws noise: by the name of the run alone, anew at every evaluation."""

import multiprocessing
import sys
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np
import pytest

from repro.determinism.compiled import COST, ready
from repro.determinism.draws import state_from
from repro.determinism.noise import ROOM, noise, noise_of_run
from repro.determinism.seeds import generator
from repro.determinism.source_digests import told
from repro.functions import FUNCTIONS
from repro.functions.function import Function
from repro.functions.shifted import ShiftedProblem
from repro.optimisers import DBO, DE, GA, GSA, GWO, PSO, SMA, WOA, RandomSearch
from repro.optimisers.libraries import BASELINES
from repro.optimisers.search import Budget, Problem, Result
from repro.optimisers.users_search import entrant
from repro.runs.plan import Task, plan
from repro.runs.rules import Given
from repro.runs.run import Record, execute, execute_all
from repro.runs.workers.dispatch import run_all
from tests.runs.test_run import same
from tests.small_papers import EXPERIMENT, PAPER

QUARTIC = FUNCTIONS["quartic_noise"].problem(5)
MOVED = ShiftedProblem(problem=QUARTIC, share=0.2)
SEARCHES = {type(s).__name__: s for s in (DBO(), DE(), GA(), GSA(), GWO(), PSO(), SMA(), WOA())}


def tasks(problem: Any = QUARTIC, *, runs: int = 2, **algorithms: Any) -> tuple[Task, ...]:  # noqa: ANN401
    experiment = replace(
        EXPERIMENT, problems={"F7": problem}, algorithms=algorithms or SEARCHES,
        population=24, iterations=10, runs=runs,
    )  # fmt: skip
    return plan([replace(PAPER, experiments=(experiment,), results=(), claims=())], 1)


def draws(count: int, stream: str = "a run") -> np.ndarray[Any, Any]:
    """Return what is added to the cost of one point, many times over."""
    given, cost, origin = Given.of(QUARTIC, stream), ready(QUARTIC.kernel, COST), np.zeros(5)
    return np.array([cost(origin, given.data) for _ in range(count)])


def test_noise_is_uniform_from_0_to_1() -> None:
    found = draws(100_000)
    shares = np.histogram(found, bins=10, range=(0.0, 1.0))[0] / len(found)

    assert 0.0 <= found.min() < 1e-4
    assert 1.0 - 1e-4 < found.max() < 1.0
    assert shares == pytest.approx(np.full(10, 0.1), abs=0.005)  # five standard errors
    assert np.corrcoef(found[1:], found[:-1])[0, 1] == pytest.approx(0.0, abs=0.02)


def test_noise_follows_from_the_name_of_the_run() -> None:
    assert draws(20).tolist() == draws(20).tolist()
    assert not set(draws(20)) & set(draws(20, "another run"))


def test_state_of_the_noise_is_kept_in_numbers_that_doubles_hold_exactly() -> None:
    state = noise_of_run("a run")

    assert state.shape == (ROOM,)
    assert (state == np.floor(state)).all()
    assert ((state >= 0.0) & (state < 2.0**32)).all()


def test_noise_is_drawn_by_another_state_than_the_search() -> None:
    searching = state_from(generator("a run"))

    assert searching[0] >> np.uint64(32) not in noise_of_run("a run").astype(np.uint64)


def test_value_of_the_function_and_cost_of_a_point_are_without_noise() -> None:
    x = np.full(5, 0.5)
    given = Given.of(QUARTIC, "a run")
    before = given.data.copy()

    assert FUNCTIONS["quartic_noise"](x) == given.cost(x) == 15 * 0.5**4
    assert (given.data == before).all()
    assert MOVED(x + MOVED.shift) == pytest.approx(15 * 0.5**4)


@pytest.mark.parametrize("problem", [QUARTIC, MOVED], ids=["plain", "moved"])
def test_every_search_reports_a_cost_with_noise(problem: Any) -> None:  # noqa: ANN401
    records = [execute(task) for task in tasks(problem)]

    assert {record.reason for record in records} == {None}
    for record in records:
        noise = record.cost - Given.of(problem, "").cost(record.x)
        assert 0.0 <= noise < 1.0
        assert record.cost == record.history[-1]
    assert len({record.cost for record in records}) == len(records)


def test_two_runs_meet_other_noise() -> None:
    one, two = (execute(task) for task in tasks(WOA=WOA()))
    drawn = [r.cost - QUARTIC.function(r.x) for r in (one, two)]

    assert drawn[0] != drawn[1]


def test_noise_takes_nothing_from_what_the_search_draws() -> None:
    (task,) = tasks(runs=1, floor=RandomSearch())
    noisy = execute(task)
    budget = {"population": task.population, "iterations": task.iterations}
    still = RandomSearch().minimise(QUARTIC, rng=generator(task.stream), **budget)

    # of the same points, the least has this cost without noise
    assert still.cost == QUARTIC.function(still.x)
    assert still.cost <= QUARTIC.function(noisy.x)
    assert np.all(still.history < noisy.history)


def in_workers(executor: Executor, workers: int, *, seconds: float) -> list[Record]:
    records: list[Record] = []
    with executor:
        run_all(tasks(), executor, workers, records.extend, batch_seconds=seconds)
    return sorted(records, key=lambda record: record.task.name)


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("seconds", [0.0, 10.0], ids=["small batches", "large batches"])
def test_noise_is_the_same_on_any_worker_alone_and_in_a_batch(workers: int, seconds: float) -> None:
    alone = sorted((execute(task) for task in tasks()), key=lambda record: record.task.name)
    spawned = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))

    for records in (
        execute_all(tuple(record.task for record in alone)),
        in_workers(ThreadPoolExecutor(workers), workers, seconds=seconds),
        in_workers(spawned, workers, seconds=seconds),
    ):
        pairs = zip(records, alone, strict=True)
        assert all(same(replace(a, task=b.task), b) for a, b in pairs)


@pytest.mark.parametrize("name", BASELINES)
def test_baselines_meet_noise_too(name: str) -> None:
    first, again = (execute(tasks(search=BASELINES[name])[0]) for _ in range(2))

    assert first.reason is None
    assert 0.0 <= first.cost - QUARTIC.function(first.x) < 1.0
    assert same(replace(again, task=first.task), first)


@dataclass(frozen=True, kw_only=True)
class Telling:
    """A search that reports its cost changed by `more`."""

    more: float

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Search, then say something else."""
        result = DE().minimise(problem, **budget)
        noiseless = QUARTIC.function(result.x)
        return replace(result, cost=noiseless + self.more)


@pytest.mark.parametrize(("more", "fits"), [(-1e-9, False), (0.0, True), (0.9, True), (1.1, False)])
def test_a_reported_cost_lies_between_that_of_the_point_and_1_more(more: float, fits: bool) -> None:  # noqa: FBT001
    reason = execute(tasks(Telling=Telling(more=more))[0]).reason

    assert (reason is None) == fits
    assert fits or str(reason).endswith("and noise from 0 to 1")


SEARCH = """
from repro.optimisers import WOA
from dataclasses import replace
class Protocol:
    def __init__(self, more): self.more = more
    def minimise(self, problem, **budget):
        result = WOA().minimise(problem, **budget)
        return replace(result, cost=result.cost + self.more)
whale, boast, groan = Protocol(0.0), Protocol(-1.0), Protocol(1.0)
def sample(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return min(points, key=cost)
"""


def test_a_users_search_meets_noise_and_may_not_invent_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "noisy_searches.py").write_text(SEARCH)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    found = {
        name: execute(tasks(search=entrant(f"noisy_searches:{name}"))[0])
        for name in ("whale", "sample", "boast", "groan")
    }

    assert found["whale"].reason is found["sample"].reason is None
    for name in ("whale", "sample"):
        assert 0.0 < found[name].cost - QUARTIC.function(found[name].x) < 1.0
    for name in ("boast", "groan"):
        assert "it says that its best point costs" in str(found[name].reason)


def test_no_other_function_depends_on_the_function_with_noise() -> None:
    def modules_of(kernel: Any) -> set[str]:  # noqa: ANN401 (numba ships no types)
        return {name.rpartition(" of ")[2] for name in told(kernel=kernel).parts}

    for function in FUNCTIONS.values():
        noisy = {"repro.functions.noisy", "repro.determinism.noise"} & modules_of(function.kernel)
        assert len(noisy) == (2 if function.noise else 0)


def in_plain_python(x: np.ndarray, data: np.ndarray) -> float:
    return float((x * x).sum() + 0.5 * noise(data))


OWN = Function(
    name="noisy_bowl", title="A bowl with noise", kernel=in_plain_python, box=((-1.0, 1.0),),
    minimum=0.0, at=(0.0,), source="a paper of one's own", noise=0.5, noise_room=ROOM,
)  # fmt: skip


def test_cost_of_ones_own_may_add_noise_that_follows_from_the_name_of_the_run() -> None:
    task = tasks(OWN.problem(2), runs=1, guess=EXPERIMENT.algorithms["guess"])[0]

    first, again = execute(task), execute(task)

    assert isinstance(first, Record)
    assert same(first, again)
    bare = OWN(first.x)
    assert bare < first.cost < bare + 0.5
