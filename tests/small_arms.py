"""A plane arm of two joints, and a paper that shows it, for the tests of the view of the arm."""

import math
from dataclasses import replace

from repro.model.assumptions import Assumption
from repro.model.figures import Arm, ArmMotion
from repro.model.paper import Paper
from repro.robotics import MinimumTime, quintic
from tests.doe2021 import PAPER

SWING = MinimumTime(
    waypoints=((0.0, 0.0), (math.pi / 2, 0.0), (math.pi / 2, math.pi / 2)),
    law=quintic,
    velocity=(1.0, 1.0),
    acceleration=(100.0, 100.0),
    durations=(0.1, 9.0),
)
PLANE = Assumption(
    what="plane of the arm",
    where="p. 3",
    chosen="level",
    alternatives=(),
    because="no other is <b>drawn</b>",
)
ARM = Arm(
    label="Arm",
    caption="A plane arm",
    dh=((1.0, 0.0, 0.0), (0.5, 0.0, 0.0)),
    convention="standard",
    motions=(
        ArmMotion(name="as </script><b>printed</b>", problem=SWING, durations=(4.0, 6.0)),
        ArmMotion(name="certified optimum", problem=SWING),
    ),
    assumed=("plane of the arm",),
)
SHOWING_AN_ARM: Paper = replace(PAPER, figures=(ARM,), assumptions=(*PAPER.assumptions, PLANE))
