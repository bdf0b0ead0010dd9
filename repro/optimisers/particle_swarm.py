"""PSO, particle swarm optimisation with inertia, as the whale and wolf papers compared it.

J. Kennedy, R. Eberhart, Proc. ICNN 1995, doi:10.1109/ICNN.1995.488968; inertia weight of Y. Shi,
R. Eberhart, Proc. ICEC 1998, doi:10.1109/ICEC.1998.699146. Constants and order of steps are those
of the PSO.m that ships with the comparison toolboxes of the wolf and whale papers. In that
program the line that clips positions stands outside the particle loop and so acts on the last
particle alone; `clip="last particle"` keeps this, and with it the published PSO columns. Without
it every particle is held in the box.
"""

from dataclasses import dataclass
from typing import Literal, Unpack

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import fill
from repro.optimisers.choices import check_choices
from repro.optimisers.population import clip, copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search


@jit
def _pso(cost, data, bounds, population, iterations, parameters, state):
    v_max, w_first, w_last, c1, c2 = parameters[:5]
    first_clipped = 0 if parameters[5] == 1.0 else population - 1
    n = bounds.shape[0]
    X = uniform_population(bounds, population, state)
    V = np.zeros_like(X)
    P = np.zeros_like(X)
    x = np.empty(n)  # the particle at `cost`: a row of X would be reference-counted at every call
    costs = np.full(population, np.inf)
    best = np.zeros(n)
    best_cost = np.inf
    history = np.empty(iterations)
    draws, words = np.empty(2 * n), np.empty(2 * n, dtype=np.uint64)
    for t in range(1, iterations + 1):
        for i in range(first_clipped, population):
            clip(X[i], bounds)
        for i in range(population):
            for j in range(n):
                x[j] = X[i, j]
            value = cost(x, data)
            if value < costs[i]:
                costs[i] = value
                for j in range(n):
                    P[i, j] = x[j]
            if value < best_cost:
                best_cost = value
                copy_into(best, x)
        history[t - 1] = best_cost
        w = w_first - t * (w_first - w_last) / iterations
        _fly(X, V, P, best, w, c1, c2, v_max, draws, words, state)
    return best, best_cost, history, population * iterations


@jit
def _fly(X, V, P, best, w, c1, c2, v_max, draws, words, state):
    for i in range(X.shape[0]):
        fill(draws, words, state)
        for j in range(X.shape[1]):
            memory = c1 * draws[2 * j] * (P[i, j] - X[i, j])
            swarm = c2 * draws[2 * j + 1] * (best[j] - X[i, j])
            V[i, j] = min(max(w * V[i, j] + memory + swarm, -v_max), v_max)
            X[i, j] += V[i, j]


@dataclass(frozen=True, slots=True, kw_only=True)
class PSO:
    """Particle swarm; `inertia` is (first, last), `maximum_velocity` is in units of x."""

    maximum_velocity: float = 6.0
    inertia: tuple[float, float] = (0.9, 0.2)
    cognitive: float = 2.0
    social: float = 2.0
    clip: Literal["last particle", "every particle"] = "every particle"

    def __post_init__(self) -> None:
        """Raise InputError for an unknown word."""
        check_choices(self)

    @property
    def leaves_box(self) -> bool:
        """Whether the best point may lie outside the box, as in the published program."""
        return self.clip == "last particle"

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`.

        The point may lie outside the box where only the last particle is clipped.
        """
        every = 1.0 if self.clip == "every particle" else 0.0
        parameters = (self.maximum_velocity, *self.inertia, self.cognitive, self.social, every)
        return search(_pso, problem, parameters=parameters, **budget)
