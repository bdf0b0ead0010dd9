"""The one-sided test of paired samples."""

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
EXACT = 50  # pairs, below which R's `wilcox.test` is exact


def signed_rank_p(differences: Vector) -> float:
    """Return the p-value of Wilcoxon's signed-rank test that paired differences are above zero.

    Differences of exactly 0 are left out, as Wilcoxon and R do; where nothing is left, p = 1. Exact
    for fewer than 50 pairs of different sizes without zeros, otherwise the normal approximation
    with tie and continuity correction: the choice of R's `wilcox.test`.
    """
    from scipy.stats import wilcoxon  # noqa: PLC0415 (slow to load)

    left = differences[differences != 0.0]
    if not left.size:
        return 1.0
    untied = len(np.unique(np.abs(left))) == len(left) == len(differences)
    method = "exact" if untied and len(left) < EXACT else "asymptotic"
    found = wilcoxon(left, alternative="greater", method=method, correction=True)
    return float(found.pvalue)
