"""Whale optimisation with parts of the slime mould algorithm: its step length and its weights.

With every part off this is WOA, draw for draw. The parts are those of the slime mould whale
algorithm (SMWOA; Algorithms 15(10) (2022) 363, doi:10.3390/a15100363): a falls as an arc
hyperbolic tangent, Eq. (10), and bounds A, Eq. (15); the weight ω of the slime mould, Eq. (11),
stands before the leader in the spiral, Eq. (13), and in the search, Eq. (14); the spiral swings
by v_b, uniform in [-a, a], Eq. (13). The encircling move, Eq. (12), is WOA's.

Both parents are followed where that paper is silent: whales move one after another, are put on
the edge of the box when they are next evaluated, and the last move is not evaluated; t counts
from 1 under Eq. (10), which is infinite at 0. Where all costs are equal Eq. (11) is 0/0, and the
weights are 1. What the paper leaves to choose is a field of `SlimeWOA`.
"""

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, Self, Unpack, get_args

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, drawn, drawn_below, fill, held, put_back, uniform
from repro.determinism.sines import cosine_of_turns
from repro.errors import InputError
from repro.optimisers.choices import check_choices
from repro.optimisers.population import BoundsRule, copy_into, hold, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search

Control = Literal["linear", "arctanh"]
Weight = Literal["none", "of the whale", "of the leader"]
Swing = Literal["none", "per dimension", "per whale"]

# places of the parameters in the vector that the kernel is given
(
    B,
    CONTROL,
    WEIGHT,
    EACH_WEIGHT,
    NATURAL,
    SWING,
    VECTOR,
    SHARED,
    LEADER,
    SYMMETRIC,
    RESTART,
    AT_ONCE,
    GREEDY,
    BOUNDS,
) = range(14)


@jit
def _slime_whale(cost, data, bounds, population, iterations, parameters, state):
    X = uniform_population(bounds, population, state)
    W = np.ones_like(X)
    draws = np.empty(W.size)
    words = np.empty(W.size, dtype=np.uint64)
    P = X.copy()
    costs = np.full(population, np.inf)
    best = np.zeros(bounds.shape[0])
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(1, iterations + 1):
        for i in range(population):
            hold(X[i], bounds, parameters[BOUNDS], state)
            value = cost(X[i], data)
            if parameters[GREEDY] == 0.0:
                costs[i] = value
            elif value < costs[i]:
                costs[i] = value
                copy_into(P[i], X[i])
            else:
                copy_into(X[i], P[i])
            if costs[i] < best_cost:
                best_cost = costs[i]
                copy_into(best, X[i])
        history[t - 1] = best_cost
        if parameters[WEIGHT] > 0.0:
            _weigh(W, costs, parameters, draws, words, state)
        if parameters[CONTROL] == 1.0:
            a = math.atanh(1.0 - t / iterations)  # Eq. (10)
        else:
            a = 2.0 - 2.0 * (t - 1) / iterations
        a2 = -1.0 - (t - 1) / iterations
        seen = X.copy() if parameters[AT_ONCE] == 1.0 else X
        for i in range(population):
            if parameters[RESTART] > 0.0 and uniform(state) < parameters[RESTART]:
                _restart(X[i], bounds, uniform(state))  # Eq. (8), first case
            else:
                _move(X, seen, i, best, W, a, a2, parameters, state)
    return best, best_cost, history, population * iterations


@jit
def _weigh(W, costs, parameters, draws, words, state):
    population, n = W.shape
    each, natural = parameters[EACH_WEIGHT] == 1.0, parameters[NATURAL] == 1.0
    fill(draws[: W.size if each else population], words, state)
    order = np.argsort(costs, kind="mergesort")
    bF, wF = costs[order[0]], costs[order[-1]]
    for rank in range(len(order)):
        i = order[rank]
        share = (bF - costs[i]) / (bF - wF) if wF > bF else 0.0
        logarithm = math.log(share + 1.0) if natural else math.log10(share + 1.0)
        sign = 1.0 if 2 * (rank + 1) <= len(order) else -1.0
        if each:
            for j in range(n):
                W[i, j] = 1.0 + sign * draws[rank * n + j] * logarithm  # Eq. (11)
        else:
            W[i, :] = 1.0 + sign * draws[rank] * logarithm


