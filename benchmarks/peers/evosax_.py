"""evosax: JAX; the whole run is one compiled program, in doubles, over the population at once."""

from collections.abc import Callable
from functools import cache
from typing import Any

import jax
import jax.numpy as jnp
from evosax.algorithms import PSO, DifferentialEvolution

from benchmarks.peers.objectives import objectives
from benchmarks.peers.task import Task

jax.config.update("jax_enable_x64", True)  # noqa: FBT003 (its own way)

PACKAGE = "evosax"
RUNS = {
    "PSO": "w 0.75, c 1.5 and 2, one draw per particle, no limit of velocity, no clipping",
    "DE": "DifferentialEvolution: best/1/bin, F 0.8, CR 0.9, by generations, no clipping",
}
_SEARCHES = {"PSO": PSO, "DE": DifferentialEvolution}


@cache
def _compiled(
    algorithm: str, function: str, lower: float, upper: float, size: tuple[int, int, int]
) -> Callable[[Any], Any]:
    dimension, population, iterations = size
    costs = jax.vmap(objectives(jnp)[function])
    search = _SEARCHES[algorithm](population_size=population, solution=jnp.zeros(dimension))
    parameters = search.default_params

    def step(carry: Any, key: Any) -> tuple[Any, None]:  # noqa: ANN401
        asked, told = jax.random.split(key)
        points, carry = search.ask(asked, carry, parameters)
        carry, _ = search.tell(told, points, costs(points), carry, parameters)
        return carry, None

    def whole(key: Any) -> Any:  # noqa: ANN401
        first, start, rest = jax.random.split(key, 3)
        points = jax.random.uniform(first, (population, dimension), minval=lower, maxval=upper)
        state = search.init(start, points, costs(points), parameters)
        state, _ = jax.lax.scan(step, state, jax.random.split(rest, iterations))
        return state.best_fitness

    compiled: Callable[[Any], Any] = jax.jit(whole)
    return compiled


def evaluations(task: Task) -> int:
    """Return how many evaluations a run makes: the first population's and one per iteration."""
    return task.population * (task.iterations + 1)


def run(task: Task) -> float:
    """Return the best cost of one run; the first one compiles."""
    size = (task.dimension, task.population, task.iterations)
    whole = _compiled(task.algorithm, task.function, task.lower, task.upper, size)
    return float(whole(jax.random.key(task.seed)).block_until_ready())
