"""A trajectory law of one's own, and the proved least time along it."""

from dataclasses import dataclass
from math import pi

import numpy as np

from repro.robotics import MinimumTime


@dataclass(frozen=True)
class Cycloid:
    """s = τ - sin(2πτ)/2π: velocity and acceleration are 0 at both ends."""

    def peak_factor(self, derivative):
        """Return the greatest size of the m-th derivative on [0, 1]."""
        return {1: 2.0, 2: 2 * pi, 3: 4 * pi**2}[derivative]

    def sample(self, share, derivative=0):
        """Return the m-th derivative at these shares of the time."""
        angle = 2 * pi * share
        curves = (share - np.sin(angle) / (2 * pi), 1 - np.cos(angle),
                  2 * pi * np.sin(angle), 4 * pi**2 * np.cos(angle))  # fmt: skip
        return curves[derivative]


MOTION = MinimumTime(
    waypoints=((0.0, 0.0), (0.6, -0.4), (1.2, 0.3)),
    law=Cycloid(),
    velocity=(1.5, 1.5),
    acceleration=(4.0, 4.0),
    durations=(0.1, 10.0),
)

if __name__ == "__main__":
    print(MOTION.shortest().sum(), "s")
