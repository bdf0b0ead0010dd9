"""Runs of our own algorithms, called as the engine calls them, on a state that can be compared."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro import optimisers
from repro.determinism.compiled import COST, SEARCH, ready
from repro.determinism.draws import state_from
from repro.functions import FUNCTIONS
from repro.optimisers import Optimiser, differential_evolution, particle_swarm, whale

# as in the papers' tables of benchmark functions
POPULATION, DIMENSION, ITERATIONS = 30, 30, 500
EVALUATIONS = POPULATION * ITERATIONS
NAMES = ("WOA", "GWO", "PSO", "DE", "SMA")
PROBLEMS = {name: FUNCTIONS[name] for name in ("sphere", "rastrigin", "ackley", "penalized_1")}

State = NDArray[np.uint64]
Outcome = tuple[float, list[float]]
"""Best cost and history of one run."""

KERNELS: dict[str, tuple[Any, tuple[float, ...]]] = {
    "woa": (whale._woa, (1.0,)),
    "pso": (particle_swarm._pso, (6.0, 0.9, 0.2, 2.0, 2.0, 0.0)),
    "de": (differential_evolution._de, (0.2, 0.8, 0.2)),
}
"""Compiled search and the parameters that its dataclass passes on by default."""


def state(seed: int) -> State:
    """Return the random state of that seed."""
    return state_from(np.random.default_rng(seed))


def optimiser(name: str) -> Optimiser:
    """Return an algorithm with its default parameters."""
    found: Optimiser = getattr(optimisers, name)()
    return found


def kernel(search: str, function: str, iterations: int = ITERATIONS) -> Callable[[State], Outcome]:
    """Return one run of a compiled search: random state, which it moves on, to outcome."""
    compiled, parameters = KERNELS[search]
    compiled, cost = ready(compiled, SEARCH), ready(PROBLEMS[function].kernel, COST)
    problem, constants = PROBLEMS[function].problem(DIMENSION), np.array(parameters)
    bounds, data = problem.bounds, problem.data

    def run(state: State) -> Outcome:
        found = compiled(cost, data, bounds, POPULATION, iterations, constants, state)
        return found[1], found[2].tolist()

    return run
