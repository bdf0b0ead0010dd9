"""Average ranks over several problems, whether they differ at all, and by how much they must.

J. Demšar, Statistical comparisons of classifiers over multiple data sets, Journal of Machine
Learning Research 7 (2006) 1-30.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError

Vector = NDArray[np.float64]
LEVEL = 0.05


@dataclass(frozen=True, slots=True, kw_only=True)
class Friedman:
    """Average ranks (algorithms,), 1 for the lowest, and the test that they are all equal.

    Two algorithms whose average ranks are less than `critical_difference` apart are not told apart
    by Nemenyi's test at the 5 % level.
    """

    ranks: tuple[float, ...]
    p: float
    critical_difference: float
    problems: int


def friedman(values: Vector) -> Friedman:
    """Return average ranks, Friedman's p and Nemenyi's critical difference.

    `values` has shape (problems, algorithms); ties share the mean of their ranks. Where every
    problem has all algorithms tied, p = 1. InputError for fewer than two problems or three
    algorithms, which have no such test.
    """
    from scipy.stats import friedmanchisquare, rankdata  # noqa: PLC0415 (slow to load)

    problems, algorithms = values.shape
    if problems < 2 or algorithms < 3:
        message = f"Friedman's test needs 2 problems and 3 algorithms, not {values.shape}"
        raise InputError(message)
    ranks = rankdata(values, axis=1)
    tied = bool((ranks == ranks[:, :1]).all())
    return Friedman(
        ranks=tuple(float(rank) for rank in ranks.mean(axis=0)),
        p=1.0 if tied else float(friedmanchisquare(*values.T).pvalue),
        critical_difference=critical_difference(algorithms, problems),
        problems=problems,
    )


def critical_difference(algorithms: int, problems: int, level: float = LEVEL) -> float:
    """Return the least difference of average ranks that Nemenyi's test takes for one."""
    from scipy.stats import studentized_range  # noqa: PLC0415 (slow to load)

    q = float(studentized_range.ppf(1.0 - level, algorithms, np.inf)) / math.sqrt(2.0)
    return q * math.sqrt(algorithms * (algorithms + 1) / (6.0 * problems))


def not_told_apart(ranks: tuple[float, ...], difference: float) -> tuple[tuple[int, ...], ...]:
    """Return the largest groups of two or more whose ranks lie less than `difference` apart.

    Each group holds positions in `ranks`, from the lowest rank to the highest.
    """
    order = sorted(range(len(ranks)), key=lambda k: ranks[k])
    groups: list[tuple[int, ...]] = []
    for start, first in enumerate(order):
        group = tuple(k for k in order[start:] if ranks[k] - ranks[first] < difference)
        if len(group) > 1 and not (groups and set(group) <= set(groups[-1])):
            groups.append(group)
    return tuple(groups)
