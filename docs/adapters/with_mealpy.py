"""mealpy: points are real vectors, and a seed is all its chance."""

from mealpy import FloatVar
from mealpy.swarm_based.WOA import OriginalWOA


def whale(cost, bounds, budget, rng):
    """Run the original whale optimiser of mealpy."""
    search = OriginalWOA(epoch=max(1, budget // 20), pop_size=20)
    problem = {
        "obj_func": cost,
        "bounds": FloatVar(*bounds.T),
        "minmax": "min",
        "log_to": None,
    }
    return search.solve(problem, seed=int(rng.integers(2**31))).solution
