"""Forward kinematics of serial arms from Denavit-Hartenberg parameters.

Standard convention: J. Denavit, R. S. Hartenberg, Journal of Applied Mechanics 22 (1955) 215-221.
Modified convention: J. J. Craig, Introduction to Robotics, 3rd edition, section 3.4.
"""

import math
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.errors import InputError

Convention = Literal["standard", "modified"]
DHRow = tuple[float, float, float]


def dh_rows(
    *, a: tuple[float, ...], alpha: tuple[float, ...], d: tuple[float, ...]
) -> tuple[DHRow, ...]:
    """Return one (a [m], alpha [rad], d [m]) per joint."""
    return tuple(zip(a, alpha, d, strict=True))


def forward_kinematics(
    dh: ArrayLike, q: ArrayLike, convention: Convention = "standard"
) -> NDArray[np.float64]:
    """Return the 4x4 pose of the last frame in the base frame, in metres.

    `dh` has one row (a, alpha, d) per joint, lengths in m and angles in rad; a fourth entry, where
    given, is added to the joint angle. `q` holds the n joint angles in rad. Raises InputError for
    other shapes or an unknown convention.
    """
    return np.asarray(frames(dh, q, convention)[-1])


def frames(dh: ArrayLike, q: ArrayLike, convention: Convention = "standard") -> NDArray[np.float64]:
    """Return the poses of all frames in the base frame, the base among them, (n + 1, 4, 4).

    Arguments and errors are those of forward_kinematics.
    """
    table = np.atleast_2d(np.asarray(dh, dtype=np.float64))
    angles = np.asarray(q, dtype=np.float64)
    if table.shape[1] not in (3, 4) or angles.shape != (len(table),):
        message = (
            f"D-H rows of shape {table.shape} and angles of shape {angles.shape} do not fit: "
            "give (n, 3) or (n, 4) and (n,)"
        )
        raise InputError(message)
    if convention not in get_args(Convention):
        message = f"unknown convention {convention!r}; known: {', '.join(get_args(Convention))}"
        raise InputError(message)
    link = _standard if convention == "standard" else _modified
    poses = [np.eye(4)]
    for row, angle in zip(table, angles, strict=True):
        offset = row[3] if len(row) == 4 else 0.0
        poses.append(poses[-1] @ link(row[0], row[1], row[2], angle + offset))
    return np.array(poses)


def _standard(a: float, alpha: float, d: float, theta: float) -> NDArray[np.float64]:
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


def _modified(a: float, alpha: float, d: float, theta: float) -> NDArray[np.float64]:
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array(
        [
            [c, -s, 0, a],
            [s * ca, c * ca, -sa, -d * sa],
            [s * sa, c * sa, ca, d * ca],
            [0, 0, 0, 1],
        ]
    )


def tool_coordinate(
    dh: ArrayLike, q: ArrayLike, axis: str, convention: Convention = "standard"
) -> float:
    """Return x, y or z of the last frame's origin in the base frame, in m."""
    return float(forward_kinematics(dh, q, convention)["xyz".index(axis), 3])
