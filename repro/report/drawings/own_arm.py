"""A still of the arm of a user's own motion: its links at start and goal, and the tool's path."""

import math

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.report.drawings.style import COLOURS, WIDTH, draw_legend, empty, legend_height
from repro.robotics.own_motion import OwnMotion

Vector = NDArray[np.float64]
AZIMUTH, ELEVATION = math.radians(35), math.radians(20)


def seen(places: Vector) -> Vector:
    """Return (across, up) in m of places (…, 3), without perspective."""
    c, s = math.cos(AZIMUTH), math.sin(AZIMUTH)
    low, high = math.sin(ELEVATION), math.cos(ELEVATION)
    return np.asarray(places @ np.array([[-s, -low * c], [c, -low * s], [0.0, high]]))


def still(corners: Vector, problem: OwnMotion) -> Figure:
    """Return the drawing of postures (n, corners, 3) in m, from the start to the end."""
    legend = [
        Line2D([], [], label="start", color=COLOURS[0], linewidth=4),
        Line2D([], [], label="end", color=COLOURS[1], linewidth=4),
        Line2D([], [], label=f"path of the tool, {problem.segments} segments", color=COLOURS[2]),
    ]
    flat = seen(corners)
    span = np.vstack([flat.reshape(-1, 2), [[0.0, 0.0]]])
    low, high = span.min(axis=0), span.max(axis=0)
    margin = 0.08 * max(*(high - low), 1e-6)
    wide, tall = (high - low) + 2 * margin
    height = min(WIDTH * tall / wide, 1.4 * WIDTH)
    canvas = empty(legend_height(legend) + height)
    draw_legend(canvas, legend)
    axes = canvas.add_axes((0.0, 0.0, 1.0, height / (legend_height(legend) + height)))
    axes.set_axis_off()
    axes.set_aspect("equal")
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.plot(*flat[:, -1].T, color=COLOURS[2])
    for posture, colour in ((flat[0], COLOURS[0]), (flat[-1], COLOURS[1])):
        axes.plot(*posture.T, color=colour, linewidth=4, marker="o", markersize=7)
    axes.plot(0.0, 0.0, color="#000000", marker="s", markersize=9)
    return canvas
