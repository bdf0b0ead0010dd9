"""What a table of n runs may show, by what N stored runs showed."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
DECADE = 10.0  # ratio of greatest to least from which costs are extended by their logarithm
REACH = 2.0
"""Mean excesses by which a new extreme lies beyond the stored one, on average. By the calibration
300 stored runs and more contradict less than 1 % of true values, 30 some 2.5 % of means and 3 % of
standard deviations. Twice as much would change little: what 30 miss is a kind of run they lack."""


def predicted(
    values: Vector,
    statistic: Callable[[Vector], Vector],
    *,
    tables: int,
    rng: np.random.Generator,
    floor: float = -np.inf,
) -> Vector:
    """Return the statistic of tables that may come next, shape (tables,); see `next_tables`."""
    return statistic(next_tables(values, tables=tables, rng=rng, floor=floor))


def next_tables(
    values: Vector, *, tables: int, rng: np.random.Generator, floor: float = -np.inf
) -> Vector:
    """Return tables of n runs that may come after N stored ones, shape (tables, n).

    `values` has shape (repeats, n): every repeat of the protocol. A new run falls into each of the
    N + 1 gaps that stored runs leave with the same chance (B. M. Hill, Journal of the American
    Statistical Association 63 (1968) 677-691, doi:10.1080/01621459.1968.11009286), and n runs of
    one table share what is not known of these chances (D. B. Rubin, Annals of Statistics 9 (1981)
    130-134, doi:10.1214/aos/1176345338). So both samples count, theirs of n and ours of N: a mean
    varies by √(1/n + 1/N), and a new best or worst lies beyond all stored runs with chance
    n/(N + n), whatever the distribution. Between two stored runs one of the two is taken; beyond
    the last ones see `_beyond`. No new value is below `floor`, unless stored ones are.
    """
    stored = np.sort(values, axis=None)
    size, n = stored.size, values.shape[-1]
    gaps = rng.standard_exponential((tables, size + 1))
    edges = np.cumsum(gaps, axis=1)
    edges /= edges[:, -1:]
    # one search for all tables: the edges of table k lie between k and k + 1
    rows = np.arange(tables)[:, None]
    where = np.searchsorted((edges + rows).ravel(), (rng.random((tables, n)) + rows).ravel())
    place = where.reshape(tables, n) - rows * (size + 1)  # 0 below all stored, size above all
    up = rng.random((tables, n)) < 0.5
    found = stored[np.clip(place - 1 + up, 0, size - 1)]
    steps = rng.standard_exponential((tables, n))
    low, high = _beyond(stored, steps[place == 0], steps[place >= size], floor)
    found[place == 0] = low
    found[place >= size] = high
    return np.asarray(found)


def _beyond(stored: Vector, below: Vector, above: Vector, floor: float) -> tuple[Vector, Vector]:
    """Return runs below the least and above the greatest stored one, by so many mean excesses.

    The excess over an extreme is taken as exponential, with `REACH` times the mean excess of the
    stored runs beyond their median: of the logarithm of the distance from the floor (from 0, where
    none is known), where distances span a decade or more. One run says nothing of how far others
    lie.
    """
    if stored.size < 2:
        return np.full(below.shape, floor), np.full(above.shape, np.inf)
    base = floor if np.isfinite(floor) and stored[0] >= floor else 0.0
    away = stored - base
    if away[0] >= 0.0 and away[-1] > DECADE * away[0]:
        powers = np.log(np.maximum(away, away[away > 0.0][0]))
        low, high = _excesses(powers, below, above)
        with np.errstate(over="ignore"):
            least = base + (np.exp(low) if away[0] > 0.0 else 0.0 * below)
            # a spread of infinite costs would be no number
            greatest = np.minimum(base + np.exp(high), np.finfo(np.float64).max)
        # the exponential of a logarithm may round to the inner side
        return np.minimum(least, stored[0]), np.maximum(greatest, stored[-1])
    low, high = _excesses(stored, below, above)
    return np.maximum(low, min(floor, stored[0])), high


def _excesses(values: Vector, below: Vector, above: Vector) -> tuple[Vector, Vector]:
    half = max(values.size // 2, 1)
    middle = float(np.median(values))
    # differences first: equal values have a rounded mean, but no excess
    down, up = (middle - values[:half]).mean(), (values[-half:] - middle).mean()
    return values[0] - REACH * down * below, values[-1] + REACH * up * above


def quantile_interval(draws: Vector, level: float) -> tuple[float, float]:
    """Return the central interval of `draws` that holds `level` of them, ends being draws."""
    tail = (1.0 - level) / 2.0
    low = np.quantile(draws, tail, method="lower")
    high = np.quantile(draws, 1.0 - tail, method="higher")
    return float(low), float(high)
