"""The robot itself: a still of its postures at the waypoints, and the scene of its live view."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.assumptions import Assumption
from repro.model.figures import Arm
from repro.report.drawings.arm_motion import Moving, moving, waypoints
from repro.report.drawings.style import (
    COLOURS,
    WIDTH,
    Plot,
    Scene,
    Style,
    draw_legend,
    empty,
    legend_height,
)
from repro.report.drawings.tool_path import numbered
from repro.report.frames import INSTANT
from repro.report.words import number
from repro.robotics.own_motion import increasing
from repro.robotics.skeleton import Skeleton

Vector = NDArray[np.float64]
ELEVATION = math.radians(22)  # of the eye above the floor
DIRECTIONS = 12  # round the arm, none along an axis, from which the widest view is taken
GRID = (1, 2, 5)  # a square of the floor is so many times a power of ten long
START: Style = {"color": COLOURS[0], "linewidth": 4.5, "marker": "o", "markersize": 7}
GOAL: Style = {"color": COLOURS[1], "linewidth": 4.5, "marker": "s", "markersize": 6.5}
BETWEEN: Style = {"color": "#000000", "linewidth": 1.4, "marker": "o", "markersize": 3}
PATH: Style = {"color": COLOURS[2], "linewidth": 1.8, "linestyle": (0, (3, 1.5))}
FLOOR: Style = {"color": "#000000", "linewidth": 0.5, "alpha": 0.3}

PLACES = 4  # of a metre: a tenth of a millimetre


@dataclass(frozen=True, slots=True, kw_only=True)
class Eye:
    """Where the still is seen from, and the ball, in m, that holds all that moves."""

    azimuth: float
    middle: Vector
    radius: float

    def sees(self, places: Vector) -> Vector:
        """Return (across, up) in m of places (…, 3), without perspective."""
        c, s = math.cos(self.azimuth), math.sin(self.azimuth)
        low, high = math.sin(ELEVATION), math.cos(ELEVATION)
        return np.asarray(places @ np.array([[-s, -low * c], [c, -low * s], [0.0, high]]))


def arm_plot(figure: Arm, assumptions: Sequence[Assumption]) -> Plot:
    """Return the still with the scene; DeclarationError for an assumption that is not there."""
    motions, stops = moving(figure), waypoints(figure)
    eye = _eye(motions)
    return Plot(
        canvas=_still(motions[0], stops, eye),
        description=_description(figure, motions, stops) + _assumed(figure, assumptions),
        frame=_frame(motions),
        scene=_scene(figure, motions, stops, eye),
    )


def _eye(motions: Sequence[Moving]) -> Eye:
    corners = np.array([posture.corners for m in motions for posture in m.postures])
    everything = np.vstack([corners.reshape(-1, 3), np.zeros((1, 3))])
    middle = (everything.min(axis=0) + everything.max(axis=0)) / 2
    radius = float(np.linalg.norm(everything - middle, axis=1).max())
    eyes = [
        Eye(azimuth=2 * math.pi * (k + 0.5) / DIRECTIONS, middle=middle, radius=radius)
        for k in range(DIRECTIONS)
    ]
    return max(eyes, key=lambda eye: float(eye.sees(motions[0].tool)[:, 0].std().round(9)))


def _still(motion: Moving, stops: Sequence[Skeleton], eye: Eye) -> Figure:
    """Return the drawing of the arm at every waypoint, with the way of its tool between them."""
    legend = [
        Line2D([], [], label="arm at start", **START),
        *([Line2D([], [], label="between", **BETWEEN)] if len(stops) > 2 else []),
        Line2D([], [], label="arm at goal", **GOAL),
        Line2D([], [], label="path of the tool", **PATH),
    ]
    floor = _floor(eye)
    arms = [eye.sees(stop.corners) for stop in stops]
    path = eye.sees(motion.tool)
    seen = np.vstack([*arms, path, eye.sees(floor.reshape(-1, 3))])
    margin = 0.06 * eye.radius
    low, high = seen.min(axis=0) - [margin, 2 * margin], seen.max(axis=0) + margin
    above = legend_height(legend) + 0.05
    height = WIDTH * float((high - low)[1] / (high - low)[0])
    canvas = empty(above + height)
    draw_legend(canvas, legend)
    axes = canvas.add_axes((0.0, 0.0, 1.0, height / (above + height)))
    axes.set_axis_off()
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    for line in floor:
        axes.plot(*eye.sees(line).T, **FLOOR)
    _draw_base(axes, eye)
    for arm, style in ((arms[0], START), (arms[-1], GOAL), *((arm, BETWEEN) for arm in arms[1:-1])):
        axes.plot(*arm.T, **style)
    axes.plot(*path.T, **PATH)
    _number_tools(axes, [arm[-1] for arm in arms])
    axes.text(0.01, 0.0, f"squares: {_square(eye):g} m", transform=axes.transAxes, va="bottom")
    return canvas


def _draw_base(axes: Axes, eye: Eye) -> None:
    for name, end in zip("xyz", np.eye(3) * 0.35 * eye.radius, strict=True):
        axes.plot(*eye.sees(np.array([np.zeros(3), end])).T, color="#000000", linewidth=1)
        across, up = eye.sees(1.15 * end)
        axes.annotate(name, (across, up), ha="center", va="center")


def _number_tools(axes: Axes, places: Sequence[Vector]) -> None:
    """Write the numbers of the waypoints at the tool; those at the same place share one label."""
    for numbers, place in numbered(np.array(places)):
        axes.annotate(
            numbers,
            place,
            xytext=(0, 9),
            textcoords="offset points",
            ha="center",
            va="center",
            fontweight="bold",
        )


def _square(eye: Eye) -> float:
    """Return the side of a square of the floor in m: 1, 2 or 5 times a power of ten."""
    decade = 10.0 ** math.floor(math.log10(eye.radius / 2))
    return max(decade * share for share in GRID if decade * share <= eye.radius / 2)


def _floor(eye: Eye) -> Vector:
    """Return the ends of the lines of the floor, shape (lines, 2, 3), in m."""
    square = _square(eye)
    count = math.ceil(0.6 * eye.radius / square)
    places, far = np.arange(-count, count + 1) * square, count * square
    ends = [[(k, -far, 0.0), (k, far, 0.0)] for k in places]
    return np.array(ends + [[(-far, k, 0.0), (far, k, 0.0)] for k in places])


def _scene(figure: Arm, motions: Sequence[Moving], stops: Sequence[Skeleton], eye: Eye) -> Scene:
    """Return what the live view draws: lengths in mm, times in s, hundredths for directions."""
    joints = len(figure.dh)
    first = 0 if figure.convention == "standard" else 2  # corner where joint 1 turns
    return {
        "motions": [
            {
                "name": motion.name,
                "durations": [round(duration, 4) for duration in motion.durations],
                "times": np.round(motion.times, 4).tolist(),
                "corners": [_whole(1000 * p.corners) for p in motion.postures],
                "axes": [_whole(100 * p.axes) for p in motion.postures],
            }
            for motion in motions
        ],
        "joints": [first + 2 * joint for joint in range(joints)],
        "waypoints": [_whole(1000 * stop.corners[-1]) for stop in stops],
        "middle": _whole(1000 * eye.middle),
        "radius": round(1000 * eye.radius),
        "grid": round(1000 * _square(eye)),
        "view": [round(eye.azimuth, 4), round(ELEVATION, 4)],
    }


def _whole(values: Vector) -> list[int]:
    return [round(value) for value in values.ravel().tolist()]


def _description(figure: Arm, motions: Sequence[Moving], stops: Sequence[Skeleton]) -> str:
    places = "; ".join(
        f"{index + 1} at ({', '.join(f'{value:.3f}' for value in stop.corners[-1])})"
        for index, stop in enumerate(stops)
    )
    told = "; ".join(
        f"{motion.name}: {' + '.join(number(d) for d in motion.durations)}"
        f"{f' = {number(motion.total)}' if len(motion.durations) > 1 else ''} s, the tool travels "
        f"{number(motion.length)} m at up to {number(_fastest(motion))} m/s"
        for motion in motions
    )
    return (
        f"An arm of {len(figure.dh)} joints drawn from its Denavit-Hartenberg parameters "
        f"({figure.convention} convention), as lines through its links; its tool passes {places} "
        f"(x, y, z in m). {told}. Squares of the floor are {_square(_eye(motions)):g} m long."
    )


def _fastest(motion: Moving) -> float:
    """Return the greatest mean speed of the tool between two samples, in m/s."""
    steps = np.linalg.norm(np.diff(motion.tool, axis=0), axis=1)
    times = np.diff(motion.times)
    return float((steps[times > 0] / times[times > 0]).max())


def _assumed(figure: Arm, assumptions: Sequence[Assumption]) -> str:
    """Return what the picture rests on that the paper does not say."""
    known = {assumption.what: assumption for assumption in assumptions}
    texts = []
    for what in figure.assumed:
        if what not in known:
            message = f"{figure.label}: no assumption {what!r}; known: {', '.join(known)}"
            raise DeclarationError(message)
        texts.append(f" Assumed: {what}: {known[what].chosen}, because {known[what].because}.")
    return "".join(texts)


def _frame(motions: Sequence[Moving]) -> pd.DataFrame:
    frames = len(motions[0].postures[0].origins)
    names = ["base", *(f"frame {k}" for k in range(1, frames - 1)), "tool"]
    places = [posture.origins.ravel() for motion in motions for posture in motion.postures]
    frame = pd.DataFrame(
        np.round(places, PLACES) + 0.0,  # no negative zero
        columns=[f"{axis} of {name} [m]" for name in names for axis in "xyz"],
    )
    frame.insert(0, "motion", [motion.name for motion in motions for _ in motion.postures])
    frame.insert(1, INSTANT, np.concatenate([motion.times for motion in motions]))
    ends = np.cumsum([0, *(len(motion.times) for motion in motions)])
    kept = [start + increasing(m.times) for start, m in zip(ends[:-1], motions, strict=True)]
    return frame.iloc[np.concatenate(kept)]
