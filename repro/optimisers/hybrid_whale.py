"""Whale optimisation with additions: other schedules, evolution of some whales, chaos.

With every addition off this is WOA, draw for draw. The additions are those that improved whale
papers combine: a Tent map start; other courses of a, b and of the choice between encircling and
spiral; differential evolution of the worst whales (R. Storn, K. Price, Journal of Global
Optimization 11 (1997) 341-359, doi:10.1023/A:1008202821328, strategy rand/1/bin); arithmetic
crossover with Gaussian perturbation of the best whales; a shrinking chaotic disturbance of the
best point. Evolution acts on the whales just evaluated, so each candidate meets its parent's
cost; every candidate costs one evaluation more than WOA spends.
"""

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, Self, Unpack, get_args

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, uniform
from repro.determinism.sines import cosine_of_turns
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.hybrid_places import (
    BOUNDS,
    CONTROL,
    DISTURBANCE,
    FITTEST,
    LEADER,
    PROBABILITY,
    SELECTS,
    SHARED,
    SPIRAL_FIRST,
    SPIRAL_LAST,
    SPIRAL_RANGE,
    START,
    VECTOR,
    WORST,
)
from repro.optimisers.population import BoundsRule, copy_into, hold
from repro.optimisers.search import Budget, Problem, Result, Spending, search
from repro.optimisers.tent_map import STARTS, Start, started
from repro.optimisers.whale_evolution import disturb, evolve

_LEAST = 4  # rand/1/bin needs three whales besides the one that it changes


@jit
def _hybrid(cost, data, bounds, population, iterations, parameters, state):
    worst, fittest = int(parameters[WORST]), int(parameters[FITTEST])
    disturbance = parameters[DISTURBANCE]
    X = started(bounds, population, parameters[START], state)
    costs = np.empty(population)
    best = np.zeros(bounds.shape[0])
    chain = np.zeros_like(best)
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(iterations):
        for i in range(population):
            hold(X[i], bounds, parameters[BOUNDS], state)
            costs[i] = cost(X[i], data)
            if costs[i] < best_cost:
                best_cost = costs[i]
                copy_into(best, X[i])
        if worst + fittest > 0:
            best_cost = evolve(cost, data, bounds, X, costs, best, best_cost, parameters, state)
        if disturbance > 0.0:
            amplitude = disturbance * (1.0 - t / iterations)
            best_cost = disturb(
                cost, data, bounds, best, best_cost, amplitude, chain, parameters, state
            )
        history[t] = best_cost
        _move(X, best, t, iterations, parameters, state)
    extra = worst + fittest + (1 if disturbance > 0.0 else 0)
    return best, best_cost, history, iterations * (population + extra)


@jit
def _move(X, best, t, iterations, parameters, state):
    vector = parameters[VECTOR] == 1.0
    share = t / iterations
    a = 2.0 * (1.0 - share * share) if parameters[CONTROL] == 1.0 else 2.0 - 2.0 * t / iterations
    a2 = -1.0 - share
    b = parameters[SPIRAL_LAST] + (parameters[SPIRAL_FIRST] - parameters[SPIRAL_LAST]) * (
        1.0 - share
    )
    threshold = (
        0.5 + 0.5 * math.cos(math.pi * t / iterations) if parameters[PROBABILITY] == 1.0 else 0.5
    )
    for i in range(X.shape[0]):
        A = C = 0.0
        if not vector:
            A, C = _coefficients(a, parameters[SHARED], state)
        u = uniform(state)
        l = 2.0 * u - 1.0 if parameters[SPIRAL_RANGE] == 1.0 else (a2 - 1.0) * u + 1.0  # noqa: E741
        chosen = uniform(state) < threshold
        if chosen == (parameters[SELECTS] == 0.0):
            _encircle_or_seek(X, i, best, a, A, C, parameters, state)
        else:
            turn = math.exp(b * l) * cosine_of_turns(l)
            for j in range(X.shape[1]):
                X[i, j] = abs(best[j] - X[i, j]) * turn + best[j]


@jit
def _coefficients(a, shared, state):
    """Return A and C of Eqs. (2.3)-(2.4), from one number where it is shared."""
    r = uniform(state)
    return 2.0 * a * r - a, 2.0 * (r if shared == 1.0 else uniform(state))


