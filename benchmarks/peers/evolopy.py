"""EvoloPy: plain Python loops over NumPy arrays, ported from the authors' MATLAB programs."""

import importlib
import random

import numpy as np

from benchmarks.peers.task import Task

PACKAGE = "evolopy"
RUNS = {
    "WOA": "the authors' WOA.m, step by step",
    "GWO": "the authors' GWO.m, but a dethroned leader moves down a rank",
    "PSO": "the constants of PSO.m, with every particle clipped",
    "DE": "rand/1/bin, F 0.5, CR 0.7, no certain coordinate, all first costs but one forgotten",
}


def run(task: Task) -> float:
    """Return the best cost of one run."""
    random.seed(task.seed)
    np.random.seed(task.seed)  # noqa: NPY002 (the library draws from the global generator)
    search = getattr(
        importlib.import_module(f"EvoloPy.optimizers.{task.algorithm}"), task.algorithm
    )
    size = (task.dimension, task.population, task.iterations)
    return float(search(task.objective, task.lower, task.upper, *size).convergence[-1])
