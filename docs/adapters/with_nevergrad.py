"""nevergrad: an optimiser of an array with bounds, whose chance is a NumPy RandomState."""

import nevergrad as ng
import numpy as np


def one_plus_one(cost, bounds, budget, rng):
    """Run the (1+1) evolution strategy of nevergrad."""
    low, high = bounds.T
    space = ng.p.Array(init=rng.uniform(low, high)).set_bounds(low, high)
    space.random_state = np.random.RandomState(int(rng.integers(2**31)))
    search = ng.optimizers.OnePlusOne(parametrization=space, budget=budget)
    return search.minimize(cost).value
