"""NiaPy: a task counts evaluations; a problem is a class with `_evaluate`."""

from niapy.algorithms.basic import GreyWolfOptimizer
from niapy.problems import Problem
from niapy.task import Task


def wolves(cost, bounds, budget, rng):
    """Run the grey wolf optimiser of NiaPy."""

    class Boxed(Problem):
        def _evaluate(self, x):
            return cost(x)

    task = Task(Boxed(len(bounds), *bounds.T), max_evals=budget)
    return GreyWolfOptimizer(population_size=20, seed=int(rng.integers(2**31))).run(task)
