"""The baselines on every problem of an experiment, at its budget."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from repro.model.experiment import Experiment
from repro.optimisers.libraries import BASELINES

BASELINE_STUDY = "baselines"
COMPILED_STUDY = "compiled baselines"
AS_LONG = 50
"""Evaluations of a compiled search that take as long as one of a search in Python, about."""
OF_PROTOCOL = 1 / 3
"""What the searches in Python may cost of what the protocol's runs do: a quarter of both at most.

It is counted and not timed, so that every machine makes the same runs.
"""

_IN_PYTHON = {name for name, by in BASELINES.items() if getattr(by, "holds_interpreter", False)}
STUDY_OF: Mapping[str, str] = MappingProxyType(
    {name: BASELINE_STUDY if name in _IN_PYTHON else COMPILED_STUDY for name in BASELINES}
)
"""In which study a baseline is run, by the name that the pages give it."""


def with_baselines(experiment: Experiment, repeats: int) -> dict[str, Experiment]:
    """Return the experiment with the baselines in the place of its algorithms, by study.

    A compiled one has as many runs as the protocol. One in Python has as many as `OF_PROTOCOL`
    allows where the protocol is run `repeats` times, but one at least.
    """
    protocol = repeats * experiment.runs * len(experiment.algorithms)
    allowed = int(OF_PROTOCOL * protocol / (AS_LONG * len(_IN_PYTHON)))
    few = min(max(1, allowed), experiment.runs)
    return {
        study: replace(
            experiment,
            algorithms={name: BASELINES[name] for name in BASELINES if STUDY_OF[name] == study},
            runs=runs,
        )
        for study, runs in ((BASELINE_STUDY, few), (COMPILED_STUDY, experiment.runs))
    }
