"""Benchmark functions with box, dimension, true minimum and minimiser."""

import difflib
import importlib
import pkgutil
from collections.abc import Mapping
from types import MappingProxyType
from typing import NoReturn

from repro.errors import InputError
from repro.functions.function import BenchmarkProblem, Function
from repro.functions.known import Known
from repro.functions.own import BoxProblem

__all__ = ["FUNCTIONS", "BenchmarkProblem", "BoxProblem", "Function", "Known", "classical"]

_NUMBERED = (
    "sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21", "rosenbrock", "step",
    "quartic_noise", "schwefel_2_26", "rastrigin", "ackley", "griewank", "penalized_1",
    "penalized_2", "foxholes", "kowalik", "six_hump_camel", "branin", "goldstein_price",
    "hartmann_3", "hartmann_6", "shekel_5", "shekel_7", "shekel_10",
)  # fmt: skip


class _ByName(dict[str, Function]):
    def __missing__(self, name: str) -> NoReturn:
        near = difflib.get_close_matches(str(name), self, n=1)
        hint = f"did you mean {near[0]!r}? " if near else ""
        message = f"no function {name!r}; {hint}there is {', '.join(self)}"
        raise InputError(message)


def _found() -> Mapping[str, Function]:
    modules = (
        importlib.import_module(f"{__name__}.{info.name}")
        for info in pkgutil.iter_modules(__path__)
    )
    values = (value for module in modules for value in vars(module).values())
    return MappingProxyType(_ByName({v.name: v for v in values if isinstance(v, Function)}))


FUNCTIONS = _found()
"""Every Function that a file of this folder defines, by name.

Another name raises InputError with the nearest.
"""


def classical(dimension: int = 30) -> dict[str, BenchmarkProblem]:
    """Return F1 to F23 of Yao, Liu & Lin (1999), of `dimension` where that is free.

    F6 is without rounding and F20 has p_32 = 0.1415, as in the programs of the whale and wolf
    papers, which number the functions alike.
    """
    found = [FUNCTIONS[name] for name in _NUMBERED]
    return {f"F{k}": f.problem(f.fixed_dimension or dimension) for k, f in enumerate(found, 1)}
