"""Robot descriptions in URDF: the chain that moves, its ranges and greatest velocities.

Read with yourdfpy (https://github.com/clemense/yourdfpy), which comes with the extra `urdf`.
"""

import logging
import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from repro.errors import InputError
from repro.robotics.chain import Chain, Joint
from repro.robotics.motion_checks import Rows

MOVING = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic"}


def read_urdf(path: Path) -> tuple[Chain, dict[str, Rows]]:
    """Return the chain of the one arm that a file describes, and its limits in rad, m and s.

    The limits are `velocity` and `range`, each only where every joint has it. Raises InputError
    for a file that cannot be read, or whose joints that move are no single chain.
    """
    try:
        there = path.is_file()
    except OSError:  # a name that no file can have
        there = False
    if not there:
        message = f"robot {path}: there is no such file"
        raise InputError(message)
    try:
        from yourdfpy import URDF  # noqa: PLC0415 (an extra)
    except ImportError:
        message = f"robot {path}: pip install 'repro-whales[urdf]' to read robot descriptions"
        raise InputError(message) from None
    try:
        with _quiet():
            robot = URDF.load(str(path), build_scene_graph=False, load_meshes=False)
        joints = _chain(list(robot.robot.joints))
        chain = _joined(joints)
    except InputError as error:
        message = f"robot {path}: {error}"
        raise InputError(message) from None
    except Exception as error:  # noqa: BLE001 (whatever a parser raises for what is no URDF)
        message = f"robot {path}: is no URDF: {' '.join(str(error).split())[:200]}"
        raise InputError(message) from None
    return chain, _limits([joint for joint in joints if joint.type in MOVING])


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep the parser's own log to itself: what it could not read is one line here."""
    before = logging.root.manager.disable
    logging.disable()
    try:
        yield
    finally:
        logging.disable(before)


def _chain(joints: list[Any]) -> list[Any]:
    """Return the joints from the base to the last one that moves, in order."""
    by_child = {joint.child: joint for joint in joints}
    moving = [joint for joint in joints if joint.type in MOVING and joint.mimic is None]
    chains = [_from_base(joint, by_child) for joint in moving]
    if not chains:
        message = "no joint of it moves"
        raise InputError(message)
    longest = max(chains, key=len)
    beside = [joint.name for joint in moving if all(joint is not other for other in longest)]
    if beside:
        message = f"is no single chain: {', '.join(beside)} move beside {longest[-1].name}"
        raise InputError(message)
    tool = longest[-1].child
    while len(after := [j for j in joints if j.parent == tool and j.type == "fixed"]) == 1:
        longest.append(after[0])
        tool = after[0].child
    return longest


def _from_base(joint: Any, by_child: dict[str, Any]) -> list[Any]:  # noqa: ANN401 (yourdfpy's)
    """Return the joints that lead to this one, itself the last."""
    chain = [joint]
    while chain[0].parent in by_child:
        before = by_child[chain[0].parent]
        if any(before is other for other in chain):
            message = f"is no chain: joint {before.name} comes back to itself"
            raise InputError(message)
        if before.mimic is not None:
            message = f"joint {before.name} mimics {before.mimic.joint}: it does not move by itself"
            raise InputError(message)
        if before.type not in {*MOVING, "fixed"}:
            known = ", ".join((*MOVING, "fixed"))
            message = f"joint {before.name} is {before.type}: an arm's are {known}"
            raise InputError(message)
        chain.insert(0, before)
    return chain


def _joined(joints: list[Any]) -> Chain:
    before, moving = np.eye(4), []
    for joint in joints:
        before = before @ (np.eye(4) if joint.origin is None else np.array(joint.origin))
        if joint.type in MOVING:
            axis = np.array([1.0, 0.0, 0.0] if joint.axis is None else joint.axis, dtype=float)
            if not np.linalg.norm(axis) > 0.0:
                message = f"axis of joint {joint.name} is 0: it has no direction"
                raise InputError(message)
            x, y, z = (axis / np.linalg.norm(axis)).tolist()
            moving.append(
                Joint(
                    name=joint.name,
                    kind="prismatic" if joint.type == "prismatic" else "revolute",
                    before=tuple(map(tuple, before.tolist())),
                    axis=(x, y, z),
                )
            )
            before = np.eye(4)
    return Chain(joints=tuple(moving), tool=tuple(map(tuple, before.tolist())))


def _limits(joints: list[Any]) -> dict[str, Rows]:
    found: dict[str, Rows] = {}
    limits = [joint.limit for joint in joints]
    if all(limit is not None and limit.velocity for limit in limits):
        found["velocity"] = tuple((-limit.velocity, limit.velocity) for limit in limits)
    ends = [
        (limit.lower, limit.upper) if joint.type != "continuous" and limit is not None else None
        for joint, limit in zip(joints, limits, strict=True)
    ]
    if any(pair and None not in pair for pair in ends):
        found["range"] = tuple(
            (-math.inf, math.inf) if pair is None or None in pair else (pair[0], pair[1])
            for pair in ends
        )
    return found
