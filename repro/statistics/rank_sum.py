"""The rank-sum test as the papers use it, and the correction for several tests."""

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
SMALL = 20  # values in both samples together, from which MATLAB's `ranksum` approximates


def rank_sum_p(x: Vector, y: Vector) -> float:
    """Return the two-sided p-value of Wilcoxon's rank-sum test of two samples.

    Exact for fewer than 20 untied values in all, where MATLAB's `ranksum` is exact by default;
    otherwise the normal approximation with tie and continuity correction, which is what `ranksum`
    gives for larger samples. Two samples of one and the same value are not different: p = 1.
    """
    from scipy.stats import mannwhitneyu  # noqa: PLC0415 (slow to load)

    values = np.concatenate([x, y])
    if np.ptp(values) == 0.0:
        return 1.0
    untied = len(np.unique(values)) == len(values)
    method = "exact" if untied and len(values) < SMALL else "asymptotic"
    return float(mannwhitneyu(x, y, method=method, use_continuity=True).pvalue)


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
