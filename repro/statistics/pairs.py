"""The signed-rank test as tables of results print it: two-sided, by the normal approximation."""

import math

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


def paired_p(differences: Vector) -> tuple[float, bool]:
    """Return the two-sided p-value of Wilcoxon's signed-rank test, and whether they rank below 0.

    The normal approximation with tie and continuity correction, differences of exactly 0 left out;
    where nothing is left, p = 1.
    """
    left = differences[differences != 0.0]
    if not left.size:
        return 1.0, False
    _, position, ties = np.unique(np.abs(left), return_inverse=True, return_counts=True)
    ranks = (np.cumsum(ties) - 0.5 * (ties - 1))[position]
    above = float(ranks[left > 0.0].sum())
    middle, deviation = left.size * (left.size + 1) / 4, math.sqrt((ranks * ranks).sum() / 4)
    z = max(abs(above - middle) - 0.5, 0.0) / deviation
    return math.erfc(z / math.sqrt(2.0)), above < middle
