"""What hybrid whales add to the moves of WOA: evolution of some, and a disturbance of the best.

Rand/1/bin of R. Storn, K. Price, Journal of Global Optimization 11 (1997) 341-359,
doi:10.1023/A:1008202821328; arithmetic crossover with Gaussian perturbation; one step of the Tent
map from the best point. A perturbation is a share of the width of the box, or of the coordinate.
"""

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, normal, uniform
from repro.optimisers.hybrid_places import (
    ANY,
    BOUNDS,
    CHAIN,
    CROSSOVER,
    FITTEST,
    GREEDY,
    MUTATION,
    PARTNER,
    PROPORTION,
    SCALE,
    WORST,
)
from repro.optimisers.population import copy_into, hold, some_of
from repro.optimisers.tent_map import tent


@jit
def perturbed_size(x, bounds, parameters):
    """Return what a perturbation is a share of."""
    return x if parameters[PROPORTION] == 1.0 else bounds[1] - bounds[0]


@jit
def _differential(X, i, F, CR, state):
    population, n = X.shape
    r1 = r2 = r3 = i
    while r1 == i:
        r1 = below(population, state)
    while r2 in (i, r1):
        r2 = below(population, state)
    while r3 in (i, r1, r2):
        r3 = below(population, state)
    U = X[i].copy()
    for j in range(n):
        if uniform(state) <= CR:
            U[j] = X[r1, j] + F * (X[r2, j] - X[r3, j])
    return U


@jit
def _crossover(X, i, best, bounds, parameters, state):
    population, n = X.shape
    with_best = parameters[PARTNER] == 1.0
    k = i
    while k == i and not with_best:
        k = below(population, state)
    alpha = uniform(state)
    child = np.empty(n)
    for j in range(n):
        other = best[j] if with_best else X[k, j]
        crossed = alpha * X[i, j] + (1.0 - alpha) * other
        size = perturbed_size(crossed, bounds[j], parameters)
        child[j] = crossed + parameters[MUTATION] * size * normal(state)
    return child


@jit
def evolve(cost, data, bounds, X, costs, best, best_cost, parameters, state):
    """Evolve the worst and the best whales, and return the best cost known after that."""
    worst, fittest = int(parameters[WORST]), int(parameters[FITTEST])
    population = len(costs)
    order = np.argsort(costs, kind="mergesort")
    evolved = order[population - worst :]
    if parameters[ANY] == 1.0:
        evolved = some_of(population, worst, state)
    for rank in range(worst + fittest):
        if rank < worst:
            i = evolved[rank]
            candidate = _differential(X, i, parameters[SCALE], parameters[CROSSOVER], state)
        else:
            i = order[rank - worst]
            candidate = _crossover(X, i, best, bounds, parameters, state)
        hold(candidate, bounds, parameters[BOUNDS], state)
        value = cost(candidate, data)
        if value < costs[i] or parameters[GREEDY] == 0.0:
            costs[i] = value
            copy_into(X[i], candidate)
        if value < best_cost:
            best_cost = value
            copy_into(best, candidate)
    return best_cost


@jit
def disturb(cost, data, bounds, best, best_cost, amplitude, chain, parameters, state):
    """Try one chaotic step from the best point, and return the best cost known after that.

    `chain` holds a number per coordinate; where it is 0, the orbit starts from a new draw.
    """
    candidate = np.empty_like(best)
    for j in range(len(best)):
        z = tent(uniform(state) if chain[j] == 0.0 else chain[j])
        if parameters[CHAIN] == 1.0:
            chain[j] = z
        size = perturbed_size(best[j], bounds[j], parameters)
        candidate[j] = best[j] + amplitude * size * (2.0 * z - 1.0)
    hold(candidate, bounds, parameters[BOUNDS], state)
    value = cost(candidate, data)
    if value < best_cost:
        copy_into(best, candidate)
        return value
    return best_cost
