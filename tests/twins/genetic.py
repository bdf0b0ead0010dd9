"""Genetic algorithm in plain Python, with the operators that comparisons name most often."""

import math
from collections.abc import Callable, Sequence

Bounds = Sequence[tuple[float, float]]


def genetic(
    cost: Callable[[list[float]], float],
    bounds: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    crossover: float = 0.8,
    mutation: float = 0.01,
    elites: int = 2,
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each generation, and evaluations.

    The latter are N at the start and N less the elites, whose costs are known, per generation.
    """
    del normal  # all twins are called alike
    people = [(cost(x), x) for x in _uniform_positions(bounds, population, uniform)]
    evaluations = population
    best_cost, best_x = min(people, key=_cost)
    history: list[float] = []
    for _ in range(iterations):
        ranked = sorted(people, key=_cost)
        people = ranked[:elites]
        for _ in range(population - elites):
            child = _crossed([x for _, x in ranked], crossover, uniform)
            child = _clipped(_mutated(child, bounds, mutation, uniform), bounds)
            people.append((cost(child), child))
            evaluations += 1
        for f, x in people:
            if f < best_cost:
                best_cost, best_x = f, x
        history.append(best_cost)
    return best_x, best_cost, history, evaluations


def _cost(person: tuple[float, list[float]]) -> float:
    return person[0]


def _crossed(
    ranked: list[list[float]], crossover: float, uniform: Callable[[], float]
) -> list[float]:
    """Return a child of two different parents: a blend gene by gene, or the first of them."""
    first = _drawn(len(ranked), uniform)
    second = first
    while second == first:
        second = _drawn(len(ranked), uniform)
    if uniform() >= crossover:
        return list(ranked[first])
    child = []
    for one, other in zip(ranked[first], ranked[second], strict=True):
        beta = uniform()
        child.append(beta * one + (1.0 - beta) * other)
    return child


def _drawn(population: int, uniform: Callable[[], float]) -> int:
    """Return a rank from 0, by a roulette whose slots are as wide as 1 / sqrt(rank from 1)."""
    ends = []
    total = 0.0
    for rank in range(1, population + 1):
        total += 1.0 / math.sqrt(rank)
        ends.append(total)
    ball = uniform() * total
    return next(rank for rank, end in enumerate(ends) if ball < end)


def _mutated(
    x: list[float], bounds: Bounds, mutation: float, uniform: Callable[[], float]
) -> list[float]:
    """Return x with each gene drawn anew from its bounds where chance has it."""
    return [
        lower + (upper - lower) * uniform() if uniform() < mutation else gene
        for gene, (lower, upper) in zip(x, bounds, strict=True)
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
