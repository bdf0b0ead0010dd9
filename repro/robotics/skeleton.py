"""An arm as a line through its links: where the links bend, and where the joints turn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.robotics.kinematics import Convention, frames

Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Skeleton:
    """One posture of an arm of n joints, in the base frame.

    `corners` (2n + 1, 3) in m run from the base along every link to the tool: a link follows its
    joint's axis and then the common normal to the next axis (in the modified convention the normal
    first), so its bend stands between the origins of two frames, which are every other corner.
    `joints` (n, 3) in m are points on the joints' axes, `axes` (n, 3) their unit vectors.
    """

    corners: Vector
    joints: Vector
    axes: Vector

    @property
    def origins(self) -> Vector:
        """Origins of all frames from base to tool, shape (n + 1, 3), in m."""
        return self.corners[::2]


def skeleton(dh: ArrayLike, q: ArrayLike, convention: Convention = "standard") -> Skeleton:
    """Return the posture at joint angles `q` (n,) in rad; `dh` as in forward_kinematics."""
    poses = frames(dh, q, convention)
    table = np.atleast_2d(np.asarray(dh, dtype=np.float64))
    origins = poses[:, :3, 3]
    along_x, along_z = table[:, :1], table[:, 2:3]
    if convention == "standard":
        turning = poses[:-1]  # joint i turns about z of the frame before its own
        bends = origins[:-1] + along_z * poses[:-1, :3, 2]
    else:
        turning = poses[1:]
        bends = origins[:-1] + along_x * poses[:-1, :3, 0]
    corners = np.empty((2 * len(table) + 1, 3))
    corners[::2], corners[1::2] = origins, bends
    return Skeleton(corners=corners, joints=turning[:, :3, 3], axes=turning[:, :3, 2])
