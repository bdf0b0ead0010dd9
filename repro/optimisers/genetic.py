"""GA, a genetic algorithm with real genes, for papers that name it and give two rates.

There is no one reference: the programs that comparisons use differ in every operator. This is a
choice among them, made for papers that say "GA, crossover 0.8, mutation 0.01" and no more. Those
are the numbers of MATLAB's `ga` (CrossoverFraction, and the rate of `mutationuniform`), whose
rank scaling is used too:

- parents are drawn by a roulette with slots 1/sqrt(rank), two different ones for each child;
- with the crossover rate the child is beta·x1 + (1 - beta)·x2, beta drawn gene by gene; otherwise
  it is a copy of the first parent;
- then each gene is drawn anew from its bounds with the mutation rate, and the child clipped;
- the elites go on unchanged, and all other places go to children.

The start costs N evaluations and each generation N less the elites, whose costs are known.
"""

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import uniform
from repro.errors import InputError
from repro.optimisers.population import clip, copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, Spending, search


@jit
def _ga(cost, data, bounds, population, iterations, parameters, state):
    crossover, mutation, elites = parameters[0], parameters[1], int(parameters[2])
    slot_ends = np.cumsum(1.0 / np.sqrt(np.arange(1, population + 1)))
    X = uniform_population(bounds, population, state)
    costs = np.empty(population)
    for i in range(population):
        costs[i] = cost(X[i], data)
    first = np.argmin(costs)
    best = X[first].copy()
    best_cost = costs[first]
    history = np.empty(iterations)
    for t in range(iterations):
        order = np.argsort(costs, kind="mergesort")
        parents = X[order]
        costs = costs[order]
        for i in range(elites):
            copy_into(X[i], parents[i])
        for i in range(elites, population):
            _breed(X[i], parents, slot_ends, crossover, state)
            _mutate(X[i], bounds, mutation, state)
            clip(X[i], bounds)
            costs[i] = cost(X[i], data)
            if costs[i] < best_cost:
                best_cost = costs[i]
                copy_into(best, X[i])
        history[t] = best_cost
    return best, best_cost, history, population + (population - elites) * iterations


@jit
def _breed(child, parents, slot_ends, crossover, state):
    first = second = _spin(slot_ends, state)
    while second == first:
        second = _spin(slot_ends, state)
    copy_into(child, parents[first])
    if uniform(state) < crossover:
        for j in range(len(child)):
            beta = uniform(state)
            child[j] = beta * parents[first, j] + (1.0 - beta) * parents[second, j]


@jit
def _spin(slot_ends, state):
    """Return the rank, from 0, on which the ball of the roulette falls."""
    ball = uniform(state) * slot_ends[-1]
    return np.searchsorted(slot_ends, ball, side="right")


@jit
def _mutate(x, bounds, mutation, state):
    for j in range(len(x)):
        if uniform(state) < mutation:
            x[j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * uniform(state)


@dataclass(frozen=True, slots=True, kw_only=True)
class GA:
    """Genetic algorithm; `crossover` is a rate per child, `mutation` per gene."""

    crossover: float = 0.8
    mutation: float = 0.01
    elites: int = 2

    def __post_init__(self) -> None:
        """Raise InputError for a rate outside [0, 1] or a negative number of elites."""
        for name in ("crossover", "mutation"):
            if not 0 <= getattr(self, name) <= 1:
                message = f"{name}={getattr(self, name)} is a rate: it lies between 0 and 1"
                raise InputError(message)
        if self.elites < 0:
            message = f"elites={self.elites} is impossible; it may be 0 or more"
            raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N + (N - elites)·T evaluations; see `Optimiser`."""
        return search(
            _ga,
            problem,
            parameters=(self.crossover, self.mutation, self.elites),
            spending=self.spending,
            least=max(2, self.elites + 1),
            **budget,
        )

    def spending(self, population: int) -> Spending:
        """Return the evaluations before the loop and in each iteration."""
        return Spending(start=population, each=population - self.elites)
