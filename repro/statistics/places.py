"""The place of one value among others, 1 for the lowest, with ties shared in the usual ways."""

from collections.abc import Sequence
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
Ties = Literal["min", "average", "dense", "ordinal"]
TIES: tuple[Ties, ...] = get_args(Ties)
"""Equal values share the lowest of their places (1, 2, 2, 4), the mean of them (1, 2.5, 2.5, 4),
or one place with no gap after it (1, 2, 2, 3); or they stand in the order in which they are listed
(1, 2, 3, 4)."""


def place(values: Sequence[Vector], own: int, ties: Ties = "min") -> Vector:
    """Return the place of `values[own]` among all of `values`, element by element."""
    table = np.stack(np.broadcast_arrays(*values)).astype(np.float64)
    mine = table[own]
    if ties == "dense":
        ordered = np.sort(table, axis=0)
        new = np.concatenate([np.ones((1, *mine.shape), bool), ordered[1:] != ordered[:-1]])
        return np.asarray(1.0 + (new & (ordered < mine)).sum(axis=0))
    lower = (table < mine).sum(axis=0)
    if ties == "average":
        return np.asarray(1.0 + lower + 0.5 * ((table == mine).sum(axis=0) - 1))
    if ties == "ordinal":
        return np.asarray(1.0 + lower + (table[:own] == mine).sum(axis=0))
    return np.asarray(1.0 + lower)
