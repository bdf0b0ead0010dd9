"""The baselines on every problem of an experiment, at its budget."""

from dataclasses import replace

from repro.model.experiment import Experiment
from repro.optimisers.libraries import BASELINES

BASELINE_STUDY = "baselines"
BASELINE_RUNS = 4  # of each baseline on each problem: one of all takes a minute, mostly in Python


def with_baselines(experiment: Experiment) -> Experiment:
    """Return the experiment with the baselines in the place of its algorithms."""
    return replace(experiment, algorithms=BASELINES, runs=BASELINE_RUNS)
