"""Where the axes of a serial arm lie, and how many ways its last frame can move."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.robotics.kinematics import Convention, forward_kinematics

Vector = NDArray[np.float64]
SINGULAR = 1e-9  # share of the largest singular value; rounding leaves about 1e-16


def jacobian(dh: ArrayLike, q: ArrayLike, convention: Convention = "standard") -> Vector:
    """Return the geometric Jacobian of the last frame's origin, shape (6, n).

    Rows 1 to 3 are its velocity in m/s, 4 to 6 the angular velocity in rad/s, per rad/s of each
    joint (B. Siciliano et al., Robotics: Modelling, Planning and Control, Springer 2009,
    section 3.1). Joint k turns about z of frame k - 1 in the standard convention, about z of
    frame k in the modified one.
    """
    rows, angles = np.atleast_2d(np.asarray(dh)), np.asarray(q)
    frames = [forward_kinematics(rows[:k], angles[:k], convention) for k in range(1, len(rows) + 1)]
    tool = forward_kinematics(rows, angles, convention)[:3, 3]
    carrying = [np.eye(4), *frames[:-1]] if convention == "standard" else frames
    columns = [
        np.concatenate([np.cross(frame[:3, 2], tool - frame[:3, 3]), frame[:3, 2]])
        for frame in carrying
    ]
    return np.array(columns).T


def freedoms(dh: ArrayLike, q: ArrayLike, convention: Convention = "standard") -> int:
    """Return in how many independent ways the last frame can move from the posture `q`."""
    sizes = np.linalg.svd(jacobian(dh, q, convention), compute_uv=False)
    return int(np.count_nonzero(sizes > SINGULAR * sizes[0]))
