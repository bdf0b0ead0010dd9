"""A genetic algorithm without generations: a child takes a place only where it is the better.

As M. A. A. Mousa et al., Journal of Engineering Research 7(5) (2023) 53, tell it in section III-B:

- for each place in turn two agents are drawn at random, and with the crossover rate their child
  takes the place if its cost is lower than that of the agent there, which stays otherwise;
- with the mutation rate the agent of the place is drawn anew from the bounds instead, and takes
  the place whatever its cost, while the best point so far is remembered.

How a child comes of its parents is not told: here either each gene is that of the one or the
other by the toss of a coin, or each is a blend, or the genes before a random point are those of
the one and the rest those of the other. The start costs N evaluations; a place at which
nothing is tried costs none, so an iteration costs N at most.
"""

from dataclasses import dataclass
from typing import Literal, Unpack, get_args

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, uniform
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.population import copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, Spending, search

Mixing = Literal["toss", "blend", "one point"]


@jit
def _steady_state(cost, data, bounds, population, iterations, parameters, state):
    crossover, mutation, mixing = parameters[:3]
    X = uniform_population(bounds, population, state)
    costs = np.empty(population)
    for i in range(population):
        costs[i] = cost(X[i], data)
    best = X[np.argmin(costs)].copy()
    best_cost = costs.min()
    history = np.empty(iterations)
    trial = np.empty(bounds.shape[0])
    spent = population
    for t in range(iterations):
        for i in range(population):
            mutated = uniform(state) < mutation
            if mutated:
                for j in range(len(trial)):
                    trial[j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * uniform(state)
            elif uniform(state) < crossover:
                _mix(trial, X, mixing, state)
            else:
                continue
            value = cost(trial, data)
            spent += 1
            if mutated or value < costs[i]:
                costs[i] = value
                copy_into(X[i], trial)
            if value < best_cost:
                best_cost = value
                copy_into(best, trial)
        history[t] = best_cost
    return best, best_cost, history, spent


@jit
def _mix(child, X, mixing, state):
    first, second = below(len(X), state), below(len(X), state)
    cut = 1 + below(max(len(child) - 1, 1), state) if mixing == 2.0 else 0
    for j in range(len(child)):
        share = 1.0 if j < cut else 0.0
        if mixing < 2.0:
            share = uniform(state)
        if mixing == 0.0:
            share = 1.0 if share < 0.5 else 0.0
        child[j] = share * X[first, j] + (1.0 - share) * X[second, j]


@dataclass(frozen=True, slots=True, kw_only=True)
class SteadyStateGA:
    """Genetic algorithm in which a child replaces a worse agent; rates are per place.

    `mixing` makes each gene of a child that of one of its parents by the "toss" of a coin, or a
    "blend" β·x1 + (1 - β)·x2 with β drawn gene by gene, or splits them at "one point".
    """

    crossover: float = 0.8
    mutation: float = 0.01
    mixing: Mixing = "toss"

    def __post_init__(self) -> None:
        """Raise InputError for a rate outside [0, 1] or an unknown mixing."""
        check_choices(self)
        for name in ("crossover", "mutation"):
            if not 0 <= getattr(self, name) <= 1:
                message = f"{name}={getattr(self, name)} is a rate: it lies between 0 and 1"
                raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by at most N + N·T evaluations; see `Optimiser`."""
        return search(
            _steady_state,
            problem,
            parameters=(self.crossover, self.mutation, get_args(Mixing).index(self.mixing)),
            spending=self.spending,
            **budget,
        )

    def spending(self, population: int) -> Spending:
        """Return the most that the search spends with so many agents."""
        return Spending(start=population, each=population)
