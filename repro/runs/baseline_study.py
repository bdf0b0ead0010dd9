"""The baselines on every problem of an experiment, at its budget."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from repro.model.experiment import Experiment
from repro.optimisers.libraries import BASELINES

BASELINE_STUDY = "baselines"
COMPILED_STUDY = "compiled baselines"
BASELINE_RUNS = 4  # of each on each problem: one of all takes a minute, nearly all of it in Python

_IN_PYTHON = {name for name, by in BASELINES.items() if getattr(by, "holds_interpreter", False)}
STUDY_OF: Mapping[str, str] = MappingProxyType(
    {name: BASELINE_STUDY if name in _IN_PYTHON else COMPILED_STUDY for name in BASELINES}
)
"""In which study a baseline is run, by the name that the pages give it."""


def with_baselines(experiment: Experiment) -> dict[str, Experiment]:
    """Return the experiment with the baselines in the place of its algorithms, by study.

    A compiled one has as many runs as the protocol, one in Python `BASELINE_RUNS` at most.
    """
    few = min(BASELINE_RUNS, experiment.runs)
    return {
        study: replace(
            experiment,
            algorithms={name: BASELINES[name] for name in BASELINES if STUDY_OF[name] == study},
            runs=runs,
        )
        for study, runs in ((BASELINE_STUDY, few), (COMPILED_STUDY, experiment.runs))
    }
