"""GSA, the gravitational search algorithm, as its first author's program runs it.

E. Rashedi, H. Nezamabadi-pour, S. Saryazdi, GSA: a gravitational search algorithm, Information
Sciences 179(13) (2009) 2232-2248, doi:10.1016/j.ins.2009.03.004, with E. Rashedi's GSA.m, version
1.1 of 2010 (MATLAB Central File Exchange 27756). The program's choices:

- a coordinate that left the box is drawn anew from it (`bounds="re-initialise"`), which matters
  on functions of few dimensions; later copies put it on the bound (`bounds="clip"`);
- the force falls with the distance R, not with its square;
- the mass of the pulled agent cancels, so its acceleration is summed at once;
- velocities know no limit, and are kept when a coordinate is drawn anew;
- the K heaviest agents pull; K falls from N to `final_percent` of N, rounded to whole agents,
  so below 25 agents nobody pulls at the very end.
"""

import math
from dataclasses import dataclass
from typing import Unpack, get_args

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import fill
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.population import BoundsRule, copy_into, hold, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search

_EPS = float(np.finfo(np.float64).eps)


@jit
def _gsa(cost, data, bounds, population, iterations, parameters, state):
    G0, alpha, final_percent = parameters[:3]
    rule = parameters[3]
    X = uniform_population(bounds, population, state)
    V = np.zeros_like(X)
    pull = np.empty_like(X)
    n = bounds.shape[0]
    H = np.empty((n, population))
    R = np.empty(population)
    draws = np.empty(population * n)
    words = np.empty(population * n, dtype=np.uint64)
    costs = np.empty(population)
    best = np.zeros(bounds.shape[0])
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(1, iterations + 1):
        for i in range(population):
            hold(X[i], bounds, rule, state)
            costs[i] = cost(X[i], data)
            if costs[i] < best_cost:
                best_cost = costs[i]
                copy_into(best, X[i])
        history[t - 1] = best_cost
        G = G0 * math.exp(-alpha * t / iterations)
        percent = final_percent + (1.0 - t / iterations) * (100.0 - final_percent)
        K = int(population * percent / 100.0 + 0.5)
        M = _masses(costs)
        heaviest = np.argsort(-M, kind="mergesort")[:K]
        for j in range(n):
            for place in range(K):
                H[j, place] = X[heaviest[place], j]
        for i in range(population):
            _attract(pull[i], X, i, H, M, heaviest, R, draws, words, state)
        _fly(X, V, pull, G, draws, words, state)
    return best, best_cost, history, population * iterations


@jit
def _masses(costs):
    """Return masses that add up to 1: none for the worst agent, equal ones if all are equal.

    An agent whose cost is not finite has no mass; GSA.m knows no such cost.
    """
    best, worst = np.inf, -np.inf
    for value in costs:
        if math.isfinite(value):
            best, worst = min(best, value), max(worst, value)
    M = np.ones_like(costs)
    total = 0.0
    for i in range(len(costs)):
        if not math.isfinite(costs[i]):
            M[i] = 0.0
        elif best != worst:
            M[i] = (costs[i] - worst) / (best - worst)
        total += M[i]
    if total == 0.0:
        return M
    return M / total


@jit
def _attract(pull, X, i, H, M, heaviest, R, draws, words, state):
    """Write the acceleration of agent i over `pull`, without the factor G.

    `H` holds the heaviest agents, shape (n, K), as they stand. Its agents are the inner loop of the
    distances, and the numbers of all pulls are drawn at once: both vectorise, the sums do not.
    """
    n, K = len(pull), len(heaviest)
    R[:K] = 0.0
    for j in range(n):
        for place in range(K):
            R[place] += (X[i, j] - H[j, place]) * (X[i, j] - H[j, place])
    pulling = K
    for k in heaviest:
        if k == i:
            pulling -= 1
    fill(draws[: pulling * n], words, state)
    pull[:] = 0.0
    drawn = 0
    for place in range(K):
        k = heaviest[place]
        if k == i:
            continue
        distance = math.sqrt(R[place]) + _EPS
        for j in range(n):
            pull[j] += draws[drawn + j] * M[k] * (X[k, j] - X[i, j]) / distance
        drawn += n


@jit
def _fly(X, V, pull, G, draws, words, state):
    population, n = X.shape
    fill(draws, words, state)
    for i in range(population):
        for j in range(n):
            V[i, j] = draws[i * n + j] * V[i, j] + G * pull[i, j]
            X[i, j] += V[i, j]


@dataclass(frozen=True, slots=True, kw_only=True)
class GSA:
    """Gravitational search; `strength` is G0, `decay` alpha of G = G0·exp(-alpha·t/T).

    `final_percent` of the agents pull in the last iteration; `bounds` says what becomes of a
    coordinate that leaves the box.
    """

    strength: float = 100.0
    decay: float = 20.0
    final_percent: float = 2.0
    bounds: BoundsRule = "re-initialise"

    def __post_init__(self) -> None:
        """Raise InputError for a percentage outside [0, 100] or an unknown rule for bounds."""
        check_choices(self)
        if not 0 <= self.final_percent <= 100:
            message = f"final_percent={self.final_percent} is impossible: it lies in 0 to 100"
            raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        rule = get_args(BoundsRule).index(self.bounds)
        parameters = (self.strength, self.decay, self.final_percent, rule)
        return search(_gsa, problem, parameters=parameters, **budget)
