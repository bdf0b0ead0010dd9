"""Benchmark functions with box, dimension, true minimum and minimiser."""

import importlib
import pkgutil
from collections.abc import Mapping
from types import MappingProxyType

from repro.functions.function import BenchmarkProblem, Function

__all__ = ["FUNCTIONS", "BenchmarkProblem", "Function"]


def _found() -> Mapping[str, Function]:
    modules = (
        importlib.import_module(f"{__name__}.{info.name}")
        for info in pkgutil.iter_modules(__path__)
    )
    values = (value for module in modules for value in vars(module).values())
    return MappingProxyType({v.name: v for v in values if isinstance(v, Function)})


FUNCTIONS = _found()
"""Every Function that a file of this folder defines, by name."""
