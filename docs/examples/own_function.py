"""A benchmark function of one's own: a cost of any dimension, with its true minimum."""

from fractions import Fraction

import numpy as np

from repro.functions import Function, Known
from repro.optimisers import DE


def quartic(x):
    """Return the sum of j·x_j⁴."""
    return float(np.sum(np.arange(1, len(x) + 1) * x**4))


QUARTIC = Function(
    name="quartic_sum",
    title="Sum of weighted fourth powers",
    kernel=quartic,
    box=((-1.28, 1.28),),  # one pair for all coordinates
    minimum=0.0,
    at=(0.0,),
    source="made up for this page",
    known=Known(
        of=quartic,
        ceiling=lambda n: Fraction(n * (n + 1), 2) * Fraction(128, 100) ** 4,  # at a corner
        ceiling_on=((-1.28, 1.28),),
        least_of_all_space=True,
    ),
)

if __name__ == "__main__":
    rng = np.random.default_rng(1)
    problem = QUARTIC.problem(10)
    print(DE().minimise(problem, population=20, iterations=50, rng=rng).cost, problem.minimum)
