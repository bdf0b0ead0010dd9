"""WOA, the whale optimization algorithm, as its authors' program runs it.

S. Mirjalili, A. Lewis, The Whale Optimization Algorithm, Advances in Engineering Software 95
(2016) 51-67, doi:10.1016/j.advengsoft.2016.01.008, with the authors' WOA.m (github
alimirjalili/WOA, df28286). Where the two differ the program is followed:

- X_rand of Eqs. (2.7)-(2.8) is a new whale for every coordinate;
- A and C of Eqs. (2.3)-(2.4) are one number per whale each, from independent draws;
- l of Eq. (2.5) lies in (a2, 1] with a2 falling from -1 to -2;
- whales are clipped to the box when they are next evaluated; the last move is not evaluated.
"""

import math
from dataclasses import dataclass
from typing import Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import drawn, drawn_below, held, put_back
from repro.determinism.sines import cosine_of_turns
from repro.optimisers.population import copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search


@jit
def _woa(cost, data, bounds, population, iterations, parameters, state):
    b = parameters[0]
    n = bounds.shape[0]
    X, lower, upper = _padded(bounds, population, state)
    row = np.zeros(X.shape[1])
    x = row[:n]  # the whale at `cost`: a row of X would be reference-counted at every call
    best, leader = np.zeros_like(row), np.zeros_like(row)
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(iterations):
        for i in range(population):
            for j in range(len(row)):
                row[j] = X[i, j] = min(max(X[i, j], lower[j]), upper[j])
            value = cost(x, data)
            if value < best_cost:
                best_cost = value
                copy_into(best, row)
        history[t] = best_cost
        a = 2.0 - 2.0 * t / iterations
        a2 = -1.0 - t / iterations
        _move(X, best, leader, a, a2, b, n, state)
    return best[:n].copy(), best_cost, history, population * iterations


@jit
def _padded(bounds, population, state):
    """Return whales and bounds with zeros up to a multiple of 8, so that no loop has a rest."""
    n = bounds.shape[0]
    width = -(-n // 8) * 8
    X, lower, upper = np.zeros((population, width)), np.zeros(width), np.zeros(width)
    X[:, :n] = uniform_population(bounds, population, state)
    lower[:n], upper[:n] = bounds[:, 0], bounds[:, 1]
    return X, lower, upper


@jit
def _move(X, best, leader, a, a2, b, n, state):
    population, width = X.shape
    words = held(state)
    for i in range(population):
        r1, words = drawn(words)
        r2, words = drawn(words)
        u, words = drawn(words)
        p, words = drawn(words)
        A = 2.0 * a * r1 - a  # Eq. (2.3)
        C = 2.0 * r2  # Eq. (2.4)
        l = (a2 - 1.0) * u + 1.0  # noqa: E741 (the paper's letter)
        if p < 0.5:
            if abs(A) < 1.0:
                for j in range(width):
                    X[i, j] = best[j] - A * abs(C * best[j] - X[i, j])  # Eqs. (2.1)-(2.2)
            else:
                for j in range(n):
                    k, words = drawn_below(population, words)
                    leader[j] = X[k, j]
                for j in range(width):
                    X[i, j] = leader[j] - A * abs(C * leader[j] - X[i, j])  # Eqs. (2.7)-(2.8)
        else:
            turn = math.exp(b * l) * cosine_of_turns(l)
            for j in range(width):
                X[i, j] = abs(best[j] - X[i, j]) * turn + best[j]  # Eq. (2.5)
    put_back(words, state)


@dataclass(frozen=True, slots=True, kw_only=True)
class WOA:
    """Whale optimization algorithm; `b` shapes the logarithmic spiral of Eq. (2.5)."""

    b: float = 1.0

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        return search(_woa, problem, parameters=(self.b,), **budget)
