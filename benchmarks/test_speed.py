"""How long runs take: the compiled whales beside the same loop in C, and every algorithm.

`pytest benchmarks --benchmark-json=FILE` also writes the ratio of numba to C, as extra_info.
"""

import ctypes
import dataclasses
import shutil
import statistics
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numpy as np
import pytest
from numpy.typing import NDArray
from pytest_benchmark.fixture import BenchmarkFixture

from repro import optimisers
from repro.compiled import COST, SEARCH, ready
from repro.draws import state_from
from repro.functions import FUNCTIONS
from repro.optimisers import WOA, Optimiser
from repro.optimisers.whale import _woa

SPHERE = FUNCTIONS["sphere"]
DIMENSION, POPULATION, ITERATIONS = 30, 30, 500  # as in the papers' tables of benchmark functions
RUNS = 300  # enough for the medians of two programs to agree to a percent between calls

Run = Callable[[NDArray[np.uint64]], tuple[float, list[float]]]
"""One run of WOA: random state, which it moves on, to best cost and history."""

Outcome = TypeVar("Outcome")

ALGORITHMS = [
    value
    for value in vars(optimisers).values()
    if dataclasses.is_dataclass(value) and hasattr(value, "minimise")
]


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    gcc = shutil.which("gcc")
    if gcc is None:
        pytest.skip("there is no gcc to compile benchmarks/whale.c")
    target = tmp_path_factory.mktemp("c") / "whale.so"
    source = Path(__file__).with_name("whale.c")
    # plain x86-64 has no fused multiply-add; elsewhere gcc would use one and round differently
    options = ["-O3", "-ffp-contract=off", "-shared", "-fPIC"]
    subprocess.run([gcc, *options, "-o", str(target), str(source), "-lm"], check=True)
    return ctypes.CDLL(str(target))


def run_in_c(library: ctypes.CDLL, name: str) -> Run:
    whales = library[name]
    whales.restype = ctypes.c_double
    array, count = ctypes.c_void_p, ctypes.c_int64
    whales.argtypes = [array, count, count, count, ctypes.c_double, array, array, array]
    bounds = SPHERE.problem(DIMENSION).bounds
    best, history = np.empty(DIMENSION), np.empty(ITERATIONS)

    def run(state: NDArray[np.uint64]) -> tuple[float, list[float]]:
        cost = whales(
            bounds.ctypes.data,
            DIMENSION,
            POPULATION,
            ITERATIONS,
            WOA().b,
            state.ctypes.data,
            best.ctypes.data,
            history.ctypes.data,
        )
        return cost, history.tolist()

    return run


def run_compiled() -> Run:
    kernel, cost = ready(_woa, SEARCH), ready(SPHERE.kernel, COST)
    problem = SPHERE.problem(DIMENSION)
    bounds, parameters = problem.bounds, np.array([WOA().b])

    def run(state: NDArray[np.uint64]) -> tuple[float, list[float]]:
        _, best_cost, history, _ = kernel(
            cost, problem.data, bounds, POPULATION, ITERATIONS, parameters, state
        )
        return best_cost, history.tolist()

    return run


def measured(benchmark: BenchmarkFixture, call: Callable[[], Outcome], *, rounds: int) -> Outcome:
    """Time `call`, once untimed and then `rounds` times, and return what the last one returned."""
    outcome: Outcome = benchmark.pedantic(  # type: ignore[no-untyped-call]
        call, rounds=rounds, warmup_rounds=1
    )
    return outcome


def seconds(run: Run, state: NDArray[np.uint64]) -> float:
    start = time.perf_counter()
    run(state)
    return time.perf_counter() - start


def median_ratio(ours: Run, theirs: Run) -> float:
    """Return the median of our time over theirs; they take turns and draw the same numbers."""
    states = [state_from(np.random.default_rng(1)) for _ in range(2)]
    return statistics.median(
        seconds(ours, states[0]) / seconds(theirs, states[1]) for _ in range(RUNS)
    )


@pytest.mark.benchmark(group="WOA, 30 whales, 500 iterations, sphere of dimension 30")
@pytest.mark.parametrize("name", ["woa_by_pointer", "woa_inlined"])
def test_whales_in_c_end_where_the_compiled_whales_do(
    benchmark: BenchmarkFixture, library: ctypes.CDLL, name: str
) -> None:
    ours, theirs = run_compiled(), run_in_c(library, name)
    for seed in range(10):
        states = [state_from(np.random.default_rng(seed)) for _ in range(2)]
        # the same operations in the same order on the same mathematical library: not a bit apart
        assert ours(states[0]) == theirs(states[1])
        assert states[0].tolist() == states[1].tolist()
    benchmark.extra_info["numba / C"] = median_ratio(ours, theirs)
    state = state_from(np.random.default_rng(1))
    measured(benchmark, lambda: theirs(state), rounds=RUNS)


@pytest.mark.benchmark(group="WOA, 30 whales, 500 iterations, sphere of dimension 30")
def test_compiled_whales_draw_anew_in_every_run(benchmark: BenchmarkFixture) -> None:
    run = run_compiled()
    state = state_from(np.random.default_rng(1))
    first, _ = run(state.copy())
    last, _ = measured(benchmark, lambda: run(state), rounds=RUNS)
    assert first != last


@pytest.mark.benchmark(group="50 agents, 500 iterations, sphere of dimension 40")
@pytest.mark.parametrize("algorithm", ALGORITHMS, ids=lambda algorithm: algorithm.__name__)
def test_algorithm_ends_with_the_last_cost_of_its_history(
    benchmark: BenchmarkFixture, algorithm: type[Optimiser]
) -> None:
    problem = SPHERE.problem(40)
    rng = np.random.default_rng(1)
    result = measured(
        benchmark,
        lambda: algorithm().minimise(problem, population=50, iterations=500, rng=rng),
        rounds=20,
    )
    assert len(result.history) == 500
    assert result.cost == result.history[-1]


@pytest.mark.benchmark(group="one evaluation: what a call costs besides the search")
def test_smallest_run_spends_one_evaluation(benchmark: BenchmarkFixture) -> None:
    problem = SPHERE.problem(1)
    rng = np.random.default_rng(1)
    result = measured(
        benchmark,
        lambda: WOA().minimise(problem, population=1, iterations=1, rng=rng),
        rounds=1000,
    )
    assert result.evaluations == 1
