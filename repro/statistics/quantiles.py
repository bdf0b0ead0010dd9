"""Medians, quantiles and success counts of tables of runs, along the last axis."""

from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
QuantileMethod = Literal[
    "inverted_cdf",
    "averaged_inverted_cdf",
    "closest_observation",
    "interpolated_inverted_cdf",
    "hazen",
    "weibull",
    "linear",
    "median_unbiased",
    "normal_unbiased",
]
METHODS: tuple[QuantileMethod, ...] = get_args(QuantileMethod)
"""The nine definitions of a sample's quantile, by numpy's names and in the order of R. J. Hyndman,
Y. Fan, The American Statistician 50 (1996) 361-365, doi:10.1080/00031305.1996.10473566."""


def median(costs: Vector) -> Vector:
    """Return the median; infinite values count as the greatest."""
    return np.asarray(np.median(costs, axis=-1))


def quantile(costs: Vector, share: float, method: QuantileMethod = "linear") -> Vector:
    """Return the value that a share (0 to 1) of the runs does not exceed, by one of `METHODS`.

    Infinite values count as the greatest; a quantile between a finite and an infinite run is
    infinite.
    """
    endless = np.isinf(costs)
    if not endless.any():
        return np.asarray(np.quantile(costs, share, axis=-1, method=method))
    # numpy interpolates between two infinite runs to no number
    known = np.where(endless, np.finfo(np.float64).max, costs)
    weight = np.quantile(endless.astype(np.float64), share, axis=-1, method=method)
    with np.errstate(over="ignore"):
        found = np.quantile(known, share, axis=-1, method=method)
    return np.where(weight > 0.0, np.inf, found)


def interquartile_range(costs: Vector, method: QuantileMethod = "linear") -> Vector:
    """Return the third quartile less the first; infinite where the third is."""
    third, first = (quantile(costs, share, method) for share in (0.75, 0.25))
    endless = np.isinf(third)
    with np.errstate(invalid="ignore"):
        return np.where(endless, np.inf, third - first)


def successes(costs: Vector, threshold: float) -> Vector:
    """Return how many runs end at the threshold or below it."""
    return np.asarray((costs <= threshold).sum(axis=-1, dtype=np.float64))
