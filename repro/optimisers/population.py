"""Steps that the compiled searches share: how a population starts and stays in its box."""

from typing import Literal

import numpy as np

from repro.determinism.compiled import jit
from repro.determinism.draws import below, drawn, held, put_back, uniform

BoundsRule = Literal["clip", "re-initialise", "reflect"]
"""What becomes of a coordinate outside the box; see `hold`."""

CLIP, ANEW, REFLECT = 0.0, 1.0, 2.0


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
def hold(x, bounds, rule, state):
    """Bring back the coordinates of `x` outside their bounds, by a rule's place in `BoundsRule`.

    They are put on the nearer bound, drawn anew, or mirrored at the bound that they crossed; a
    mirror image beyond the other bound is put on that.
    """
    if rule == CLIP:
        clip(x, bounds)
        return
    for j in range(len(x)):
        lower, upper = bounds[j]
        if lower <= x[j] <= upper:
            continue
        if rule == ANEW:
            x[j] = lower + (upper - lower) * uniform(state)
        else:
            crossed = lower if x[j] < lower else upper
            x[j] = min(max(2.0 * crossed - x[j], lower), upper)


@jit
def some_of(n, count, state):
    """Return `count` different integers of 0..n-1, drawn one after the other."""
    some = np.arange(n)
    for k in range(count):
        other = k + below(n - k, state)
        some[k], some[other] = some[other], some[k]
    return some[:count]


@jit
def copy_into(target, source):
    """Copy `source` over `target` without making an array."""
    for j in range(len(target)):
        target[j] = source[j]
