"""NiaPy: NumPy over the coordinates of one agent at a time."""

from niapy.algorithms.basic import (
    DifferentialEvolution,
    GreyWolfOptimizer,
    ParticleSwarmAlgorithm,
)
from niapy.problems import Problem
from niapy.task import Task as Search

from benchmarks.peers.task import Task

PACKAGE = "niapy"
RUNS = {
    "GWO": "GreyWolfOptimizer: leaders of the whole history, without cascade",
    "PSO": "ParticleSwarmAlgorithm: w 0.7, c 2, speed at most 1.5, moves at once",
    "DE": "DifferentialEvolution: rand/1/bin, F 1, CR 0.8, by generations",
}
_SEARCHES = {
    "GWO": GreyWolfOptimizer,
    "PSO": ParticleSwarmAlgorithm,
    "DE": DifferentialEvolution,
}


class _Given(Problem):  # type: ignore[misc,unused-ignore]
    def __init__(self, task: Task) -> None:
        super().__init__(dimension=task.dimension, lower=task.lower, upper=task.upper)
        self._objective = task.objective

    def _evaluate(self, x: object) -> object:
        return self._objective(x)


def run(task: Task) -> float:
    """Return the best cost of one run."""
    # it counts the first population as evaluations of the budget
    budget = task.population * task.iterations
    search = _SEARCHES[task.algorithm](population_size=task.population, seed=task.seed)
    _, best = search.run(Search(problem=_Given(task), max_evals=budget))
    return float(best)
