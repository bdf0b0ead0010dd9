"""How WOA can be read: what every paper that compares with it leaves open.

S. Mirjalili, A. Lewis, Advances in Engineering Software 95 (2016) 51-67, and its authors' program.
The equations say one random whale for all coordinates and l uniform in [-1, 1]; whether A and C are
numbers or vectors is the paper's to say that prints them.
"""

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

from repro.model.experiment import Experiment
from repro.optimisers import WOA, HybridWOA

WOA_BY_EQUATIONS = HybridWOA(leader="per whale", spiral_range="symmetric")
"""WOA by its equations, A and C one number a whale each."""
WOA_BY_VECTORS = WOA_BY_EQUATIONS(coefficients="vector")
"""WOA by its equations, A and C drawn for every coordinate."""

_EQUATIONS = {"leader": "per whale", "spiral_range": "symmetric"}
WOA_READINGS: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        "WOA's program": {
            "leader": "per dimension",
            "spiral_range": "shrinking",
            "coefficients": "scalar",
            "shared_draw": False,
        },
        "WOA by its equations, numbers": {**_EQUATIONS, "coefficients": "scalar"},
        "WOA by its equations, vectors": {**_EQUATIONS, "coefficients": "vector"},
        "WOA with one draw": {**_EQUATIONS, "shared_draw": True},
        "reflection": {"bounds": "reflect"},
        "new places": {"bounds": "re-initialise"},
    }
)
"""What a reading changes of WOA as a paper declares it, by the name of the alternative."""


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
    """Return what the named readings of WOA change; if none is named, all but its default.

    A reading keeps what it says nothing of as the experiment declares it, which may be the program
    or the equations.
    """
    own = {
        (e.name, algorithm): e.algorithms[algorithm]
        for e in experiments
        if algorithm in e.algorithms
    }
    changes = {
        name: {cell: _read(declared, WOA_READINGS[name]) for cell, declared in own.items()}
        for name in names or WOA_READINGS
    }
    return {
        name: {"algorithms": change} for name, change in changes.items() if names or change != own
    }


def _read(declared: Any, fields: Mapping[str, Any]) -> Any:  # noqa: ANN401
    """Return WOA with some fields otherwise; its program is `HybridWOA` without additions."""
    read = (declared if isinstance(declared, HybridWOA) else HybridWOA())(**fields)
    return WOA() if read == HybridWOA() else read
