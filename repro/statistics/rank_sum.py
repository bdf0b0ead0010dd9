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


def rank_sums(x: Vector, y: Vector) -> tuple[Vector, NDArray[np.bool_]]:
    """Return two-sided p-values, row by row, and whether x ranks lower than y.

    Shapes (rows, n) and (rows, m). By the normal approximation with tie and continuity correction:
    scipy's `mannwhitneyu(method="asymptotic")` to the last bit, in less of its time: ranks
    are summed by ties, and such sums are exact in whatever order.
    """
    from scipy.special import ndtr  # noqa: PLC0415 (slow to load)

    n, m = x.shape[1], y.shape[1]
    own, tied = _ranks_and_ties(np.hstack([x, y]), n)
    wins = own - n * (n + 1) / 2
    size = n + m
    spread = np.sqrt(n * m / 12 * ((size + 1) - tied / (size * (size - 1))))
    with np.errstate(invalid="ignore", divide="ignore"):
        z = (np.maximum(wins, n * m - wins) - n * m / 2 - 0.5) / spread
    # two samples of one and the same value are not different
    p = np.where(np.isnan(z), 1.0, np.minimum(2.0 * ndtr(-z), 1.0))
    return p, wins < 0.5 * n * m


def _ranks_and_ties(values: Vector, n: int) -> tuple[Vector, Vector]:
    """Return row by row the sum of the ranks of the first n, and that of t³ - t over all ties."""
    rows, size = values.shape
    order = np.argsort(values, axis=1)
    ordered = np.take_along_axis(values, order, axis=1)
    begins = np.ones(values.shape, dtype=np.bool_)
    begins[:, 1:] = ordered[:, 1:] != ordered[:, :-1]
    first = np.flatnonzero(begins)
    ties = np.diff(first, append=rows * size)
    of_row = np.searchsorted(first, np.arange(rows) * size)
    before = np.zeros(rows * size + 1, dtype=np.int64)
    np.cumsum(order < n, out=before[1:])
    own = before[first + ties] - before[first]
    # the mean rank of each tie, times two; ranks of earlier rows are taken off below
    twice = np.add.reduceat(own * (2 * first + ties + 1), of_row)
    cubes = np.add.reduceat(ties * (ties * ties - 1), of_row)
    return twice / 2 - n * size * np.arange(rows), cubes.astype(np.float64)


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
