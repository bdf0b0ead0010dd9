"""How much a table of n runs varies by itself."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


def resampled(
    values: Vector, statistic: Callable[[Vector], Vector], *, tables: int, rng: np.random.Generator
) -> Vector:
    """Return the statistic of tables drawn with replacement from all runs, shape (tables,).

    `values` has shape (repeats, n): every repeat of the protocol; each drawn table has n runs
    (B. Efron, Annals of Statistics 7 (1979) 1-26, doi:10.1214/aos/1176344552).
    """
    pool = values.ravel()
    picks = rng.integers(0, pool.size, size=(tables, values.shape[-1]))
    return statistic(pool[picks])


def quantile_interval(draws: Vector, level: float) -> tuple[float, float]:
    """Return the central interval of `draws` that holds `level` of them, ends being draws."""
    tail = (1.0 - level) / 2.0
    low = np.quantile(draws, tail, method="lower")
    high = np.quantile(draws, 1.0 - tail, method="higher")
    return float(low), float(high)
