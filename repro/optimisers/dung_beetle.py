"""DBO, the dung beetle optimizer, as its authors' program runs it.

J. Xue, B. Shen, Dung beetle optimizer: a new meta-heuristic algorithm for global optimization,
Journal of Supercomputing 79 (2023) 7305-7336, doi:10.1007/s11227-022-04959-6, with the authors'
DBO.m of 28 November 2022 (github Lancephil/Dung-Beetle-Optimizer, 62d5c7f). Where the two differ
the program is followed:

- x(t) in every equation is the beetle's personal best, x(t-1) that of the iteration before;
- one draw per iteration sends all rollers rolling or all of them dancing;
- the dance turns by a whole number of degrees from 1 to 180, none of them skipped;
- for a negative coordinate the bounds of Eq. (3) change places, and a brood ball ends on X*(1+R);
- the group ends 12 and 19 are fixed numbers made for 30 beetles; only the rollers scale with N
  (`groups="proportional"` scales them all). From 63 beetles on the rollers reach past 12, and
  those past it are moved and evaluated a second time by the next groups.
"""

import math
from dataclasses import dataclass
from typing import Literal, Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, normal, uniform
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.population import clip, copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, Spending, search

_LEAST_AS_CODED = 20  # the third group ends at beetle 19


@jit
def _dbo(cost, data, bounds, population, iterations, parameters, state):
    rollers, broods, foragers = int(parameters[0]), int(parameters[1]), int(parameters[2])
    X = uniform_population(bounds, population, state)
    costs = np.empty(population)
    _evaluate(cost, data, bounds, X, costs, 0, population)
    P = X.copy()  # personal bests
    P_costs = costs.copy()
    P_before = X.copy()
    first = np.argmin(costs)
    best = P[first].copy()
    best_cost = costs[first]
    history = np.empty(iterations)
    for t in range(1, iterations + 1):
        _roll_or_dance(X, P, P_before, X[np.argmax(costs)].copy(), rollers, parameters, state)
        _evaluate(cost, data, bounds, X, costs, 0, rollers)
        local = X[np.argmin(costs)].copy()
        R = 1.0 - t / iterations
        _lay(X, P, local, R, rollers, broods, bounds, state)
        _evaluate(cost, data, bounds, X, costs, rollers, broods)
        _forage(X, P, best, R, broods, foragers, bounds, state)
        _evaluate(cost, data, bounds, X, costs, broods, foragers)
        _steal(X, P, local, best, foragers, parameters[7], state)
        _evaluate(cost, data, bounds, X, costs, foragers, population)
        for i in range(population):
            copy_into(P_before[i], P[i])
            if costs[i] < P_costs[i]:
                P_costs[i] = costs[i]
                copy_into(P[i], X[i])
            if P_costs[i] < best_cost:
                best_cost = P_costs[i]
                copy_into(best, P[i])
        history[t - 1] = best_cost
    each = population + max(rollers - broods, 0)
    return best, best_cost, history, population + each * iterations


@jit
def _evaluate(cost, data, bounds, X, costs, start, end):
    for i in range(start, end):
        clip(X[i], bounds)
        costs[i] = cost(X[i], data)


@jit
def _roll_or_dance(X, P, P_before, worst, rollers, parameters, state):
    k, b, natural, obstacle = parameters[3:7]
    rolling = uniform(state) < 1.0 - obstacle
    for i in range(rollers):
        if rolling:
            uniform(state)  # drawn and not used by the program
            alpha = 1.0 if uniform(state) > natural else -1.0
            for j in range(X.shape[1]):  # Eq. (1)
                X[i, j] = P[i, j] + b * abs(P[i, j] - worst[j]) + alpha * k * P_before[i, j]
        else:
            turn = math.tan((below(180, state) + 1) * math.pi / 180.0)
            for j in range(X.shape[1]):  # Eq. (2)
                X[i, j] = P[i, j] + turn * abs(P[i, j] - P_before[i, j])


@jit
def _shrunk(x, share, bounds):
    region = share * x
    clip(region, bounds)
    return region


@jit
def _lay(X, P, local, R, start, end, bounds, state):
    lower = _shrunk(local, 1.0 - R, bounds)  # Eq. (3)
    upper = _shrunk(local, 1.0 + R, bounds)
    for i in range(start, end):
        for j in range(X.shape[1]):  # Eq. (4)
            from_lower = uniform(state) * (P[i, j] - lower[j])
            value = local[j] + from_lower + uniform(state) * (P[i, j] - upper[j])
            value = max(value, lower[j])
            X[i, j] = min(value, upper[j])


@jit
def _forage(X, P, best, R, start, end, bounds, state):
    lower = _shrunk(best, 1.0 - R, bounds)  # Eq. (5)
    upper = _shrunk(best, 1.0 + R, bounds)
    for i in range(start, end):
        C1 = normal(state)
        for j in range(X.shape[1]):  # Eq. (6)
            X[i, j] = P[i, j] + C1 * (P[i, j] - lower[j]) + uniform(state) * (P[i, j] - upper[j])


@jit
def _steal(X, P, local, best, start, S, state):
    for i in range(start, X.shape[0]):
        for j in range(X.shape[1]):  # Eq. (7)
            distance = abs(P[i, j] - local[j]) + abs(P[i, j] - best[j])
            X[i, j] = best[j] + S * normal(state) * distance


@dataclass(frozen=True, slots=True, kw_only=True)
class DBO:
    """Dung beetle optimizer.

    `producers` is the share that rolls, `deflection` k, `pull` b, `natural` the chance that
    alpha = -1, `obstacle` that of a dance, `size` S of Eq. (7).
    """

    producers: float = 0.2
    deflection: float = 0.1
    pull: float = 0.3
    natural: float = 0.1
    obstacle: float = 0.1
    size: float = 0.5
    groups: Literal["as coded", "proportional"] = "as coded"

    def __post_init__(self) -> None:
        """Raise InputError for a share of producers outside [0, 1], or an unknown word."""
        check_choices(self)
        if not 0 <= self.producers <= 1:
            message = f"producers={self.producers} is a share: it lies between 0 and 1"
            raise InputError(message)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·(T + 1) evaluations, if N < 63; see `Optimiser`."""
        ends = self._group_ends(budget["population"])
        constants = (self.deflection, self.pull, self.natural, self.obstacle, self.size)
        return search(
            _dbo,
            problem,
            parameters=(*ends, *constants),
            spending=self.spending,
            least=_LEAST_AS_CODED if self.groups == "as coded" else 5,
            **budget,
        )

    def _group_ends(self, population: int) -> tuple[int, int, int]:
        if self.groups == "proportional":
            return 6 * population // 30, 12 * population // 30, 19 * population // 30
        return int(self.producers * population + 0.5), 12, 19

    def spending(self, population: int) -> Spending:
        """Return the evaluations before the loop and in each iteration."""
        rollers, broods, _ = self._group_ends(population)
        return Spending(start=population, each=population + max(rollers - broods, 0))
