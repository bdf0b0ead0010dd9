"""Budget honesty: which algorithms a protocol of N agents and T iterations favours.

Papers compare algorithms at equal iterations. Some evaluate the cost more often in an iteration, or
once more before the first; for a comparison they run again with N·T evaluations.
"""

from collections.abc import Mapping
from dataclasses import replace

from repro.model.experiment import Experiment
from repro.optimisers.search import DeclaresSpending, Optimiser, every_agent_once

EQUAL_BUDGET = "equal budget"


def budget(experiment: Experiment) -> int:
    """Return N·T, the cost evaluations that a run has at equal budgets."""
    return experiment.population * experiment.iterations


def declared_evaluations(optimiser: Optimiser, population: int, iterations: int) -> int:
    """Return the evaluations of one run, as the optimiser declares its `spending`; else N·T."""
    spending = (
        optimiser.spending(population)
        if isinstance(optimiser, DeclaresSpending)
        else every_agent_once(population)
    )
    return int(spending.start + spending.each * iterations)


def unequal(experiment: Experiment) -> Mapping[str, int]:
    """Return the algorithms whose run spends more or fewer than N·T evaluations, and how many."""
    declared = {
        name: declared_evaluations(optimiser, experiment.population, experiment.iterations)
        for name, optimiser in experiment.algorithms.items()
    }
    return {name: count for name, count in declared.items() if count != budget(experiment)}


def at_equal_evaluations(experiment: Experiment) -> Experiment | None:
    """Return the experiment with the algorithms that must run again, each with N·T evaluations."""
    again = {name: experiment.algorithms[name] for name in unequal(experiment)}
    if not again:
        return None
    return replace(experiment, algorithms=again, evaluations=budget(experiment))
