"""Differential evolution in plain Python, after DE.m as comparisons pass it round (YPEA107)."""

from collections.abc import Callable, Sequence

Bounds = Sequence[tuple[float, float]]


def differential_evolution(
    cost: Callable[[list[float]], float],
    bounds: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    scale: tuple[float, float] = (0.2, 0.8),
    crossover: float = 0.2,
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T + N)."""
    del normal  # all twins are called alike
    x = _uniform_positions(bounds, population, uniform)
    costs = [cost(row) for row in x]
    evaluations = population
    best_cost = min(costs)
    best_x = list(x[costs.index(best_cost)])
    history: list[float] = []
    for _ in range(iterations):
        for i in range(population):
            mutant = _clipped(_mutant(x, i, scale, uniform), bounds)
            trial = _mixed(x[i], mutant, crossover, uniform)
            f = cost(trial)
            evaluations += 1
            if f < costs[i]:
                x[i], costs[i] = trial, f  # the agents after it see it already
                if f < best_cost:
                    best_x, best_cost = list(trial), f
        history.append(best_cost)
    return best_x, best_cost, history, evaluations


def _mutant(
    x: list[list[float]], i: int, scale: tuple[float, float], uniform: Callable[[], float]
) -> list[float]:
    """Return one agent plus a scaled difference of two others, none of them agent i."""
    chosen = [i]
    while len(chosen) < 4:
        k = int(len(x) * uniform())
        if k not in chosen:
            chosen.append(k)
    _, a, b, c = chosen
    least, most = scale
    mutant = []
    for j in range(len(x[i])):
        beta = least + (most - least) * uniform()
        mutant.append(x[a][j] + beta * (x[b][j] - x[c][j]))
    return mutant


def _mixed(
    own: list[float], mutant: list[float], crossover: float, uniform: Callable[[], float]
) -> list[float]:
    """Return the binomial crossover; one dimension is the mutant's without a draw."""
    certain = int(len(own) * uniform())
    return [
        mutant[j] if j == certain or uniform() <= crossover else own[j] for j in range(len(own))
    ]


def _uniform_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x


def _clipped(x: list[float], bounds: Bounds) -> list[float]:
    return [min(max(v, lower), upper) for v, (lower, upper) in zip(x, bounds, strict=True)]
