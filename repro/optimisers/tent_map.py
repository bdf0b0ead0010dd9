"""The Tent map with slope 2, and populations that start along its orbits."""

from typing import Literal, get_args

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import uniform
from repro.optimisers.population import uniform_population

Start = Literal["uniform", "tent", "tent across", "tent chain"]
STARTS = get_args(Start)


@jit
def tent(z):
    """Return the next value of the Tent map with slope 2 on [0, 1]."""
    return z / 0.5 if z < 0.5 else (1.0 - z) / 0.5


@jit
def started(bounds, population, kind, state):
    """Return whales (population, n) in the box, `kind` being a position in STARTS.

    One orbit runs per coordinate through the whales ("tent"), per whale through its coordinates
    ("tent across"), or through all coordinates of all whales ("tent chain").
    """
    if kind == 0.0:
        return uniform_population(bounds, population, state)
    n = bounds.shape[0]
    Z = np.empty((population, n))
    if kind == 1.0:
        for j in range(n):
            Z[0, j] = uniform(state)
            for i in range(1, population):
                Z[i, j] = tent(Z[i - 1, j])
    else:
        z = 0.0
        for i in range(population):
            for j in range(n):
                fresh = j == 0 and (kind == 2.0 or i == 0)
                z = uniform(state) if fresh else tent(z)
                Z[i, j] = z
    for j in range(n):
        for i in range(population):
            Z[i, j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * Z[i, j]
    return Z
