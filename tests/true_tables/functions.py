"""Test functions in NumPy, in the precision of their argument, as programs write them."""

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np

from repro.commands.audit_functions import named_bounds
from repro.tables.blocks import FunctionBounds
from tests.true_tables.samples import Generator, Vector

Array = Any  # NumPy says nothing of what its methods return
DIMENSIONS = (2, 5, 10, 30)


def _sphere(x: Array) -> Array:
    return (x**2).sum(axis=1)


def _rastrigin(x: Array) -> Array:
    return (x**2 - 10 * np.cos(x.dtype.type(2 * np.pi) * x) + 10).sum(axis=1)


def _rastrigin_last(x: Array) -> Array:  # the squares are added last, and do not cancel
    return (10 - 10 * np.cos(x.dtype.type(2 * np.pi) * x) + x**2).sum(axis=1)


def _rastrigin_at_once(x: Array) -> Array:
    terms = x**2 - 10 * np.cos(x.dtype.type(2 * np.pi) * x)
    return 10 * x.shape[1] + terms.sum(axis=1)


def _ackley(x: Array) -> Array:
    kind = x.dtype.type
    far = -20 * np.exp(kind(-0.2) * np.sqrt((x**2).mean(axis=1)))
    return far - np.exp(np.cos(kind(2 * np.pi) * x).mean(axis=1)) + 20 + kind(np.e)


def _griewank(x: Array) -> Array:
    roots = np.sqrt(np.arange(1, x.shape[1] + 1, dtype=x.dtype))
    return (x**2).sum(axis=1) / 4000 - np.cos(x / roots).prod(axis=1) + 1


def _rosenbrock(x: Array) -> Array:
    return (100 * (x[:, 1:] - x[:, :-1] ** 2) ** 2 + (x[:, :-1] - 1) ** 2).sum(axis=1)


def _schwefel_2_22(x: Array) -> Array:
    return np.abs(x).sum(axis=1) + np.abs(x).prod(axis=1)


def _schwefel_2_21(x: Array) -> Array:
    return np.abs(x).max(axis=1)


PROGRAMS: dict[str, tuple[tuple[Callable[[Array], Array], ...], float, float]] = {
    "sphere": ((_sphere,), 100, 0),
    "rastrigin": ((_rastrigin, _rastrigin_last, _rastrigin_at_once), 5.12, 0),
    "ackley": ((_ackley,), 32, 0),
    "griewank": ((_griewank,), 600, 0),
    "rosenbrock": ((_rosenbrock,), 30, 1),
    "schwefel_2_22": ((_schwefel_2_22,), 10, 0),
    "schwefel_2_21": ((_schwefel_2_21,), 100, 0),
}


@cache
def bounds(name: str, dimension: int) -> FunctionBounds:
    """Return what the package knows of a function."""
    return named_bounds(f"{name}@{dimension}")


def function_runs(
    rng: Generator, n: int, *, single: bool
) -> tuple[Vector, FunctionBounds, frozenset[str]]:
    """Return n final costs of a function near its least point or far, and conditions it breaks."""
    name = list(PROGRAMS)[int(rng.integers(len(PROGRAMS)))]
    programs, half, least = PROGRAMS[name]
    dimension = DIMENSIONS[int(rng.integers(len(DIMENSIONS)))]
    reach = 10.0 ** rng.uniform(-12, 0.5, (n, 1)) * (1 if rng.random() < 0.5 else half)
    points = least + rng.uniform(-1, 1, (n, dimension)) * reach
    points = np.clip(points, -half, half).astype(np.float32 if single else np.float64)
    program = programs[int(rng.integers(len(programs)))]
    known = bounds(name, dimension)
    broken = {known.condition} if program is _rastrigin_last else set()
    return program(points).astype(float), known, frozenset(broken)


def minimum_told(value: float) -> Fraction:
    """Return a minimum as an option tells it."""
    return Fraction(repr(value))
