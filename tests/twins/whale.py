"""Whale optimisation in plain Python, after WOA.m of doi:10.1016/j.advengsoft.2016.01.008."""

import math
from collections.abc import Callable, Sequence

from tests.twins.waves import cosine_of_turns


def whale(
    cost: Callable[[list[float]], float],
    bounds: Sequence[tuple[float, float]],
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    b: float = 1.0,
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    x = _uniform_positions(bounds, population, uniform)
    best_x, best_cost = [0.0] * len(bounds), math.inf
    history: list[float] = []
    evaluations = 0
    for t in range(iterations):
        for i in range(population):
            x[i] = _clipped(x[i], bounds)
            f = cost(x[i])
            evaluations += 1
            if f < best_cost:
                best_x, best_cost = list(x[i]), f
        history.append(best_cost)
        a = 2.0 - 2.0 * t / iterations
        a2 = -1.0 - t / iterations
        for i in range(population):
            _move(x, i, best_x, uniform, a=a, a2=a2, b=b)
    return best_x, best_cost, history, evaluations


def _move(
    x: list[list[float]],
    i: int,
    best_x: list[float],
    uniform: Callable[[], float],
    *,
    a: float,
    a2: float,
    b: float,
) -> None:
    """Move whale i in place; whales after it see it moved and not yet clipped."""
    r1, r2, u, p = uniform(), uniform(), uniform(), uniform()
    A = 2.0 * a * r1 - a  # Eq. (2.3)
    C = 2.0 * r2  # Eq. (2.4)
    l = (a2 - 1.0) * u + 1.0  # noqa: E741 -- WOA.m; the paper has l in [-1, 1]
    turn = math.exp(b * l) * cosine_of_turns(l)
    for j in range(len(best_x)):
        if p >= 0.5:
            x[i][j] = abs(best_x[j] - x[i][j]) * turn + best_x[j]  # Eq. (2.5)
        elif abs(A) >= 1.0:
            k = int(len(x) * uniform())  # WOA.m: another whale in every dimension
            x[i][j] = x[k][j] - A * abs(C * x[k][j] - x[i][j])  # Eqs. (2.7), (2.8)
        else:
            x[i][j] = best_x[j] - A * abs(C * best_x[j] - x[i][j])  # Eqs. (2.1), (2.2)


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
