"""Random search: points drawn uniformly from the box, the floor under every other search.

S. H. Brooks, A discussion of random methods for seeking maxima, Operations Research 6(2) (1958)
244-251, doi:10.1287/opre.6.2.244, the simple random method.
"""

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import uniform
from repro.optimisers.population import copy_into
from repro.optimisers.search import Budget, Problem, Result, search


@jit
def _random(cost, data, bounds, population, iterations, parameters, state):  # noqa: ARG001 (every search is called alike)
    n = bounds.shape[0]
    x = np.empty(n)
    best = bounds[:, 0].copy()
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(iterations):
        for _ in range(population):
            for j in range(n):
                width = bounds[j, 1] - bounds[j, 0]
                x[j] = min(bounds[j, 0] + width * uniform(state), bounds[j, 1])
            value = cost(x, data)
            if value < best_cost:
                best_cost = value
                copy_into(best, x)
        history[t] = best_cost
    return best, best_cost, history, population * iterations


@dataclass(frozen=True, slots=True, kw_only=True)
class RandomSearch:
    """Random search; it has no parameters."""

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best of N·T points; see `Optimiser`."""
        return search(_random, problem, **budget)
