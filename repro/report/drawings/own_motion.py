"""Position, velocity, acceleration and jerk of every joint of a motion of a user's own."""

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from repro.judge.own_motion import OwnResult
from repro.report.drawings.style import Plot, line_style, name_left_axis, panels
from repro.robotics.own_motion import sampled
from repro.robotics.polynomial_motion import KINDS

NAMES = ("position", "velocity", "acceleration", "jerk")
PER = ("", "/s", "/s²", "/s³")
SAMPLES = 60  # of a segment
DESCRIPTION = (
    "The joints over time. Dotted lines are the limits, in the colour of their joint; upright "
    "lines stand at the waypoints."
)


def joints_plot(found: OwnResult) -> Plot:
    """Return a panel per derivative and unit, its limits as dotted lines in the joint's colour."""
    return Plot(canvas=_joints(found), description=DESCRIPTION, frame=pd.DataFrame())


def _joints(found: OwnResult) -> Figure:
    orders = range(4 if "jerk" in found.limits else 3)
    units = tuple(dict.fromkeys(found.units))
    legend = [Line2D([], [], label=name, **line_style(k)) for k, name in enumerate(found.names)]
    canvas, grid = panels(len(orders) * len(units), 1, height=1.45, legend=legend, title=0.1)
    at = np.array(found.certificate.at)
    places = ((m, unit) for m in orders for unit in units)
    for (m, unit), (axes,) in zip(places, grid, strict=True):
        times, values = sampled(found.problem, at, derivative=m, samples=SAMPLES)
        joints = [k for k, own in enumerate(found.units) if own == unit]
        for k in joints:
            axes.plot(times, values[:, k], **line_style(k))
        for end in np.cumsum(at):
            axes.axvline(end, color="#000000", linewidth=0.8, alpha=0.6)
        _draw_limits(axes, found, m, joints)
        name_left_axis(axes, f"{NAMES[m]}\n[{unit}{PER[m]}]")
        axes.set_xlim(left=0.0)
    grid[-1][0].set_xlabel("time [s]")
    return canvas


def _draw_limits(axes: Axes, found: OwnResult, derivative: int, joints: list[int]) -> None:
    pairs = found.limits.get(KINDS[derivative])
    if pairs is None:
        return
    for k in joints:
        for limit in pairs[k]:
            if np.isfinite(limit):
                colour = line_style(k)["color"]
                axes.axhline(limit, color=colour, linewidth=1, linestyle=(0, (2, 2)))
