"""GWO, the grey wolf optimizer, as its authors' program runs it.

S. Mirjalili, S. M. Mirjalili, A. Lewis, Grey Wolf Optimizer, Advances in Engineering Software 69
(2014) 46-61, doi:10.1016/j.advengsoft.2013.12.007, with the authors' GWO.m (github
alimirjalili/GWO, addb3d0). Where the two differ the program is followed: the leaders are the
best wolves of the whole history, and a dethroned leader is forgotten, not moved down a rank.
"""

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import fill
from repro.optimisers.population import copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search

_LEAST = 3  # wolves: alpha, beta and delta


@jit
def _gwo(cost, data, bounds, population, iterations, parameters, state):  # noqa: ARG001
    n = bounds.shape[0]
    X = uniform_population(bounds, population, state)
    x = np.empty(n)  # the wolf at `cost`: a row of X would be reference-counted at every call
    leaders = np.zeros((3, n))  # alpha, beta, delta
    costs = np.full(3, np.inf)
    history = np.empty(iterations)
    draws, words = np.empty(6 * n), np.empty(6 * n, dtype=np.uint64)
    for t in range(iterations):
        for i in range(population):
            for j in range(n):
                x[j] = X[i, j] = min(max(X[i, j], bounds[j, 0]), bounds[j, 1])
            _rank(x, cost(x, data), leaders, costs)
        history[t] = costs[0]
        a = 2.0 - 2.0 * t / iterations
        for i in range(population):
            fill(draws, words, state)
            _follow(X, i, leaders, a, draws)
    return leaders[0].copy(), costs[0], history, population * iterations


@jit
def _rank(x, value, leaders, costs):
    # three independent tests in this order; a tie with a leader ranks nowhere
    if value < costs[0]:
        costs[0] = value
        copy_into(leaders[0], x)
    if value > costs[0] and value < costs[1]:
        costs[1] = value
        copy_into(leaders[1], x)
    if value > costs[0] and value > costs[1] and value < costs[2]:
        costs[2] = value
        copy_into(leaders[2], x)


@jit
def _follow(X, i, leaders, a, draws):
    for j in range(X.shape[1]):
        total = 0.0
        for k in range(3):
            A = 2.0 * a * draws[6 * j + 2 * k] - a  # Eq. (3.3)
            C = 2.0 * draws[6 * j + 2 * k + 1]  # Eq. (3.4)
            total += leaders[k, j] - A * abs(C * leaders[k, j] - X[i, j])  # Eqs. (3.5)-(3.6)
        X[i, j] = total / 3.0  # Eq. (3.7)


@dataclass(frozen=True, slots=True, kw_only=True)
class GWO:
    """Grey wolf optimizer; it has no parameters."""

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        return search(_gwo, problem, least=_LEAST, **budget)
