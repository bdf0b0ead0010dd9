"""Grey wolf optimisation in plain Python, after GWO.m of doi:10.1016/j.advengsoft.2013.12.007."""

import math
from collections.abc import Callable, Sequence


def grey_wolf(
    cost: Callable[[list[float]], float],
    bounds: Sequence[tuple[float, float]],
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    x = _uniform_positions(bounds, population, uniform)
    leaders = [[0.0] * len(bounds) for _ in ("alpha", "beta", "delta")]
    costs = [math.inf, math.inf, math.inf]
    history: list[float] = []
    evaluations = 0
    for t in range(iterations):
        for i in range(population):
            x[i] = _clipped(x[i], bounds)
            f = cost(x[i])
            evaluations += 1
            _rank(x[i], f, leaders, costs)
        history.append(costs[0])
        a = 2.0 - 2.0 * t / iterations
        for i in range(population):
            for j in range(len(bounds)):
                x[i][j] = _hunted(x[i][j], [leader[j] for leader in leaders], a, uniform)
    return leaders[0], costs[0], history, evaluations


def _rank(x: list[float], f: float, leaders: list[list[float]], costs: list[float]) -> None:
    """Let a wolf replace a leader; a dethroned alpha is forgotten, as in GWO.m, and so are ties."""
    if f < costs[0]:
        leaders[0], costs[0] = list(x), f
    if f > costs[0] and f < costs[1]:
        leaders[1], costs[1] = list(x), f
    if f > costs[0] and f > costs[1] and f < costs[2]:
        leaders[2], costs[2] = list(x), f


def _hunted(x: float, leaders: list[float], a: float, uniform: Callable[[], float]) -> float:
    """Return one coordinate moved to the mean of its pulls by the three leaders."""
    pulls = []
    for leader in leaders:
        r1, r2 = uniform(), uniform()
        A = 2.0 * a * r1 - a  # Eq. (3.3)
        C = 2.0 * r2  # Eq. (3.4)
        pulls.append(leader - A * abs(C * leader - x))  # Eqs. (3.5), (3.6)
    return (pulls[0] + pulls[1] + pulls[2]) / 3.0  # Eq. (3.7); `sum` rounds differently


def _uniform_positions(
    bounds: Sequence[tuple[float, float]], population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x


def _clipped(x: list[float], bounds: Sequence[tuple[float, float]]) -> list[float]:
    return [min(max(v, lower), upper) for v, (lower, upper) in zip(x, bounds, strict=True)]
