"""Where every part of an arm is in many postures at once."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.robotics.kinematics import Convention

Vector = NDArray[np.float64]


def corners_along(
    dh: ArrayLike, angles: ArrayLike, convention: Convention = "standard"
) -> NDArray[np.float64]:
    """Return the corners of the arm's skeleton in many postures, (n, 2 joints + 1, 3), in m.

    `angles` (n, joints) in rad; `dh` as in forward_kinematics. They are those of
    `skeleton(dh, q, convention).corners` for every row q.
    """
    table = np.atleast_2d(np.asarray(dh, dtype=np.float64))
    q = np.atleast_2d(np.asarray(angles, dtype=np.float64))
    turned = np.tile(np.eye(3), (len(q), 1, 1))
    corners = np.zeros((len(q), 2 * len(table) + 1, 3))
    for k, (row, theta) in enumerate(zip(table, q.T, strict=True)):
        a, alpha, d = row[:3]
        about_z = _turn_z(theta + (row[3] if len(row) == 4 else 0.0))
        about_x = _turn_x(alpha)
        before = corners[:, 2 * k]
        if convention == "standard":
            corners[:, 2 * k + 1] = before + d * turned[:, :, 2]
            turned = turned @ about_z
            corners[:, 2 * k + 2] = corners[:, 2 * k + 1] + a * turned[:, :, 0]
            turned = turned @ about_x
        else:
            corners[:, 2 * k + 1] = before + a * turned[:, :, 0]
            turned = turned @ about_x
            corners[:, 2 * k + 2] = corners[:, 2 * k + 1] + d * turned[:, :, 2]
            turned = turned @ about_z
    return corners


def _turn_z(theta: Vector) -> Vector:
    c, s, none, one = np.cos(theta), np.sin(theta), np.zeros_like(theta), np.ones_like(theta)
    rows = [[c, -s, none], [s, c, none], [none, none, one]]
    return np.moveaxis(np.array(rows), 2, 0)


def _turn_x(alpha: float) -> Vector:
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


@dataclass(frozen=True, slots=True, kw_only=True)
class Below:
    """For how long something is below a height, in s, and its least value, `at` some s."""

    lasting: float
    least: float
    at: float


def below(times: Vector, values: Vector, level: float = 0.0) -> Below:
    """Return how long samples (n,) of a curve are below a level, with crossings in between.

    Between two samples the curve is taken for straight.
    """
    before, after = values[:-1] - level, values[1:] - level
    under = np.maximum(-before, 0.0) + np.maximum(-after, 0.0)
    whole = np.abs(before) + np.abs(after)
    share = np.where((before < 0) & (after < 0), 1.0, under / np.where(whole > 0, whole, 1.0))
    lowest = int(values.argmin())
    return Below(
        lasting=float((share * np.diff(times)).sum()),
        least=float(values[lowest]),
        at=float(times[lowest]),
    )
