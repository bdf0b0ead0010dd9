"""A serial arm whose joints turn or slide, from a D-H table or from any frames in between."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError
from repro.robotics.kinematics import Convention, frames

Vector = NDArray[np.float64]
Kind = Literal["revolute", "prismatic"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """A joint about or along `axis`, a unit vector in the frame that `before` (4, 4) leads to.

    `before` leads there from the frame of the joint before, or from the base; lengths in m.
    """

    name: str
    kind: Kind
    before: tuple[tuple[float, ...], ...]
    axis: tuple[float, float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Chain:
    """Joints from base to tool; `tool` (4, 4) leads from the frame of the last to the tool."""

    joints: tuple[Joint, ...]
    tool: tuple[tuple[float, ...], ...]

    def corners(self, q: Sequence[float]) -> Vector:
        """Return base, origin of every joint, and tool, shape (n + 2, 3), in m.

        `q` is in rad, of prismatic joints in m.
        """
        pose = np.eye(4)
        places = [pose[:3, 3]]
        for joint, value in zip(self.joints, q, strict=True):
            pose = pose @ np.array(joint.before)
            places.append(pose[:3, 3])
            pose = pose @ _moved(joint, float(value))
        places.append((pose @ np.array(self.tool))[:3, 3])
        return np.array(places)


def _moved(joint: Joint, value: float) -> Vector:
    """Return the motion of a joint (4, 4): Rodrigues' rotation, or a shift along its axis."""
    axis = np.array(joint.axis)
    pose = np.eye(4)
    if joint.kind == "prismatic":
        pose[:3, 3] = value * axis
        return pose
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    pose[:3, :3] += np.sin(value) * cross + (1.0 - np.cos(value)) * cross @ cross
    return pose


def from_dh(rows: Sequence[Sequence[float]], kinds: Sequence[str], convention: Convention) -> Chain:
    """Return the chain of a table with rows (a, alpha, d, theta offset), in m and rad.

    A prismatic joint adds to d. Raises InputError for a kind or convention that is unknown.
    """
    for kind in kinds:
        if kind not in get_args(Kind):
            message = f"joint kind {kind!r}: known are {', '.join(get_args(Kind))}"
            raise InputError(message)
    still = [0.0] * len(rows)
    poses = frames(rows, still, convention)
    links = [np.linalg.solve(poses[k], poses[k + 1]) for k in range(len(rows))]
    before, joints = np.eye(4), []
    for k, (kind, link) in enumerate(zip(kinds, links, strict=True)):
        # the joint moves about z: of the frame before its link, or in the modified convention after
        at = before if convention == "standard" else before @ link
        joints.append(
            Joint(
                name=f"joint_{k + 1}",
                kind="prismatic" if kind == "prismatic" else "revolute",
                before=tuple(map(tuple, at.tolist())),
                axis=(0.0, 0.0, 1.0),
            )
        )
        before = link if convention == "standard" else np.eye(4)
    return Chain(joints=tuple(joints), tool=tuple(map(tuple, before.tolist())))
