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

from repro.compiled import jit
from repro.draws import below, uniform
from repro.errors import InputError
from repro.optimisers.population import clip, copy_into, uniform_population
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
    history = np.empty(iterations)
    for t in range(iterations):
        for i in range(population):
            _mutate(y, X, i, least, most, state)
            clip(y, bounds)
            _cross(y, X[i], CR, state)
            value = cost(y, data)
            if value < costs[i]:
                costs[i] = value
                copy_into(X[i], y)
            if value < best_cost:
                best_cost = value
                copy_into(best, y)
        history[t] = best_cost
    return best, best_cost, history, population * (iterations + 1)


@jit
def _mutate(y, X, i, least, most, state):
    population = X.shape[0]
    a = b = c = i
    while a == i:
        a = below(population, state)
    while b in (i, a):
        b = below(population, state)
    while c in (i, a, b):
        c = below(population, state)
    for j in range(len(y)):
        F = least + (most - least) * uniform(state)
        y[j] = X[a, j] + F * (X[b, j] - X[c, j])


@jit
def _cross(y, x, CR, state):
    """Put the parent's coordinates into mutant `y` where the crossover keeps them."""
    certain = below(len(y), state)
    for j in range(len(y)):
        if j != certain and uniform(state) > CR:
            y[j] = x[j]


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
