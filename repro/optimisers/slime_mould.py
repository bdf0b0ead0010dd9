"""SMA, the slime mould algorithm, as its authors' program runs it.

S. Li, H. Chen, M. Wang, A. A. Heidari, S. Mirjalili, Slime mould algorithm: a new method for
stochastic optimization, Future Generation Computer Systems 111 (2020) 300-323,
doi:10.1016/j.future.2020.03.055, with the authors' SMA.m (github aliasgharheidaricom/
Slime-Mould-Algorithm-A-New-Method-for-Stochastic-Optimization-, e80e3bd). Where the two differ
the program is followed:

- a restarted mould lands on the diagonal of the box: one draw serves all its coordinates;
- the weights of Eq. (2.5) use the decimal logarithm;
- X_A and X_B of Eq. (2.7) are new moulds for every coordinate, and r a new number;
- v_b and v_c are drawn per coordinate, v_c from the interval that shrinks from 1 to 0;
- moulds are clipped to the box when they are next evaluated; the last move is not evaluated.

One deviation. The program adds eps to bF - wF, which makes the argument of the logarithm
negative or infinite once all costs lie within eps (2.2e-16) of each other, and MATLAB then goes
on with complex numbers. Here the argument is held to [1, 2], the interval of exact arithmetic.

p = tanh|F - DF| takes costs as they are: another unit of cost is another algorithm. Costs must be
finite.
"""

import math
from dataclasses import dataclass
from typing import Literal, Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import fill, uniform
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.population import clip, copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search

_EPS = float(np.finfo(np.float64).eps)


@jit
def _sma(cost, data, bounds, population, iterations, parameters, state):
    z, falls = parameters[0], parameters[1] == 1.0
    X = uniform_population(bounds, population, state)
    W = np.empty_like(X)
    costs = np.empty(population)
    draws = np.empty(max(population, 5) * X.shape[1])
    words = np.empty(len(draws), dtype=np.uint64)
    best = np.zeros(bounds.shape[0])
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(1, iterations + 1):
        for i in range(population):
            clip(X[i], bounds)
            costs[i] = cost(X[i], data)
        order = np.argsort(costs, kind="mergesort")
        fill(draws[: W.size], words, state)
        _weigh(W, costs, order, draws)
        if costs[order[0]] < best_cost:
            best_cost = costs[order[0]]
            copy_into(best, X[order[0]])
        history[t - 1] = best_cost
        a = math.atanh(1.0 - t / iterations)  # Eq. (2.3)
        b = 1.0 - t / iterations
        for i in range(population):
            if uniform(state) < z:  # Eq. (2.7), first case
                _restart(X[i], bounds, uniform(state))
            else:
                p = math.tanh(abs(costs[i] - best_cost))  # Eq. (2.2)
                moves = draws[: (4 if falls else 5) * X.shape[1]]
                fill(moves, words, state)
                _creep(X, i, best, W, p, a, b, falls, moves)
    return best, best_cost, history, population * iterations


@jit
def _weigh(W, costs, order, draws):
    bF, wF = costs[order[0]], costs[order[-1]]
    S = bF - wF + _EPS
    for rank in range(len(order)):
        i = order[rank]
        # S >= 0 where all costs agree within eps
        argument = (bF - costs[i]) / S + 1.0 if S < 0.0 else 1.0
        logarithm = math.log10(min(max(argument, 1.0), 2.0))
        sign = 1.0 if 2 * (rank + 1) <= len(order) else -1.0
        first = rank * W.shape[1]
        for j in range(W.shape[1]):
            W[i, j] = 1.0 + sign * draws[first + j] * logarithm  # Eq. (2.5)


@jit
def _restart(x, bounds, u):
    for j in range(len(x)):
        x[j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * u


@jit
def _creep(X, i, best, W, p, a, b, falls, draws):
    """Move mould i by Eq. (2.7), second and third case.

    `draws` holds the numbers of v_b, those of v_c unless that `falls`, then r, A and B of each
    coordinate: the order in which the program draws them.
    """
    population, n = X.shape
    first = n if falls else 2 * n
    for j in range(n):
        if draws[first + 3 * j] < p:
            A = np.uint64(np.int64(population * draws[first + 3 * j + 1]))
            B = np.uint64(np.int64(population * draws[first + 3 * j + 2]))
            vb = -a + 2.0 * a * draws[j]
            X[i, j] = best[j] + vb * (W[i, j] * X[A, j] - X[B, j])
        else:
            vc = b if falls else -b + 2.0 * b * draws[n + j]
            X[i, j] = vc * X[i, j]


@dataclass(frozen=True, slots=True, kw_only=True)
class SMA:
    """Slime mould algorithm; `restart` is z, the chance that a mould starts anew.

    `contraction` is v_c: drawn from an interval that shrinks from [-1, 1] to 0, or, as the text
    after Eq. (2.7) can be read, the number that falls from 1 to 0.
    """

    restart: float = 0.03
    contraction: Literal["drawn", "falling"] = "drawn"

    def __post_init__(self) -> None:
        """Raise InputError for a chance outside [0, 1], or an unknown word."""
        check_choices(self)
        if not 0 <= self.restart <= 1:
            message = f"restart={self.restart} is a chance: it lies between 0 and 1"
            raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        falls = 1.0 if self.contraction == "falling" else 0.0
        return search(_sma, problem, parameters=(self.restart, falls), **budget)
