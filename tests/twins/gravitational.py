"""Gravitational search in plain Python, after GSA.m of doi:10.1016/j.ins.2009.03.004."""

import math
import sys
from collections.abc import Callable, Sequence

from tests.twins.box import Rule, brought_back

Bounds = Sequence[tuple[float, float]]


def gravitational(
    cost: Callable[[list[float]], float],
    box: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    strength: float = 100.0,
    decay: float = 20.0,
    final_percent: float = 2.0,
    bounds: Rule = "re-initialise",
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    x = _uniform_positions(box, population, uniform)
    v = [[0.0] * len(box) for _ in range(population)]
    best_x, best_cost = [0.0] * len(box), math.inf
    history: list[float] = []
    evaluations = 0
    for t in range(1, iterations + 1):
        x = [brought_back(row, box, bounds, uniform) for row in x]
        costs = [cost(row) for row in x]
        evaluations += population
        for row, f in zip(x, costs, strict=True):
            if f < best_cost:
                best_x, best_cost = list(row), f
        history.append(best_cost)
        G = strength * math.exp(-decay * t / iterations)
        percent = final_percent + (1.0 - t / iterations) * (100.0 - final_percent)
        kept = int(population * percent / 100.0 + 0.5)
        masses = _masses(costs)
        heaviest = sorted(range(population), key=lambda j: -masses[j])[:kept]
        pulls = [_pull(x, i, masses, heaviest, uniform) for i in range(population)]
        for i in range(population):
            for j in range(len(box)):
                v[i][j] = uniform() * v[i][j] + G * pulls[i][j]
                x[i][j] += v[i][j]
    return best_x, best_cost, history, evaluations


def _masses(costs: list[float]) -> list[float]:
    """Return masses that add up to 1; the worst agent has none, and equals have equal ones."""
    best, worst = min(costs), max(costs)
    m = [1.0 if best == worst else (f - worst) / (best - worst) for f in costs]
    total = 0.0
    for mass in m:  # `sum` rounds differently
        total += mass
    return [mass / total for mass in m]


def _pull(
    x: list[list[float]],
    i: int,
    masses: list[float],
    heaviest: list[int],
    uniform: Callable[[], float],
) -> list[float]:
    """Return the acceleration of agent i without G; the distance has power 1, not 2."""
    pull = [0.0] * len(x[i])
    for k in heaviest:
        if k == i:
            continue
        squares = 0.0
        for own, other in zip(x[i], x[k], strict=True):
            squares += (own - other) * (own - other)
        R = math.sqrt(squares)
        for j in range(len(pull)):
            u = uniform()
            pull[j] += u * masses[k] * (x[k][j] - x[i][j]) / (R + sys.float_info.epsilon)
    return pull


def _uniform_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x
