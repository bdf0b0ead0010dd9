"""The statistics that tables of runs print, along the last axis of an array.

Costs of 1e-200 are common, and their squares underflow; so spread is computed on values scaled by
a power of two, which is exact.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError

Vector = NDArray[np.float64]


def best(costs: Vector) -> Vector:
    """Return the least value."""
    return np.asarray(costs.min(axis=-1))


def worst(costs: Vector) -> Vector:
    """Return the greatest value."""
    return np.asarray(costs.max(axis=-1))


def mean(costs: Vector) -> Vector:
    """Return the arithmetic mean; equal values give exactly that value."""
    scaled, exponent = _scaled(costs)
    return _where_equal(costs, costs[..., 0], np.ldexp(scaled.mean(axis=-1), exponent))


def standard_deviation(costs: Vector) -> Vector:
    """Return the sample standard deviation (n-1); equal values give exactly 0.

    It is infinite where a value is. Raises InputError for single values, which have none.
    """
    if costs.shape[-1] < 2:
        message = "a standard deviation needs two runs or more"
        raise InputError(message)
    endless = np.asarray(np.isinf(costs).any(axis=-1))
    if endless.any():
        known = standard_deviation(np.where(endless[..., None], 0.0, costs))
        return np.where(endless, np.inf, known)
    scaled, exponent = _scaled(costs)
    return _where_equal(costs, np.zeros(costs.shape[:-1]), np.ldexp(_spread(scaled), exponent))


def single(costs: Vector) -> Vector:
    """Return the first value: what a paper prints that ran once."""
    return np.asarray(costs[..., 0])


def _spread(values: Vector) -> Vector:
    # values that differ in their last digit have a mean whose rounding is as large as they are
    # apart: the second term takes it out (T. F. Chan, G. H. Golub, R. J. LeVeque, The American
    # Statistician 37 (1983) 242-247)
    n = values.shape[-1]
    away = values - values.mean(axis=-1, keepdims=True)
    squares = (away * away).sum(axis=-1) - away.sum(axis=-1) ** 2 / n
    return np.asarray(np.sqrt(np.maximum(squares, 0.0) / (n - 1)))


def _scaled(costs: Vector) -> tuple[Vector, NDArray[np.int32]]:
    exponent = np.frexp(np.abs(costs).max(axis=-1))[1]
    return np.ldexp(costs, -exponent[..., None]), exponent


def _where_equal(costs: Vector, then: Vector, otherwise: Vector) -> Vector:
    # 30 values of 1.1 have a rounded mean that is not 1.1 and a spread that is not 0
    return np.where(costs.min(axis=-1) == costs.max(axis=-1), then, otherwise)


STATISTICS: Mapping[str, Callable[[Vector], Vector]] = MappingProxyType(
    {"best": best, "worst": worst, "mean": mean, "std": standard_deviation, "single": single}
)
"""By the name under which papers print them."""
