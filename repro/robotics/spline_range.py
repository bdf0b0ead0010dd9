"""Where the path of a spline leaves the range of a joint, which no durations change."""

import numpy as np

from repro.robotics.bsplines import spans
from repro.robotics.directed_spline import Spline
from repro.robotics.motion_checks import Rows

ROUNDING = 1e-12  # share of a range


def leaving(problem: Spline, ranges: Rows) -> tuple[int, int, float] | None:
    """Return segment, joint and farthest value where the path leaves a range most; None if not."""
    found, most = None, ROUNDING
    path = spans(problem.nodes, problem.ends)
    for segment, joint in np.ndindex(problem.segments, len(ranges)):
        curve = np.polynomial.Polynomial(path[segment, :, joint])
        turns = curve.deriv().trim().roots()
        inside = turns.real[(abs(turns.imag) < ROUNDING) & (turns.real > 0.0) & (turns.real < 1.0)]
        low, high = ranges[joint]
        size = high - low if np.isfinite(high - low) else 1.0
        for value in curve(np.concatenate([[0.0, 1.0], inside])).tolist():
            beyond = max(value - high, low - value) / size
            if beyond > most:
                found, most = (segment, joint, value), beyond
    return found
