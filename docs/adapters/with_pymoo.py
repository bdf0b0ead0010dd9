"""pymoo: a problem whose cost is asked for a whole population at once."""

from pymoo.algorithms.soo.nonconvex.de import DE
from pymoo.core.problem import Problem
from pymoo.optimize import minimize


def evolve(cost, bounds, budget, rng):
    """Run differential evolution of pymoo."""

    class Boxed(Problem):
        def _evaluate(self, x, out, *_, **__):
            out["F"] = cost(x)

    low, high = bounds.T
    boxed = Boxed(n_var=len(bounds), n_obj=1, xl=low, xu=high)
    seed = int(rng.integers(2**31))
    return minimize(boxed, DE(pop_size=20), ("n_eval", budget), seed=seed).X
