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
from repro.report.drawings.arm_scene import scene_of
from repro.report.drawings.style import (
    COLOURS,
    WIDTH,
    Plot,
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
POINTS = 72  # to the inch, of line widths
# Shares of what the picture shows, and of a link's radius; report/arm/source has the same.
THICK, DRUM, FOOT = 0.022, 1.8, 3.0
INVENTED = (
    "Lengths and joint axes are those of the parameters; how thick links, joints and foot are is "
    "ours, and so is the shape of the tool. The squares lie in the plane z = 0 of the base frame; "
    "how high it is above a floor the parameters do not say."
)
ROUND: Style = {"solid_capstyle": "round", "solid_joinstyle": "round"}
START: Style = {"color": COLOURS[0], "linewidth": 6} | ROUND
GOAL: Style = {"color": COLOURS[1], "linewidth": 6} | ROUND
BETWEEN: Style = {"color": "#000000", "linewidth": 1.4, "marker": "o", "markersize": 3}
PATH: Style = {"color": COLOURS[2], "linewidth": 1.8, "linestyle": (0, (3, 1.5))}
FLOOR: Style = {"color": "#000000", "linewidth": 0.5, "alpha": 0.3}

POINT = 0.1  # m: how much is shown round an arm without lengths
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
    told = (
        f"An arm of {len(figure.dh)} joints drawn from its Denavit-Hartenberg parameters "
        f"({figure.convention} convention), as lines through its links"
    )
    return motions_plot(motions, stops, told=told, after=_assumed(figure, assumptions))


def motions_plot(
    motions: Sequence[Moving],
    stops: Sequence[Skeleton],
    *,
    told: str,
    after: str = "",
    joints: Sequence[tuple[str, str]] = (),
) -> Plot:
    """Return still and scene of an arm on its motions; `told` begins what is said of them.

    `stops` are the postures at the waypoints; `joints` are as in scene_of.
    """
    eye = _eye(motions)
    scene = scene_of(
        motions,
        stops,
        middle=eye.middle,
        radius=eye.radius,
        square=_square(eye),
        axis=_axis_length(eye),
        view=(eye.azimuth, ELEVATION),
        joints=joints,
    )
    return Plot(
        canvas=_still(motions[0], stops, eye, column=scene["column"]),
        description=f"{told}{_description(motions, stops)}{after}",
        frame=_frame(motions),
        scene=scene,
    )


def _eye(motions: Sequence[Moving]) -> Eye:
    corners = np.array([posture.corners for m in motions for posture in m.postures])
    everything = np.vstack([corners.reshape(-1, 3), np.zeros((1, 3))])
    middle = (everything.min(axis=0) + everything.max(axis=0)) / 2
    radius = float(np.linalg.norm(everything - middle, axis=1).max()) or POINT
    eyes = [
        Eye(azimuth=2 * math.pi * (k + 0.5) / DIRECTIONS, middle=middle, radius=radius)
        for k in range(DIRECTIONS)
    ]
    return max(eyes, key=lambda eye: float(eye.sees(motions[0].tool)[:, 0].std().round(9)))


def _still(motion: Moving, stops: Sequence[Skeleton], eye: Eye, *, column: bool) -> Figure:
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
    per_metre = WIDTH * POINTS / float((high - low)[0])
    _draw_base(axes, eye, column=column)
    axes.plot(*path.T, **PATH)
    for arm in arms[1:-1]:
        axes.plot(*arm.T, **BETWEEN)
    for stop, style in ((stops[0], START), (stops[-1], GOAL)):
        _draw_arm(axes, eye, stop, style, per_metre)
    _number_tools(axes, [arm[-1] for arm in arms])
    axes.text(0.01, 0.0, f"squares: {_square(eye):g} m", transform=axes.transAxes, va="bottom")
    return canvas


def _draw_arm(axes: Axes, eye: Eye, stop: Skeleton, style: Style, per_metre: float) -> None:
    """Draw links with thickness, and joints as cylinders along their axes, before them."""
    thick = 2 * THICK * eye.radius * per_metre
    axes.plot(*eye.sees(stop.corners).T, **style | {"linewidth": thick})
    half = DRUM * THICK * eye.radius
    for place, axis in zip(stop.joints, stop.axes, strict=True):
        ends = eye.sees(np.array([place - half * axis, place + half * axis]))
        for width, colour in ((1.7, "#000000"), (1.3, style["color"])):
            axes.plot(
                *ends.T,
                color=colour,
                linewidth=width * thick,
                solid_capstyle="round",
            )


def _draw_base(axes: Axes, eye: Eye, *, column: bool) -> None:
    length = _axis_length(eye)
    for name, end in zip("xyz", np.eye(3) * length, strict=True):
        axes.plot(*eye.sees(np.array([np.zeros(3), end])).T, color="#000000", linewidth=1)
        across, up = eye.sees(end + 0.08 * eye.radius * end / length)
        axes.annotate(f"{name} {length:g} m", (across, up), ha="center", va="center")
    if column:
        angles = np.linspace(0, 2 * np.pi, 49)
        foot = FOOT * THICK * eye.radius
        ring = foot * np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)
        axes.fill(*eye.sees(ring).T, color="#000000", alpha=0.35)


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


def _axis_length(eye: Eye) -> float:
    """Return how long the axes of the base are drawn in m: two squares where they are in sight."""
    ends = 2 * _square(eye) * np.eye(3)
    in_sight = np.linalg.norm(ends - eye.middle, axis=1).max() <= eye.radius
    return _square(eye) * (2 if in_sight else 1)


def _floor(eye: Eye) -> Vector:
    """Return the ends of the lines of the floor, shape (lines, 2, 3), in m."""
    square = _square(eye)
    count = math.ceil(0.6 * eye.radius / square)
    places, far = np.arange(-count, count + 1) * square, count * square
    ends = [[(k, -far, 0.0), (k, far, 0.0)] for k in places]
    return np.array(ends + [[(-far, k, 0.0), (far, k, 0.0)] for k in places])


def _description(motions: Sequence[Moving], stops: Sequence[Skeleton]) -> str:
    places = "; ".join(
        f"{index + 1} at ({', '.join(f'{value:.3f}' for value in stop.corners[-1].round(3) + 0.0)})"
        for index, stop in enumerate(stops)
    )
    told = "; ".join(
        f"{motion.name}: {' + '.join(number(d) for d in motion.durations)}"
        f"{f' = {number(motion.total)}' if len(motion.durations) > 1 else ''} s, the tool travels "
        f"{number(motion.length)} m at up to {number(_fastest(motion))} m/s"
        for motion in motions
    )
    return (
        f"; its tool passes {places} (x, y, z in m). {told}. Squares of the plane z = 0 are "
        f"{_square(_eye(motions)):g} m long. {INVENTED}"
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
