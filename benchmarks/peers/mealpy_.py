"""mealpy: one object per agent, NumPy over its coordinates."""

import mealpy

from benchmarks.peers.task import Task

PACKAGE = "mealpy"
RUNS = {
    "WOA": "OriginalWOA: A and C share one draw, l in [-1, 1), X_rand a fresh point of the box; "
    "greedy: only better whales move",
    "GWO": "OriginalGWO: leaders from the present pack; greedy: only better wolves move",
    "PSO": "OriginalPSO: w 0.4, c 2.05, no limit of velocity; outside coordinates drawn anew",
    "DE": "OriginalDE: rand/1/bin, F 0.1, CR 0.9, no certain coordinate",
    "SMA": "OriginalSMA: restarts per coordinate; two distinct moulds, drawn with `choice`",
}


def run(task: Task) -> float:
    """Return the best cost of one run."""
    module = getattr(mealpy, task.algorithm)
    search = getattr(module, f"Original{task.algorithm}")(task.iterations, task.population)
    bounds = mealpy.FloatVar(lb=[task.lower] * task.dimension, ub=[task.upper] * task.dimension)
    problem = {"bounds": bounds, "minmax": "min", "obj_func": task.objective, "log_to": None}
    return float(search.solve(problem, seed=task.seed).target.fitness)
