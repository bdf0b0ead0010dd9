"""scipy's searches: functions like `minimize` are taken as they are, by the names they give."""

from scipy.optimize import differential_evolution, direct, dual_annealing

EVOLUTION = differential_evolution  # compare with_scipy:EVOLUTION
ANNEALING = dual_annealing


def divided(cost, bounds, budget, rng):
    """DIRECT, which draws nothing: all its runs are the same, and a warning says so."""
    return direct(cost, bounds, maxfun=budget).x