@jit
def _encircle_or_seek(X, i, best, a, A, C, parameters, state):
    population, n = X.shape
    vector, one_leader = parameters[VECTOR] == 1.0, parameters[LEADER] == 1.0
    leader = below(population, state) if one_leader and (vector or abs(A) >= 1.0) else 0
    for j in range(n):
        if vector:
            A, C = _coefficients(a, parameters[SHARED], state)
        if abs(A) < 1.0:
            target = best[j]
        elif one_leader:
            target = X[leader, j]
        else:
            target = X[below(population, state), j]
        X[i, j] = target - A * abs(C * target - X[i, j])


@dataclass(frozen=True, slots=True, kw_only=True)
class HybridWOA:
    """WOA whose additions are all off until they are set.

    `control` is the course of a from 2 to 0; `spiral` the first and last b; `probability` that
    of the chance which `probability_selects` names; `coefficients` says whether A and C are drawn
    per whale or per coordinate, `shared_draw` whether both come from one number; `leader` says of
    X_rand what `coefficients` says of A and C; `spiral_range` is that of l. `differential` and
    `genetic` are shares of the population, `evolves` says which whales the first means, `scale`
    and `crossover` are F and CR, `mutation` and `disturbance` shares of the width of the box, or
    of the coordinate if it `perturbs` in proportion; `partner` is the one to cross with. `bounds`
    says what becomes of a coordinate outside the box, `chain` whether the disturbance makes one
    step of the Tent map from a new draw, or the next of an orbit, which starts anew at 0: there
    any orbit of doubles ends.
    """

    start: Start = "uniform"
    control: Literal["linear", "quadratic"] = "linear"
    spiral: tuple[float, float] = (1.0, 1.0)
    probability: Literal["constant", "cosine"] = "constant"
    probability_selects: Literal["encircling", "spiral"] = "encircling"
    coefficients: Literal["scalar", "vector"] = "scalar"
    leader: Literal["per dimension", "per whale"] = "per dimension"
    spiral_range: Literal["shrinking", "symmetric"] = "shrinking"
    differential: float = 0.0
    scale: float = 0.5
    crossover: float = 0.9
    genetic: float = 0.0
    mutation: float = 0.01
    greedy: bool = True
    disturbance: float = 0.0
    partner: Literal["random", "best"] = "random"
    shared_draw: bool = False
    evolves: Literal["the worst", "any"] = "the worst"
    bounds: BoundsRule = "clip"
    perturbs: Literal["by the box", "in proportion"] = "by the box"
    chain: Literal["one step", "going on"] = "one step"

    def __post_init__(self) -> None:
        """Raise InputError for a share outside [0, 1], or an unknown word."""
        check_choices(self)
        for name in ("differential", "genetic", "crossover"):
            if not 0 <= getattr(self, name) <= 1:
                message = f"{name}={getattr(self, name)} is a share: it lies between 0 and 1"
                raise InputError(message)

    def __call__(self, **changes: Any) -> Self:  # noqa: ANN401 (any field)
        """Return a copy with some parameters changed: a declared variant is used as a class is."""
        return replace(self, **changes)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations and those of the additions."""
        return search(
            _hybrid,
            problem,
            parameters=self._parameters(budget["population"]),
            spending=self.spending,
            least=_LEAST,
            **budget,
        )

    def _counts(self, population: int) -> tuple[int, int]:
        return int(self.differential * population + 0.5), int(self.genetic * population + 0.5)

    def spending(self, population: int) -> Spending:
        """Return the evaluations before the loop and in each iteration."""
        return Spending(each=population + sum(self._counts(population)) + (self.disturbance > 0))

    def _parameters(self, population: int) -> tuple[float, ...]:
        worst, fittest = self._counts(population)
        return (
            STARTS.index(self.start),
            self.control == "quadratic",
            *self.spiral,
            self.probability == "cosine",
            self.probability_selects == "spiral",
            self.coefficients == "vector",
            self.leader == "per whale",
            self.spiral_range == "symmetric",
            worst,
            self.scale,
            self.crossover,
            fittest,
            self.mutation,
            self.greedy,
            self.disturbance,
            self.partner == "best",
            self.shared_draw,
            self.evolves == "any",
            get_args(BoundsRule).index(self.bounds),
            self.perturbs == "in proportion",
            self.chain == "going on",
        )
