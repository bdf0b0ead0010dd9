"""How WOA can be read: what every paper that compares with it leaves open.

S. Mirjalili, A. Lewis, Advances in Engineering Software 95 (2016) 51-67, and its authors' program.
"""

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

from repro.model.experiment import Experiment
from repro.optimisers import HybridWOA, Optimiser, SlimeWOA

WOA_BY_EQUATIONS = HybridWOA(leader="per whale", spiral_range="symmetric")
WOA_READINGS: Mapping[str, Optimiser] = MappingProxyType(
    {
        "WOA by its equations": WOA_BY_EQUATIONS,
        "WOA by its equations, vectors": WOA_BY_EQUATIONS(coefficients="vector"),
        "WOA with one draw": SlimeWOA(
            leader="per whale", spiral_range="symmetric", shared_draw=True
        ),
        "reflection": HybridWOA(bounds="reflect"),
        "new places": HybridWOA(bounds="re-initialise"),
    }
)
"""WOA in the place of its authors' program, by the name of the alternative."""


def everywhere(
    experiments: Iterable[Experiment],
    algorithm: str,
    change: Any,  # noqa: ANN401
) -> dict[tuple[str, str], Any]:
    """Return a change of an algorithm in every experiment that has it, as an Alternative's field.

    `change` is what takes its place, or the fields to replace.
    """
    return {(e.name, algorithm): change for e in experiments if algorithm in e.algorithms}


def woa_readings(
    experiments: Iterable[Experiment], *names: str, algorithm: str = "WOA"
) -> dict[str, dict[str, Any]]:
    """Return what the named readings of WOA change, all of them if none is named."""
    own = tuple(experiments)
    return {
        name: {"algorithms": everywhere(own, algorithm, WOA_READINGS[name])}
        for name in names or WOA_READINGS
    }
