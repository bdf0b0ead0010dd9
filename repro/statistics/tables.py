"""What a table of n runs may show, by what N stored runs showed."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
ANYWHERE = (-np.inf, np.inf)
DECADE = 10.0  # ratio of greatest to least from which costs are extended by their logarithm
REACH = 2.0
"""Mean excesses by which a new extreme lies beyond many stored runs, on average; where as few are
stored as a table has, twice as much. By the calibration 1 would do for 300 runs and more, but not
for 30, which may lack a kind of run that the next table has."""


def predicted(
    values: Vector,
    statistic: Callable[[Vector], Vector],
    *,
    tables: int,
    rng: np.random.Generator,
    ends: tuple[float, float] = ANYWHERE,
) -> Vector:
    """Return the statistic of tables that may come next, shape (tables,); see `next_tables`."""
    return statistic(next_tables(values, tables=tables, rng=rng, ends=ends))


def next_tables(
    values: Vector, *, tables: int, rng: np.random.Generator, ends: tuple[float, float] = ANYWHERE
) -> Vector:
    """Return tables of n runs that may come after N stored ones, shape (tables, n).

    `values` has shape (repeats, n): every repeat of the protocol. A new run falls into each of the
    N + 1 gaps that stored runs leave with the same chance (B. M. Hill, Journal of the American
    Statistical Association 63 (1968) 677-691, doi:10.1080/01621459.1968.11009286), and n runs of
    one table share what is not known of these chances (Pólya's urn; A. Y. Lo, Annals of Statistics
    16 (1988) 1684-1695, doi:10.1214/aos/1176351061). So both samples count, theirs of n and ours of
    N: a mean varies by √(1/n + 1/N), and a new best or worst lies beyond all stored runs with
    chance n/(N + n), whatever the distribution. Between two stored runs one of the two is taken;
    beyond the last ones see `_beyond`. No new value lies outside `ends`, unless stored ones do.
    """
    falls = falls_among(values.size, values.shape[-1], tables=tables, rng=rng)
    return tables_of(values, falls, ends=ends)


@dataclass(frozen=True, slots=True, kw_only=True)
class Falls:
    """Where the runs of tables fall among stored ones, whatever these are; see `next_tables`.

    `nearest`, shape (tables, n), is the position of the stored run that is taken; `below` and
    `above` say which lie beyond all, `down` and `up` by how many mean excesses.
    """

    nearest: NDArray[np.intp]
    below: NDArray[np.bool_]
    above: NDArray[np.bool_]
    down: Vector
    up: Vector


def falls_among(size: int, n: int, *, tables: int, rng: np.random.Generator) -> Falls:
    """Return where n runs of each table fall among so many stored ones."""
    place = np.empty((n, tables), dtype=np.intp)  # 0 below all stored, size above all
    rows = np.arange(tables)
    for k in range(n):
        # Pólya's urn: one ball per gap, and one more of the gap that each run before fell into
        ball = rng.integers(0, size + 1 + k, size=tables)
        place[k] = ball
        again = np.flatnonzero(ball > size)
        place[k, again] = place[ball[again] - size - 1, rows[again]]
    place = place.T
    upper = rng.random((tables, n)) < 0.5
    nearest = np.clip(place - 1 + upper, 0, size - 1)
    steps = rng.standard_exponential((tables, n))
    reach = REACH * (1.0 + n / size)
    below, above = place == 0, place >= size
    return Falls(
        nearest=nearest,
        below=below,
        above=above,
        down=steps[below] * reach,
        up=steps[above] * reach,
    )


def tables_of(values: Vector, falls: Falls, *, ends: tuple[float, float] = ANYWHERE) -> Vector:
    """Return the tables whose runs fall so among the stored ones, `values`."""
    stored = np.sort(values, axis=None).astype(np.float64)
    found = stored[falls.nearest]
    low, high = _beyond(stored, falls.down, falls.up, ends[0])
    high = np.minimum(high, max(ends[1], stored[-1]))
    found[falls.below] = low
    found[falls.above] = high
    return np.asarray(found)


def _beyond(stored: Vector, below: Vector, above: Vector, floor: float) -> tuple[Vector, Vector]:
    """Return runs below the least and above the greatest stored one, by so many mean excesses.

    The excess over an extreme is taken as exponential, with the mean excess of the stored runs
    beyond their median, times `REACH` (1 + n/N), which `below` and `above` hold: of the logarithm
    of the distance from the floor (from 0, where none is known), where distances span a decade or
    more. One run says nothing of how far others lie, and beyond infinity there is nothing.
    """
    finite = stored[np.isfinite(stored)]
    least = min(max(floor, 0.0) if stored[0] >= 0.0 else floor, stored[0])
    if finite.size < 2:
        return np.full(below.shape, least), np.full(above.shape, np.inf)
    base = floor if np.isfinite(floor) and stored[0] >= floor else 0.0
    away = finite - base
    if away[0] >= 0.0 and away[-1] > DECADE * away[0]:
        powers = np.log(np.maximum(away, away[away > 0.0][0]))
        low, high = _excesses(powers, below, above)
        with np.errstate(over="ignore"):
            low = np.exp(low) * (away[0] > 0.0) + base
            # a spread of infinite costs would be no number
            high = np.minimum(np.exp(high) + base, np.finfo(np.float64).max)
    else:
        low, high = _excesses(finite, below, above)
    # the exponential of a logarithm may round to the inner side
    low, high = np.clip(low, least, stored[0]), np.maximum(high, finite[-1])
    return low, high if stored[-1] < np.inf else np.full(above.shape, np.inf)


def _excesses(values: Vector, below: Vector, above: Vector) -> tuple[Vector, Vector]:
    half = values.size // 2
    middle = float(np.median(values))
    # differences first: equal values have a rounded mean, but no excess
    down, up = (middle - values[:half]).mean(), (values[-half:] - middle).mean()
    return values[0] - down * below, values[-1] + up * above


def half_equal(values: Vector) -> bool:
    """Return whether half of all runs or more have one and the same value."""
    ordered = np.sort(values, axis=None)
    half = (ordered.size + 1) // 2
    return bool((ordered[half - 1 :] == ordered[: ordered.size - half + 1]).any())


def quantile_interval(draws: Vector, level: float) -> tuple[float, float]:
    """Return the central interval of `draws` that holds `level` of them, ends being draws."""
    tail, last = (1.0 - level) / 2.0, len(draws) - 1
    ordered = np.sort(draws)
    if np.isnan(ordered[-1]):
        return np.nan, np.nan
    return float(ordered[int(last * tail)]), float(ordered[math.ceil(last * (1.0 - tail))])
