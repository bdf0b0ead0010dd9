"""A cost in plain Python, minimised by a compiled search."""

import numpy as np

from repro.functions import BoxProblem
from repro.optimisers import WOA


def energy(x):
    """Return the cost of one point, shape (3,)."""
    return float(np.sum((x - 0.5) ** 2) + 0.1 * np.prod(np.abs(x)))


def weighted(x, data):
    """Return a cost that needs numbers besides the point."""
    return float(data @ x**2)


BOWL = BoxProblem(cost=energy, box=[(-1, 2)] * 3)
LOADS = BoxProblem(cost=weighted, box=[(-1, 2), (-1, 2)], numbers=[1.0, 4.0], minimum=0.0)

if __name__ == "__main__":
    for problem in (BOWL, LOADS):
        rng = np.random.default_rng(1)
        print(WOA().minimise(problem, population=20, iterations=50, rng=rng).cost)
