"""The lengths and twists of an arm that no convention changes."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.robotics.kinematics import Convention, DHRow

Vector = NDArray[np.float64]
PARALLEL = 0.01  # rad: a printed 1.57 is a right angle, and 3.14 none at all


@dataclass(frozen=True, slots=True, kw_only=True)
class LinkLengths:
    """`twists` (n - 1,) are the angles between neighbouring axes as lines, 0 to π/2, in rad.

    `lengths` in m by name: how far neighbouring axes are apart, and how far their common normals
    are apart along each axis; along axes that are parallel only the sum has a meaning.
    """

    twists: tuple[float, ...]
    lengths: dict[str, float]


def link_lengths(dh: Sequence[DHRow], convention: Convention = "standard") -> LinkLengths:
    """Return what a table's lengths mean, in m; rows (a, alpha, d) as in forward_kinematics."""
    a, alpha, d = (np.array(column) for column in zip(*(row[:3] for row in dh), strict=True))
    if convention == "modified":  # its row k says how axis k - 1 leads to axis k
        a, alpha = np.append(a[1:], 0.0), np.append(alpha[1:], 0.0)
    n = len(d)
    turned = np.abs(np.arctan2(np.abs(np.sin(alpha)), np.abs(np.cos(alpha))))[: n - 1]
    lengths = {}
    for first, last in _parallel(turned, n):
        flips = np.cumprod([1.0, *np.sign(np.cos(alpha[first:last]))])
        total = float(abs((d[first : last + 1] * flips).sum()))
        axes = f"axis {first + 1}" if first == last else f"axes {first + 1} to {last + 1}"
        lengths[f"along {axes}"] = total
        for k in range(first, min(last + 1, n - 1)):
            lengths[f"between axes {k + 1} and {k + 2}"] = float(abs(a[k]))
    return LinkLengths(twists=tuple(turned.tolist()), lengths=lengths)


def _parallel(twists: Vector, n: int) -> list[tuple[int, int]]:
    """Return first and last axis of each run of parallel ones, from 0."""
    runs, first = [], 0
    for k in range(n):
        if k == n - 1 or twists[k] > PARALLEL:
            runs.append((first, k))
            first = k + 1
    return runs
