"""The rank-sum test as the papers use it, its correction, and an effect size."""

import numpy as np
from numpy.typing import NDArray
from scipy.stats import mannwhitneyu, rankdata

Vector = NDArray[np.float64]


def rank_sum_p(x: Vector, y: Vector) -> float:
    """Return the two-sided p-value of Wilcoxon's rank-sum test of two samples.

    The normal approximation with tie and continuity correction, as MATLAB's `ranksum` gives it
    for more than ten values. Two samples of one and the same value are not different: p = 1.
    """
    if np.ptp(np.concatenate([x, y])) == 0.0:
        return 1.0
    return float(mannwhitneyu(x, y, method="asymptotic", use_continuity=True).pvalue)


def holm(p_values: Vector) -> Vector:
    """Return p-values corrected for their number, in the given order.

    S. Holm, Scandinavian Journal of Statistics 6 (1979) 65-70.
    """
    p = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(p, kind="stable")
    stepped = np.maximum.accumulate((len(p) - np.arange(len(p))) * p[order])
    corrected = np.empty(len(p))
    corrected[order] = np.minimum(stepped, 1.0)
    return corrected


def win_probability(x: Vector, y: Vector) -> float:
    """Return P(X < Y) + P(X = Y) / 2: how often x is the lower, ties counted as half.

    A. Vargha, H. D. Delaney, Journal of Educational and Behavioral Statistics 25 (2000) 101-132.
    """
    n, m = len(x), len(y)
    ranks = rankdata(np.concatenate([x, y]))
    return float(1.0 - (ranks[:n].sum() - n * (n + 1) / 2) / (n * m))
