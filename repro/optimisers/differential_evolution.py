"""DE, differential evolution, as the program that comparisons pass round runs it.

R. Storn, K. Price, Differential evolution, Journal of Global Optimization 11 (1997) 341-359,
doi:10.1023/A:1008202821328, strategy rand/1/bin, with the steps and constants of the Yarpiz
project's DE.m (YPEA107, 2015). Where the two differ the program is followed:

- F is drawn for every coordinate, from U(0.2, 0.8); `scale=(F, F)` makes it the fixed number of
  the paper;
- a successful trial replaces its parent at once, so later agents of the same iteration see it;
- the mutant is clipped to the box before the crossover.
"""

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, fill
from repro.errors import InputError
from repro.optimisers.population import copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, Spending, search

_LEAST = 4  # rand/1 needs three agents besides the one that it changes


@jit
def _de(cost, data, bounds, population, iterations, parameters, state):
    least, most, CR = parameters[:3]
    X = uniform_population(bounds, population, state)
    costs = np.empty(population)
    for i in range(population):
        costs[i] = cost(X[i], data)
    first = np.argmin(costs)
    best = X[first].copy()
    best_cost = costs[first]
    y = np.empty_like(best)
    draws, words = np.empty(2 * len(y)), np.empty(2 * len(y), dtype=np.uint64)
    lower, upper = bounds[:, 0].copy(), bounds[:, 1].copy()  # contiguous, so clipping vectorises
    history = np.empty(iterations)
    for t in range(iterations):
        for i in range(population):
            a, b, c = _others(i, population, state)
            fill(draws, words, state)
            _mutate(y, X, a, b, c, least, most, draws)
            for j in range(len(y)):
                y[j] = min(max(y[j], lower[j]), upper[j])
            _cross(y, X, i, CR, draws)
            value = cost(y, data)
            if value < costs[i]:
                costs[i] = value
                for j in range(len(y)):
                    X[i, j] = y[j]
            if value < best_cost:
                best_cost = value
                copy_into(best, y)
        history[t] = best_cost
    return best, best_cost, history, population * (iterations + 1)


@jit
def _others(i, population, state):
    """Return three distinct agents other than agent i."""
    a = b = c = i
    while a == i:
        a = below(population, state)
    while b in (i, a):
        b = below(population, state)
    while c in (i, a, b):
        c = below(population, state)
    return a, b, c


@jit
def _mutate(y, X, a, b, c, least, most, draws):
    for j in range(len(y)):
        F = least + (most - least) * draws[j]
        y[j] = X[a, j] + F * (X[b, j] - X[c, j])


@jit
def _cross(y, X, i, CR, draws):
    """Put the parent's coordinates into mutant `y` where the crossover keeps them."""
    n = len(y)
    certain = np.int64(n * draws[n])  # it needs no draw: n - 1 numbers are left for the others
    for j in range(certain):
        if draws[n + 1 + j] > CR:
            y[j] = X[i, j]
    for j in range(certain + 1, n):
        if draws[n + j] > CR:
            y[j] = X[i, j]


@dataclass(frozen=True, slots=True, kw_only=True)
class DE:
    """Differential evolution; `scale` is the interval of F, `crossover` is CR."""

    scale: tuple[float, float] = (0.2, 0.8)
    crossover: float = 0.2

    def __post_init__(self) -> None:
        """Raise InputError for a crossover rate outside [0, 1]."""
        if not 0 <= self.crossover <= 1:
            message = f"crossover={self.crossover} is a chance: it lies between 0 and 1"
            raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·(T + 1) evaluations; see `Optimiser`."""
        return search(
            _de,
            problem,
            parameters=(*self.scale, self.crossover),
            spending=self.spending,
            least=_LEAST,
            **budget,
        )

    def spending(self, population: int) -> Spending:
        """Return what the search spends with so many agents."""
        return Spending(start=population, each=population)
