"""Particle swarm in plain Python, after the PSO.m compared with in the GWO and WOA papers."""

import math
from collections.abc import Callable, Sequence
from typing import Literal


def particle_swarm(
    cost: Callable[[list[float]], float],
    bounds: Sequence[tuple[float, float]],
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    maximum_velocity: float = 6.0,
    inertia: tuple[float, float] = (0.9, 0.2),
    cognitive: float = 2.0,
    social: float = 2.0,
    clip: Literal["last particle", "every particle"] = "every particle",
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    x = _uniform_positions(bounds, population, uniform)
    v = [[0.0] * len(bounds) for _ in range(population)]
    own_x, own_costs = [[0.0] * len(bounds) for _ in range(population)], [math.inf] * population
    best_x, best_cost = [0.0] * len(bounds), math.inf
    history: list[float] = []
    evaluations = 0
    first_clipped = {"last particle": population - 1, "every particle": 0}[clip]
    for t in range(1, iterations + 1):
        for i in range(first_clipped, population):
            x[i] = _clipped(x[i], bounds)
        for i in range(population):
            f = cost(x[i])
            evaluations += 1
            if f < own_costs[i]:
                own_x[i], own_costs[i] = list(x[i]), f
            if f < best_cost:
                best_x, best_cost = list(x[i]), f
        history.append(best_cost)
        w = inertia[0] - t * (inertia[0] - inertia[1]) / iterations
        for i in range(population):
            pulls = (cognitive, own_x[i]), (social, best_x)
            _fly(x[i], v[i], uniform, w=w, pulls=pulls, limit=maximum_velocity)
    return best_x, best_cost, history, evaluations


def _fly(
    x: list[float],
    v: list[float],
    uniform: Callable[[], float],
    *,
    w: float,
    pulls: tuple[tuple[float, list[float]], tuple[float, list[float]]],
    limit: float,
) -> None:
    """Move one particle in place, drawn to its own best and then to the best of all."""
    (cognitive, own_x), (social, best_x) = pulls
    for j in range(len(x)):
        u, u2 = uniform(), uniform()
        to_own = cognitive * u * (own_x[j] - x[j])
        to_best = social * u2 * (best_x[j] - x[j])
        v[j] = w * v[j] + to_own + to_best
        v[j] = min(max(v[j], -limit), limit)
        x[j] += v[j]


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
