"""What the live view of an arm draws, as plain numbers: the browser computes no posture."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from repro.report.drawings.arm_motion import Moving
from repro.report.drawings.style import Scene
from repro.robotics.rest_to_rest import DERIVATIVES
from repro.robotics.skeleton import Skeleton

Vector = NDArray[np.float64]
SAME = 1e-6  # m: corners that are never farther apart are one
BASE = 1e-3  # m: a column that is lower is none


def scene_of(
    motions: Sequence[Moving],
    stops: Sequence[Skeleton],
    *,
    middle: Vector,
    radius: float,
    square: float,
    axis: float,
    view: tuple[float, float],
    joints: Sequence[tuple[str, str]] = (),
) -> Scene:
    """Return lengths in mm, times in s, hundredths for directions, tenths of a degree or mm.

    `middle` and `radius` in m are the ball that holds all that moves, `square` and `axis` the sides
    of the floor's squares and the length of the base's axes; `view` is azimuth and
    elevation of the eye in rad; `joints` are name and unit (° or mm) of each.
    """
    every = np.array([p.corners for motion in motions for p in motion.postures])
    kept = [0, *(k for k in range(1, every.shape[1]) if _apart(every[:, k - 1], every[:, k]))]
    at = np.array([p.joints for motion in motions for p in motion.postures])
    count = at.shape[1]
    named = tuple(joints) or tuple((str(k), "°") for k in range(1, count + 1))
    kinds = {m.shares.shape[1] for m in motions if m.shares is not None}
    return {
        "motions": [_motion(motion, kept, [unit for _, unit in named]) for motion in motions],
        "joints": [_corner(every[:, kept], at[:, k]) for k in range(count)],
        "names": [f"{name} [{unit}]" for name, unit in named],
        "limits": [
            f"{kind} of joint {name}"
            for kind in tuple(DERIVATIVES.values())[: max(kinds, default=0)]
            for name, _ in named
        ],
        "waypoints": [_whole(1000 * stop.corners[-1]) for stop in stops],
        "middle": _whole(1000 * middle),
        "radius": round(1000 * radius),
        "grid": round(1000 * square),
        "axis": round(1000 * axis),
        "column": bool(every[0, kept[1], 2] > BASE) if len(kept) > 1 else False,
        "view": [round(view[0], 4), round(view[1], 4)],
    }


def _motion(motion: Moving, kept: Sequence[int], units: Sequence[str]) -> Scene:
    angles = motion.angles
    digits = max(4, 4 - math.floor(math.log10(motion.total)))
    scale = [10 * (np.degrees(1.0) if unit == "°" else 1000.0) for unit in units]
    return {
        "name": motion.name,
        "durations": [round(duration, digits) for duration in motion.durations],
        "times": np.round(motion.times, digits).tolist(),
        "corners": [_whole(1000 * p.corners[list(kept)]) for p in motion.postures],
        "axes": [_whole(100 * p.axes) for p in motion.postures],
        "angles": [] if angles is None else [_whole(row * scale) for row in angles],
        "nearest": [
            [kind * len(units) + joint, round(100 * share)]
            for kind, joint, share in motion.nearest()
        ],
    }


def _apart(before: Vector, after: Vector) -> bool:
    return bool(np.abs(after - before).max() > SAME)


def _corner(corners: Vector, joint: Vector) -> int:
    """Return the corner that a joint stands at in every posture, or is nearest to."""
    return int(np.linalg.norm(corners - joint[:, None], axis=2).max(axis=0).argmin())


def _whole(values: Vector) -> list[int]:
    return [round(value) for value in values.ravel().tolist()]
