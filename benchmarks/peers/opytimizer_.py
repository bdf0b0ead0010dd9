"""Opytimizer: one object per agent, NumPy over its coordinates, copies made in depth."""

import importlib
import logging

import numpy as np
from opytimizer import Opytimizer
from opytimizer.core import Function
from opytimizer.core.stopping import MaxIterations
from opytimizer.spaces import SearchSpace

from benchmarks.peers.task import Task

PACKAGE = "opytimizer"
RUNS = {
    "WOA": "A and C share one draw, l from N(0, 1), X_rand a fresh point of the box",
    "GWO": "one A and C per wolf and leader, leaders from the present pack, greedy",
    "PSO": "w 0.7, c 1.7, one draw per particle, no limit of velocity",
    "DE": "rand/1/bin, F 0.7, CR 0.9, in place",
    "SMA": "one v_b, v_c and pair of moulds per mould; weight on their difference",
}
_FOLDERS = {"WOA": "swarm", "PSO": "swarm", "GWO": "population", "DE": "evolutionary"}
_ROOT = "opytimizer.optimizers.single_objective"


def run(task: Task) -> float:
    """Return the best cost of one run."""
    logging.disable(logging.CRITICAL)
    np.random.seed(task.seed)  # noqa: NPY002 (the library draws from the global generator)
    folder = _FOLDERS.get(task.algorithm, "science")
    module = importlib.import_module(f"{_ROOT}.{folder}.{task.algorithm.lower()}")
    space = SearchSpace(
        task.population,
        task.dimension,
        1,
        [task.lower] * task.dimension,
        [task.upper] * task.dimension,
    )
    objective = Function(lambda x: task.objective(x[:, 0]))
    search = Opytimizer(space, getattr(module, task.algorithm)(), objective)
    search.start(stopping_criteria=MaxIterations(task.iterations))
    return float(np.ravel(search.space.best_agent.fit)[0])
