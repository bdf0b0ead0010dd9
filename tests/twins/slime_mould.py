"""Slime mould algorithm in plain Python, after SMA.m of doi:10.1016/j.future.2020.03.055."""

import math
import sys
from collections.abc import Callable, Sequence
from typing import Literal


def slime_mould(
    cost: Callable[[list[float]], float],
    bounds: Sequence[tuple[float, float]],
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    restart: float = 0.03,
    contraction: Literal["drawn", "falling"] = "drawn",
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    x = _uniform_positions(bounds, population, uniform)
    best_x, best_cost = [0.0] * len(bounds), math.inf
    history: list[float] = []
    evaluations = 0
    for it in range(1, iterations + 1):
        x = [_clipped(row, bounds) for row in x]
        costs = [cost(row) for row in x]
        evaluations += population
        order = sorted(range(population), key=costs.__getitem__)
        weights = _weights(costs, order, len(bounds), uniform)
        if costs[order[0]] < best_cost:
            best_x, best_cost = list(x[order[0]]), costs[order[0]]
        a = math.atanh(1.0 - it / iterations)
        b = 1.0 - it / iterations
        for i in range(population):
            if uniform() < restart:
                u = uniform()  # one number: the mould restarts on the diagonal of the box
                x[i] = [lower + (upper - lower) * u for lower, upper in bounds]
            else:
                p = math.tanh(abs(costs[i] - best_cost))
                falls = contraction == "falling"
                _creep(x, i, best_x, weights[i], uniform, p=p, a=a, b=b, falls=falls)
        history.append(best_cost)
    return best_x, best_cost, history, evaluations


def _weights(
    costs: list[float], order: list[int], dimension: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return one weight per mould and dimension, drawn from the best mould to the worst."""
    best, worst = costs[order[0]], costs[order[-1]]
    spread = best - worst + sys.float_info.epsilon
    weights = [[1.0] * dimension for _ in order]
    for rank, i in enumerate(order, start=1):
        # SMA.m takes the logarithm of what may be negative; spreads near eps are the only cause
        argument = 1.0 if spread >= 0.0 else (best - costs[i]) / spread + 1.0
        argument = min(max(argument, 1.0), 2.0)
        sign = 1.0 if rank <= len(order) / 2 else -1.0
        for j in range(dimension):
            weights[i][j] = 1.0 + sign * uniform() * math.log10(argument)
    return weights


def _creep(
    x: list[list[float]],
    i: int,
    best_x: list[float],
    weight: list[float],
    uniform: Callable[[], float],
    *,
    p: float,
    a: float,
    b: float,
    falls: bool,
) -> None:
    """Move mould i in place; moulds after it see it moved and not yet clipped."""
    vb = [-a + 2.0 * a * uniform() for _ in best_x]
    vc = [b if falls else -b + 2.0 * b * uniform() for _ in best_x]
    for j in range(len(best_x)):
        r, u1, u2 = uniform(), uniform(), uniform()
        first, second = x[int(len(x) * u1)], x[int(len(x) * u2)]
        if r < p:
            x[i][j] = best_x[j] + vb[j] * (weight[j] * first[j] - second[j])
        else:
            x[i][j] = vc[j] * x[i][j]


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