@jit
def _restart(x, bounds, u):
    for j in range(len(x)):
        x[j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * u


@jit
def _move(X, seen, i, best, W, a, a2, parameters, state):
    A = C = 0.0
    if parameters[VECTOR] == 0.0:
        r = uniform(state)
        A = 2.0 * a * r - a  # Eq. (15)
        C = 2.0 * (r if parameters[SHARED] == 1.0 else uniform(state))
    u = uniform(state)
    l = 2.0 * u - 1.0 if parameters[SYMMETRIC] == 1.0 else (a2 - 1.0) * u + 1.0  # noqa: E741
    if uniform(state) < 0.5:
        _encircle_or_search(X, seen, i, best, W, a, A, C, parameters, state)
    else:
        turn = math.exp(parameters[B] * l) * cosine_of_turns(l)
        _spiral(X[i], best, W[i], a, turn, parameters, state)


@jit
def _encircle_or_search(X, seen, i, best, W, a, A, C, parameters, state):
    population, n = X.shape
    vector, one_leader = parameters[VECTOR] == 1.0, parameters[LEADER] == 1.0
    if not vector and abs(A) < 1.0:
        for j in range(n):
            X[i, j] = best[j] - A * abs(C * best[j] - X[i, j])  # Eq. (12)
        return
    k = np.uint64(below(population, state) if one_leader else i)
    words = held(state)
    for j in range(n):
        if vector:
            r, words = drawn(words)
            A = 2.0 * a * r - a
            if parameters[SHARED] == 0.0:
                r, words = drawn(words)
            C = 2.0 * r
        if abs(A) < 1.0:
            X[i, j] = best[j] - A * abs(C * best[j] - X[i, j])  # Eq. (12)
            continue
        if not one_leader:
            k, words = drawn_below(population, words)
        factor = C
        if parameters[WEIGHT] > 0.0:
            factor = W[i, j] if parameters[WEIGHT] == 1.0 else W[k, j]
        X[i, j] = seen[k, j] - A * abs(factor * seen[k, j] - X[i, j])  # Eq. (14)
    put_back(words, state)


@jit
def _spiral(x, best, weight, a, turn, parameters, state):
    vb = 1.0
    if parameters[SWING] == 2.0:
        vb = -a + 2.0 * a * uniform(state)
    words = held(state)
    for j in range(len(x)):
        if parameters[SWING] == 1.0:
            u, words = drawn(words)
            vb = -a + 2.0 * a * u
        omega = weight[j] if parameters[WEIGHT] == 1.0 else 1.0  # that of the best is 1
        x[j] = abs(omega * best[j] - x[j]) * (vb * turn) + best[j]  # Eq. (13)
    put_back(words, state)


@dataclass(frozen=True, slots=True, kw_only=True)
class SlimeWOA:
    """WOA whose slime mould parts are all off until they are set.

    `control` is the course of a: WOA's line or Eq. (10). `weight` says whose ω stands in Eqs. (13)
    and (14), the moving whale's or that of the whale it multiplies; `weights` whether ω is drawn
    per dimension or per whale; `logarithm` which one Eq. (11) means. `swing` is how v_b is drawn.
    `coefficients` says the same of A and C, `shared_draw` whether both come from one number;
    `leader` whether the random whale is a new one in every dimension; `spiral_range` is that of l,
    `b` shapes the spiral. `restart` is z of Eq. (8), the chance that a whale starts anew. `moves`
    says whether a whale sees others where they have just moved; if `greedy`, a move is taken back
    that does not lower the whale's cost. `bounds` says what becomes of coordinates outside the box.
    """

    b: float = 1.0
    control: Control = "linear"
    weight: Weight = "none"
    weights: Literal["per dimension", "per whale"] = "per dimension"
    logarithm: Literal["decimal", "natural"] = "decimal"
    swing: Swing = "none"
    coefficients: Literal["scalar", "vector"] = "scalar"
    shared_draw: bool = False
    leader: Literal["per dimension", "per whale"] = "per dimension"
    spiral_range: Literal["shrinking", "symmetric"] = "shrinking"
    restart: float = 0.0
    moves: Literal["in turn", "at once"] = "in turn"
    greedy: bool = False
    bounds: BoundsRule = "clip"

    def __post_init__(self) -> None:
        """Raise InputError for a chance outside [0, 1], or an unknown word."""
        check_choices(self)
        if not 0 <= self.restart <= 1:
            message = f"restart={self.restart} is a chance: it lies between 0 and 1"
            raise InputError(message)

    def __call__(self, **changes: Any) -> Self:  # noqa: ANN401 (any field)
        """Return a copy with some parameters changed: a declared variant is used as a class is."""
        return replace(self, **changes)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        parameters = (
            self.b,
            get_args(Control).index(self.control),
            get_args(Weight).index(self.weight),
            self.weights == "per dimension",
            self.logarithm == "natural",
            get_args(Swing).index(self.swing),
            self.coefficients == "vector",
            self.shared_draw,
            self.leader == "per whale",
            self.spiral_range == "symmetric",
            self.restart,
            self.moves == "at once",
            self.greedy,
            get_args(BoundsRule).index(self.bounds),
        )
        return search(_slime_whale, problem, parameters=parameters, **budget)
