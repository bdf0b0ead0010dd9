"""pycma: its object has `ask` and `tell`, so that a function that makes one is enough."""

import cma


def evolve(bounds, budget, rng):
    """Make CMA-ES in the box, started at a random point; seed 0 would be the clock's."""
    low, high = bounds.T
    return cma.CMAEvolutionStrategy(
        rng.uniform(low, high),
        float((high - low).mean()) / 5,
        {"bounds": [low, high], "seed": int(rng.integers(1, 2**31)), "verbose": -9},
    )
