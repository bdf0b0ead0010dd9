"""Whether what each reading of a paper has run can be run, and is anything else: without a run."""

from collections.abc import Iterator

from repro.errors import ReproError
from repro.functions import BenchmarkProblem
from repro.model.experiment import Experiment
from repro.model.faults import experiment_faults
from repro.model.functions_tried import function_faults
from repro.model.paper import Paper
from repro.runs.plan import Memory, made_of
from repro.runs.readings import changed_part, readings


def reading_plan_faults(paper: Paper) -> Iterator[str]:
    """Yield a line for what a reading, or several together, have run and cannot be.

    Each experiment that a reading bears on is built once and its runs get their keys.
    """
    memory: Memory = {}
    for reading in readings(paper):
        for experiment in paper.experiments:
            if reading.touching(experiment.name).alternatives:
                place = f"reading {reading.name!r}"
                try:
                    changed = changed_part(experiment, reading)
                    found = list(_faults(experiment, changed, memory))
                except (ReproError, TypeError, ValueError) as error:
                    found = [f"experiment {experiment.name!r}: {error}"]
                yield from (f"{place}, {fault}" for fault in found)


def _faults(experiment: Experiment, changed: Experiment | None, memory: Memory) -> Iterator[str]:
    place = f"experiment {experiment.name!r}"
    if changed is None or _is_as_before(experiment, changed, memory):
        yield f"{place}: nothing that decides its runs is changed"
        return
    yield from experiment_faults(changed)
    for name, problem in changed.problems.items():
        if isinstance(problem, BenchmarkProblem) and problem is not experiment.problems[name]:
            yield from (f"{place}, problem {name!r}: {fault}" for fault in function_faults(problem))


def _is_as_before(experiment: Experiment, changed: Experiment, memory: Memory) -> bool:
    """Return whether all runs of what is changed are those of the paper's own protocol."""
    same = [
        made_of(changed, problem, algorithm, memory).digest
        == made_of(experiment, problem, algorithm, memory).digest
        for problem in changed.problems
        for algorithm in changed.algorithms
    ]
    return all(same) and changed.runs == experiment.runs
