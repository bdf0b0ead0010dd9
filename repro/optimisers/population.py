"""Steps that the compiled searches share: how a population starts and stays in its box."""

import numpy as np

from repro.compiled import jit
from repro.draws import drawn, held, put_back


@jit
def uniform_population(bounds, population, state):
    """Return points drawn uniformly from the box, shape (population, n), dimension by dimension.

    The order of the draws is that of MATLAB's column-major `rand(N, D)`.
    """
    n = bounds.shape[0]
    X = np.empty((population, n))
    words = held(state)
    for j in range(n):
        for i in range(population):
            u, words = drawn(words)
            X[i, j] = bounds[j, 0] + (bounds[j, 1] - bounds[j, 0]) * u
    put_back(words, state)
    return X


@jit
def clip(x, bounds):
    """Put every coordinate of `x` that lies outside its bounds on the nearer bound."""
    for j in range(len(x)):
        x[j] = min(max(x[j], bounds[j, 0]), bounds[j, 1])


@jit
def copy_into(target, source):
    """Copy `source` over `target` without making an array."""
    for j in range(len(target)):
        target[j] = source[j]
