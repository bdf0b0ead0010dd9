"""pymoo: NumPy over the whole population at once, and a framework around it."""

import numpy as np
from pymoo.algorithms.soo.nonconvex.de import DE
from pymoo.algorithms.soo.nonconvex.pso import PSO
from pymoo.core.problem import ElementwiseProblem
from pymoo.optimize import minimize

from benchmarks.peers.task import Task

PACKAGE = "pymoo"
RUNS = {
    "PSO": "PSO(adaptive=False): w 0.9, c 2, speed at most a fifth of the box, best one perturbed",
    "DE": "DE rand/1/bin, F 0.5, CR 0.2, by generations, mutates besides",
}


class _Given(ElementwiseProblem):  # type: ignore[misc,unused-ignore]
    def __init__(self, task: Task) -> None:
        super().__init__(n_var=task.dimension, n_obj=1, xl=task.lower, xu=task.upper)
        self._objective = task.objective

    def _evaluate(self, x: object, out: dict[str, object], *_: object, **__: object) -> None:
        out["F"] = self._objective(x)


def run(task: Task) -> float:
    """Return the best cost of one run."""
    if task.algorithm == "PSO":
        search = PSO(pop_size=task.population, adaptive=False)
    else:
        search = DE(pop_size=task.population, variant="DE/rand/1/bin", F=0.5, CR=0.2)
    found = minimize(_Given(task), search, ("n_gen", task.iterations), seed=task.seed)
    return float(np.ravel(found.F)[0])
