"""Random search in NumPy: a whole matrix of uniform points, then its running minimum."""

from collections.abc import Callable, Sequence

import numpy as np


def random_search(
    cost: Callable[[list[float]], float],
    bounds: Sequence[tuple[float, float]],
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    lower, upper = np.array(bounds).T
    n = population * iterations
    share = np.array([uniform() for _ in range(n * len(bounds))]).reshape(n, -1)
    points = lower + (upper - lower) * share
    costs = np.array([cost(point.tolist()) for point in points])
    history = np.minimum.accumulate(costs)[population - 1 :: population]
    return points[costs.argmin()].tolist(), float(costs.min()), history.tolist(), n
