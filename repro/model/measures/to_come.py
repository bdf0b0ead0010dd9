"""Tables that may come next, under the name of what they are of: the same whenever asked for."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.statistics.tables import ANYWHERE, Falls, falls_among, tables_of

Vector = NDArray[np.float64]
_KEPT = 64  # cells: one claim may ask for some twenty, under each of many readings
_LARGE = 1 << 18  # runs of all tables, from which they are drawn each time rather than kept


def tables_to_come(
    values: Vector, *name: str, tables: int, ends: tuple[float, float] = ANYWHERE
) -> Vector:
    """Return tables that may come after stored runs, shape (tables, n); see `next_tables`.

    Readings of one cell share its random numbers: their tables fall alike among other runs.
    """
    size, n = values.size, values.shape[-1]
    falls = _falls if tables * n < _LARGE else _falls.__wrapped__
    return tables_of(values, falls(name, size, n, tables), ends=ends)


@lru_cache(maxsize=_KEPT)
def _falls(name: tuple[str, ...], size: int, n: int, tables: int) -> Falls:
    return falls_among(size, n, tables=tables, rng=generator("tables", *name))
