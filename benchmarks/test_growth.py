"""How a run grows with population, dimension, iterations and runs; the exponent should be 1."""

from collections.abc import Callable
from functools import partial
from statistics import median

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.in_c import compiler, in_c
from benchmarks.measuring import in_turns
from benchmarks.ours import DIMENSION, ITERATIONS, PROBLEMS, kernel, optimiser, state
from benchmarks.ours import POPULATION as AGENTS
from benchmarks.results import Results, Section

FACTORS = (1, 2, 4, 8)
ROUNDS = 15
GROWTH = Section(
    title="Growth",
    text=f"Exponent of the time of PSO on Rastrigin, a straight line fitted to the logarithms of "
    f"{', '.join(map(str, FACTORS))} times population 30, dimension 30, 500 iterations, one run.",
    columns=("grows", "from [ms]", "to [ms]", "exponent"),
)


def runs(population: int, dimension: int, iterations: int, count: int) -> Callable[[], None]:
    problem, swarm = PROBLEMS["rastrigin"].problem(dimension), optimiser("PSO")
    rng = np.random.default_rng(1)

    def call() -> None:
        for _ in range(count):
            swarm.minimise(problem, population=population, iterations=iterations, rng=rng)

    return call


@pytest.mark.parametrize("what", ["population", "dimension", "iterations", "runs"])
def test_time_grows_with(benchmark: BenchmarkFixture, results: Results, what: str) -> None:
    index = ("population", "dimension", "iterations", "runs").index(what)
    sizes = [AGENTS, DIMENSION, ITERATIONS, 1]
    calls = {}
    for factor in FACTORS:
        sizes_now = [size * (factor if i == index else 1) for i, size in enumerate(sizes)]
        calls[str(factor)] = runs(*sizes_now)
    taken = in_turns(benchmark, calls, rounds=ROUNDS)
    times = [median(taken[str(factor)]) for factor in FACTORS]
    exponent, _ = np.polyfit(np.log(FACTORS), np.log(times), 1)
    ends = (f"{1000 * times[0]:.2f}", f"{1000 * times[-1]:.2f}")
    results.add(GROWTH, what, *ends, f"{exponent:.2f}")


@pytest.mark.skipif(compiler() is None, reason="there is no C compiler (cc)")
@pytest.mark.parametrize("search", ["woa", "pso", "de"])
def test_points_of_the_chart(benchmark: BenchmarkFixture, results: Results, search: str) -> None:
    iterations = [50 * factor for factor in (1, 10, 100)]
    random = state(1)
    calls = {}
    for count in iterations:
        calls[f"ours {count}"] = partial(kernel(search, "sphere", count), random)
        calls[f"C {count}"] = partial(in_c("exact", search, "sphere", count), random)
    taken = in_turns(benchmark, calls, rounds=5)
    for count in iterations:
        work = AGENTS * count
        results.point(f"{search.upper()}, ours", work, median(taken[f"ours {count}"]))
        if search == "woa":
            results.point("WOA, C -O3", work, median(taken[f"C {count}"]))
