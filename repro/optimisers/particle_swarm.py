"""PSO, particle swarm optimisation with inertia, as the whale and wolf papers compared it.

J. Kennedy, R. Eberhart, Proc. ICNN 1995, doi:10.1109/ICNN.1995.488968; inertia weight of Y. Shi,
R. Eberhart, Proc. ICEC 1998, doi:10.1109/ICEC.1998.699146. Constants and order of steps are those
of the PSO.m that ships with the comparison toolboxes of the wolf and whale papers. In that
program the line that clips positions stands outside the particle loop and so acts on the last
particle alone; `clip="last particle"` keeps this, and with it the published PSO columns.
"""

from dataclasses import dataclass
from typing import Literal, Unpack

import numpy as np

from repro.compiled import jit
from repro.draws import uniform
from repro.optimisers.choices import check_choices
from repro.optimisers.population import clip, copy_into, uniform_population
from repro.optimisers.search import Budget, Problem, Result, search


@jit
def _pso(cost, data, bounds, population, iterations, parameters, state):
    v_max, w_first, w_last, c1, c2 = parameters[:5]
    first_clipped = 0 if parameters[5] == 1.0 else population - 1
    X = uniform_population(bounds, population, state)
    V = np.zeros_like(X)
    P = np.zeros_like(X)
    costs = np.full(population, np.inf)
    best = np.zeros(bounds.shape[0])
    best_cost = np.inf
    history = np.empty(iterations)
    for t in range(1, iterations + 1):
        for i in range(first_clipped, population):
            clip(X[i], bounds)
        for i in range(population):
            value = cost(X[i], data)
            if value < costs[i]:
                costs[i] = value
                copy_into(P[i], X[i])
            if value < best_cost:
                best_cost = value
                copy_into(best, X[i])
        history[t - 1] = best_cost
        w = w_first - t * (w_first - w_last) / iterations
        for i in range(population):
            _fly(X[i], V[i], P[i], best, w, c1, c2, v_max, state)
    return best, best_cost, history, population * iterations


@jit
def _fly(x, v, p, best, w, c1, c2, v_max, state):
    for j in range(len(x)):
        memory = c1 * uniform(state) * (p[j] - x[j])
        swarm = c2 * uniform(state) * (best[j] - x[j])
        v[j] = min(max(w * v[j] + memory + swarm, -v_max), v_max)
        x[j] += v[j]


@dataclass(frozen=True, slots=True, kw_only=True)
class PSO:
    """Particle swarm; `inertia` is (first, last), `maximum_velocity` is in units of x."""

    maximum_velocity: float = 6.0
    inertia: tuple[float, float] = (0.9, 0.2)
    cognitive: float = 2.0
    social: float = 2.0
    clip: Literal["last particle", "every particle"] = "last particle"

    def __post_init__(self) -> None:
        """Raise InputError for an unknown word."""
        check_choices(self)

    @property
    def leaves_box(self) -> bool:
        """Whether the best point may lie outside the box, as in the published program."""
        return self.clip == "last particle"

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`.

        The point may lie outside the box: only clipped particles are held inside.
        """
        every = 1.0 if self.clip == "every particle" else 0.0
        parameters = (self.maximum_velocity, *self.inertia, self.cognitive, self.social, every)
        return search(_pso, problem, parameters=parameters, **budget)
