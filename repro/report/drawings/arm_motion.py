"""An arm's motions, sampled: what the view of the robot and its still show."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.model.arm_motions import course, durations_of, led_through, limits_of
from repro.model.figures import Arm, ArmMotion
from repro.robotics.rest_to_rest import DERIVATIVES
from repro.robotics.skeleton import Skeleton, skeleton

Vector = NDArray[np.float64]
SAMPLES = 200  # of a motion at most: a page stays small and no step is seen


@dataclass(frozen=True, slots=True, kw_only=True)
class Moving:
    """One motion of an arm: its postures at `times` (n,) in s, and the `durations` in s.

    `angles` (n, joints) are in rad, of a joint that slides in m; `shares` (n, kinds, joints) say
    how much of its limits on velocity, acceleration and jerk each joint uses, 1 being all. Both
    may be None, and are then not shown.
    """

    name: str
    durations: tuple[float, ...]
    times: Vector
    postures: tuple[Skeleton, ...]
    angles: Vector | None = None
    shares: Vector | None = None

    @property
    def total(self) -> float:
        """Time of the whole motion in s."""
        return float(self.times[-1])

    @property
    def tool(self) -> Vector:
        """Places of the tool, shape (n, 3), in m."""
        return np.array([posture.corners[-1] for posture in self.postures])

    @property
    def length(self) -> float:
        """How far the tool travels, in m, along the chords between the samples."""
        return float(np.linalg.norm(np.diff(self.tool, axis=0), axis=1).sum())

    def nearest(self) -> list[tuple[int, int, float]]:
        """Return at each time the kind (0 velocity), joint (from 0) and share that is greatest."""
        if self.shares is None:
            return []
        _, kinds, joints = self.shares.shape
        flat = self.shares.reshape(len(self.times), kinds * joints)
        return [
            (*divmod(k, joints), float(row[k]))
            for row, k in zip(flat, flat.argmax(axis=1).tolist(), strict=True)
        ]


def moving(arm: Arm) -> tuple[Moving, ...]:
    """Return every motion of the figure, sampled; NotProvedError where an optimum is not proved."""
    return tuple(_moving(arm, motion) for motion in arm.motions)


def waypoints(arm: Arm) -> tuple[Skeleton, ...]:
    """Return the postures through which the first motion is led, start and goal among them."""
    return tuple(skeleton(arm.dh, q, arm.convention) for q in led_through(arm.motions[0]))


def _moving(arm: Arm, chosen: ArmMotion) -> Moving:
    durations = durations_of(chosen)
    samples = SAMPLES // len(durations)
    times, angles = course(chosen, derivative=0, samples=samples)
    return Moving(
        name=chosen.name,
        durations=durations,
        times=times,
        postures=tuple(skeleton(arm.dh, q, arm.convention) for q in angles),
        angles=angles,
        shares=_shares(_limits(arm, chosen), chosen, samples),
    )


def _limits(arm: Arm, chosen: ArmMotion) -> Sequence[Sequence[float] | None]:
    """Return the limits that a motion is given, or else those of the machine, kind by kind."""
    own = limits_of(chosen)
    if own is not None:
        return [tuple(row) for row in own]
    return [arm.robot.limit(kind) for kind in DERIVATIVES] if arm.robot else []


def _shares(
    limits: Sequence[Sequence[float] | None], chosen: ArmMotion, samples: int
) -> Vector | None:
    known = [(kind, most) for kind, most in enumerate(limits, start=1) if most is not None]
    if not known or [kind for kind, _ in known] != list(range(1, len(known) + 1)):
        return None
    parts = [
        np.abs(course(chosen, derivative=kind, samples=samples)[1]) / np.array(most)
        for kind, most in known
    ]
    return np.stack(parts, axis=1)
