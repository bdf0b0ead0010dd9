"""`repro.certify`: the proved least time of a motion of one's own, in Python."""

import time
from os import PathLike
from pathlib import Path

from repro.commands.motion import result
from repro.commands.motion_files import read_motion
from repro.errors import InputError
from repro.judge.certificates import Certificate
from repro.judge.own_motion import certified
from repro.robotics.motion_checks import LARGEST, shown
from repro.robotics.own_motion import OwnMotion
from repro.robotics.proofs.watch import Watch


def certify(
    problem: OwnMotion | str | PathLike[str], seconds: float = 60.0, *, title: str = ""
) -> Certificate:
    """Return what can be proved of a motion in so many seconds.

    `problem` is a `repro.robotics` MinimumTime, MinimumTimeSpline, DirectedSpline or
    PolynomialMotion, in rad or any other unit, or the path of a file as `repro motion` reads it.
    Where the time is too short `minimum` is None and the bounds are as far as they are. Raises
    InputError for anything else.
    """
    if isinstance(seconds, bool) or not isinstance(seconds, int | float) or not seconds >= 0.0:
        message = f"seconds {shown(seconds)} must be a number, 0 or more"
        raise InputError(message)
    if not isinstance(title, str):
        message = f"title {shown(title)} must be a text"
        raise InputError(message)
    seconds = float(min(seconds, LARGEST))
    if isinstance(problem, str | PathLike):
        return result(read_motion(Path(problem)), seconds).certificate
    watch = Watch(clock=time.monotonic, until=time.monotonic() + seconds)
    return certified(problem, watch, title=title)
