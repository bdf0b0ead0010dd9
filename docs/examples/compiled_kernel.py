"""The cost of a problem, compiled by the decorator that the engine's own costs have."""

import numpy as np

from repro.determinism.compiled import jit
from repro.functions import BoxProblem
from repro.optimisers import GWO


@jit
def weighted(x, data):
    """Return the cost of one point, shape (n,); `data` holds a weight a coordinate."""
    total = 0.0
    for j in range(len(x)):
        total += data[j] * x[j] ** 2
    return total


LOADS = BoxProblem(cost=weighted, box=[(-1, 2), (-1, 2)], numbers=[1.0, 4.0], minimum=0.0)

if __name__ == "__main__":
    rng = np.random.default_rng(1)
    print(GWO().minimise(LOADS, population=20, iterations=50, rng=rng).cost)
