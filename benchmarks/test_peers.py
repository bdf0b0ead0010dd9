"""Ours against the packages that a user would otherwise take, on equal evaluations."""

import os
from collections.abc import Iterator
from statistics import median

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.asking import LOCK_OF, Peer, python_of, waiting
from benchmarks.measuring import seconds, timed
from benchmarks.ours import (
    DIMENSION,
    EVALUATIONS,
    ITERATIONS,
    NAMES,
    POPULATION,
    PROBLEMS,
    optimiser,
)
from benchmarks.results import Results, Section

ENOUGH = 2.0  # s; a peer whose first run took longer is not asked again
ROUNDS = 3  # of pairs that goals speak of; others are ratios of hundreds, for which one does
TIMED = ("WOA", "sphere")
OURS_PER_ROUND = 49  # the first after a peer's turn find cold caches; a peer's own lasts seconds
FEW = 50  # iterations of the chart's first point

PEERS = Section(
    title="Against other packages",
    text="Evaluations per second of one run: population 30, dimension 30, 500 iterations, one "
    "core. Ours and the peer take turns on the same core; the ratio is that of the times per "
    "evaluation, since some spend a few more. A peer gets its objective in NumPy over one point "
    "(evosax in JAX over the population, compiled beforehand, in doubles), without counting what "
    "it takes to start. Ours is the whole call of `minimise`.",
    columns=("peer", "algorithm", "function", "peer [1/s]", "ours [1/s]", "ours / peer"),
)
DEFINITIONS = Section(
    title="What the peers really run",
    text="Read from their sources. An algorithm that is missing here is missing there.",
    columns=("peer", "algorithm", "what it is"),
)


@pytest.fixture(scope="module", params=LOCK_OF)
def peer(request: pytest.FixtureRequest, results: Results) -> Iterator[Peer]:
    python = python_of(request.param)
    name = request.param.rstrip("_")
    if python is None:
        results.add(DEFINITIONS, name, "—", "not measured: it is not installed here")
        pytest.skip(f"{name} is not installed")
    with waiting(request.param, python) as found:
        for algorithm, what in found.runs.items():
            label = f"{name} {found.version}, NumPy {found.numpy}"
            results.add(DEFINITIONS, label, algorithm, what)
        yield found


@pytest.fixture(autouse=True)
def _one_core() -> Iterator[None]:
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    yield
    os.sched_setaffinity(0, cores)


def request(
    algorithm: str, function: str, seed: int, iterations: int = ITERATIONS
) -> dict[str, object]:
    low, high = PROBLEMS[function].box[0]
    return {
        "algorithm": algorithm,
        "function": function,
        "lower": low,
        "upper": high,
        "dimension": DIMENSION,
        "population": POPULATION,
        "iterations": iterations,
        "seed": seed,
    }


def our_seconds(algorithm: str, function: str) -> float:
    """Return the seconds per evaluation, a median of some runs."""
    problem, search = PROBLEMS[function].problem(DIMENSION), optimiser(algorithm)
    rng = np.random.default_rng(1)

    def run() -> object:
        return search.minimise(problem, population=POPULATION, iterations=ITERATIONS, rng=rng)

    return median(seconds(run) for _ in range(OURS_PER_ROUND)) / EVALUATIONS


@pytest.mark.parametrize("function", PROBLEMS)
@pytest.mark.parametrize("algorithm", NAMES)
def test_peer(
    benchmark: BenchmarkFixture, results: Results, peer: Peer, algorithm: str, function: str
) -> None:
    if algorithm not in peer.runs:
        pytest.skip(f"{peer.library} has no {algorithm}")
    # few iterations warm up but for what is compiled for a number of iterations
    warm = peer.run(
        **request(algorithm, function, 0, ITERATIONS if "evosax" in peer.library else FEW)
    )
    our_seconds(algorithm, function)
    ours, theirs, costs = [], [], []

    def take_turns() -> None:
        for seed in range(ROUNDS if (algorithm, function) == TIMED else 1):
            ours.append(our_seconds(algorithm, function))
            answer = peer.run(**request(algorithm, function, seed))
            theirs.append(answer.seconds / answer.evaluations)
            costs.append(answer.cost)
            if answer.seconds > ENOUGH:
                break

    timed(benchmark, take_turns)
    assert np.isfinite(costs).all()
    ratio = median(b / a for a, b in zip(ours, theirs, strict=True))
    speeds = f"{1 / median(theirs):,.0f}", f"{1 / median(ours):,.0f}"
    results.add(PEERS, peer.library.rstrip("_"), algorithm, function, *speeds, f"{ratio:,.0f}")
    if (algorithm, function) == TIMED:
        label = f"WOA, {peer.library.rstrip('_')}"
        results.point(label, warm.evaluations, warm.seconds)
        results.point(label, EVALUATIONS, median(theirs) * EVALUATIONS)
