"""How often one sample is below another, and how far resampling moves that."""

import numpy as np
from numpy.typing import NDArray

from repro.statistics.tables import quantile_interval

Vector = NDArray[np.float64]
RESAMPLES = 1000  # its 2.5 % tail then holds 25 of them


def win_probability(x: Vector, y: Vector) -> float:
    """Return P(X < Y) + P(X = Y) / 2: how often x is the lower, ties counted as half.

    A. Vargha, H. D. Delaney, Journal of Educational and Behavioral Statistics 25 (2000) 101-132;
    their A12 for costs, of which the lower is the better. Equal samples give exactly 0.5.
    """
    from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

    n, m = len(x), len(y)
    ranks = rankdata(np.concatenate([x, y]))
    return float(1.0 - (ranks[:n].sum() - n * (n + 1) / 2) / (n * m))


def win_interval(
    x: Vector, y: Vector, *, rng: np.random.Generator, level: float = 0.95
) -> tuple[float, float]:
    """Return the percentile bootstrap interval of `win_probability`.

    Both samples are resampled with replacement (B. Efron, Annals of Statistics 7 (1979) 1-26). It
    needs the order of the values alone. Samples that do not overlap give (0, 0) or (1, 1), equal
    constant ones (0.5, 0.5): what was never seen cannot be resampled.
    """
    wins = (x[:, None] < y) + 0.5 * (x[:, None] == y)
    own, other = (_times_drawn(n, rng) for n in wins.shape)
    draws = ((own @ wins) * other).sum(axis=1) / wins.size
    return quantile_interval(draws, level)


def _times_drawn(n: int, rng: np.random.Generator) -> Vector:
    """Return how often each of n values is in each resample, shape (RESAMPLES, n)."""
    picks = rng.integers(0, n, size=(RESAMPLES, n)) + n * np.arange(RESAMPLES)[:, None]
    counts = np.bincount(picks.ravel(), minlength=RESAMPLES * n)
    return counts.reshape(RESAMPLES, n).astype(np.float64)
