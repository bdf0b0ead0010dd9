"""Any chain of joints as a line through its links, posture by posture."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.robotics.chain import Chain
from repro.robotics.skeleton import Skeleton

Vector = NDArray[np.float64]
UP = np.array([0.0, 0.0, 1.0])
NONE = 1e-9  # m: what rounding leaves of a length along a line that is at right angles to it


@dataclass(frozen=True, slots=True, kw_only=True)
class Line:
    """A point of a joint's axis, in m, and the axis as a unit vector, both in the base frame."""

    place: Vector
    axis: Vector

    def foot(self, place: Vector) -> Vector:
        """Return the point of the line that is nearest to a place."""
        return np.asarray(self.place + (place - self.place) @ self.axis * self.axis)


def postures(chain: Chain, angles: Vector) -> tuple[Skeleton, ...]:
    """Return the skeletons of a chain at joint values (n, joints) in rad, m where they slide.

    Corners run from the base to the tool by the origin of every joint, the end of its slide, and
    the bend of the link behind it.
    """
    ahead = [_ahead(chain, k) for k in range(len(chain.joints))]
    return tuple(_skeleton(chain, ahead, q) for q in angles)


def _ahead(chain: Chain, k: int) -> Chain:
    """Return the chain whose tool is on the axis of joint k, 1 m along it."""
    before = np.array(chain.joints[k].before)
    before[:3, 3] += before[:3, :3] @ np.array(chain.joints[k].axis)
    return Chain(joints=chain.joints[:k], tool=tuple(map(tuple, before.tolist())))


def _skeleton(chain: Chain, ahead: Sequence[Chain], q: Vector) -> Skeleton:
    base, *origins, tool = chain.corners(q.tolist())
    axes = [each.corners(q[:k].tolist())[-1] - origins[k] for k, each in enumerate(ahead)]
    corners = [base]
    before = Line(place=base, axis=UP)
    for joint, value, place, axis in zip(chain.joints, q, origins, axes, strict=True):
        slid = place + value * axis if joint.kind == "prismatic" else place
        corners += [_bend(corners[-1], before, place, Line(place=place, axis=axis)), place, slid]
        before = Line(place=slid, axis=axis)
    corners += [before.foot(tool), tool]
    return Skeleton(corners=np.array(corners), joints=np.array(origins), axes=np.array(axes))


def _bend(start: Vector, before: Line, end: Vector, after: Line) -> Vector:
    """Return where a link bends: at the foot of the common normal of its axes, if that is known.

    In a D-H table one end of each link stands on it; parallel axes have many, of which the one at
    `end` is drawn. Where neither end stands on one a link is straight.
    """
    for foot, across in ((before.foot(end), after), (after.foot(start), before)):
        far = end if across is after else start
        if abs((foot - far) @ across.axis) < NONE:
            return foot
    return start
