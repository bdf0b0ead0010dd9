"""Two searches of one's own in an experiment: a function, and an object."""

from dataclasses import dataclass

import numpy as np

from repro.functions import classical
from repro.model import Experiment
from repro.optimisers import Result


def sample(cost, bounds, budget, rng):
    """Ask for the cost of random points and return the best."""
    points = rng.uniform(bounds[:, 0], bounds[:, 1], size=(budget, len(bounds)))
    return min(points, key=cost)


@dataclass(frozen=True, kw_only=True)
class Sampling:
    """The same as an object, which counts for itself."""

    def minimise(self, problem, *, population, rng, iterations):
        """Return the best of `population` points in each iteration."""
        lower, upper = problem.bounds.T
        points = rng.uniform(lower, upper, size=(iterations, population, len(lower)))
        costs = np.array([[problem.kernel(x, problem.data) for x in some] for some in points])
        best = points.reshape(-1, len(lower))[costs.argmin()]
        history = np.minimum.accumulate(costs.min(axis=1))
        return Result(x=best, cost=costs.min(), history=history, evaluations=costs.size)


EXPERIMENT = Experiment(
    name="benchmark", where="section 4", proposed="function",
    problems={"F16": classical()["F16"]}, algorithms={"function": sample, "object": Sampling()},
    population=10, iterations=5, runs=3,
)  # fmt: skip
