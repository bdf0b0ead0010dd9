"""Path of the last frame in space: three views at one scale, with the waypoints."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.model.figures import ToolPath
from repro.report.drawings.style import (
    BOTTOM,
    COLOURS,
    CURVE_POINTS,
    LEFT,
    RIGHT,
    WIDTH,
    Plot,
    Style,
    draw_legend,
    empty,
    legend_height,
    line_style,
    plain,
)
from repro.report.drawings.svg import POINTS_PER_INCH
from repro.robotics import MinimumTime, forward_kinematics
from repro.robotics.shown_motion import moved, stops

Vector = NDArray[np.float64]
Place = tuple[float, float]
LABEL_DISTANCE = 12.0  # points
GAP = 0.75  # in, between the views
TALLEST = 4.6  # in, both rows of views together
HEADINGS = ("what", "number", "x [m]", "y [m]", "z [m]")
COMPUTED: Style = {
    "marker": "o",
    "markersize": 9,
    "markerfacecolor": "none",
    "markeredgewidth": 1.4,
}
PRINTED: Style = {"marker": "x", "markersize": 7, "markeredgewidth": 1.8}
NAMES = ("tool path", "computed waypoint", "printed waypoint")


@dataclass(frozen=True, slots=True, kw_only=True)
class Path:
    """Positions in m: along the path (n, 3), at the computed and at the printed waypoints."""

    along: Vector
    computed: Vector
    printed: Vector

    @property
    def distances(self) -> Vector:
        """How far each printed waypoint lies from the computed one, in mm."""
        count = min(len(self.printed), len(self.computed))
        apart = self.printed[:count] - self.computed[:count]
        return np.asarray(1000 * np.linalg.norm(apart, axis=1))


def tool_path_plot(figure: ToolPath) -> Plot:
    """Return the drawing: the path from above, from the front and from the side."""
    path = _path(figure)
    legend = [
        Line2D([], [], label=NAMES[0], **line_style(0)),
        Line2D([], [], label=NAMES[1], color="#000000", linestyle="", **COMPUTED),
        Line2D([], [], label=NAMES[2], color=COLOURS[1], linestyle="", **PRINTED),
    ]
    everything = np.vstack([path.along, path.computed, path.printed])
    low, high = everything.min(axis=0), everything.max(axis=0)
    middle, longest = (low + high) / 2, (high - low).max()
    reach = np.maximum(high - low, 0.3 * longest) / 2 + 0.12 * longest  # a plane path has a view
    low, high = middle - reach, middle + reach
    canvas, views = _views(high - low, legend)
    for axes, (across, up) in zip(views, ((0, 1), (0, 2), (1, 2)), strict=True):
        axes.set_xlim(low[across], high[across])
        axes.set_ylim(low[up], high[up])
        axes.set_xlabel(f"{'xyz'[across]} [m]")
        axes.set_ylabel(f"{'xyz'[up]} [m]")
        _draw_view(axes, path, [across, up])
    if path.distances.size:
        _write_distances(views[0], path)
    return Plot(canvas=canvas, description=_description(path), frame=_frame(path))


def _path(figure: ToolPath) -> Path:
    problem = figure.problem
    if isinstance(problem, MinimumTime):
        # every joint runs through the same share of its way: the path is the same at any speed
        point = np.ones(problem.segments)
    else:
        point = np.array(figure.durations)
    _, angles = moved(problem, point, derivative=0, samples=CURVE_POINTS)

    def positions(points: object) -> Vector:
        poses = [forward_kinematics(figure.dh, q, figure.convention) for q in np.asarray(points)]
        return np.array([pose[:3, 3] for pose in poses])

    return Path(
        along=positions(angles),
        computed=positions(stops(problem, point)),
        printed=np.array(figure.printed_waypoints, dtype=np.float64).reshape(-1, 3),
    )


def _views(extent: Vector, legend: list[Line2D]) -> tuple[Figure, list[Axes]]:
    """Return panels for (x, y), (x, z) and (y, z) in which a metre is equally long everywhere."""
    x, y, z = extent
    scale = min((WIDTH - LEFT - RIGHT - GAP) / (x + y), TALLEST / (y + z))
    x, y, z = x * scale, y * scale, z * scale
    total = legend_height(legend) + 0.1 + y + GAP + z + BOTTOM
    canvas = empty(total)
    draw_legend(canvas, legend)
    beside, above = LEFT + x + GAP, BOTTOM + z + GAP
    places = ((LEFT, above, x, y), (LEFT, BOTTOM, x, z), (beside, BOTTOM, y, z))
    views = [
        canvas.add_axes((left / WIDTH, bottom / total, width / WIDTH, height / total))
        for left, bottom, width, height in places
    ]
    for axes in views:
        plain(axes)
        axes.locator_params(nbins=4)
    return canvas, views


def _draw_view(axes: Axes, path: Path, pair: list[int]) -> None:
    axes.plot(*path.along[:, pair].T, **line_style(0))
    axes.plot(*path.computed[:, pair].T, color="#000000", linestyle="", **COMPUTED)
    axes.plot(*path.printed[:, pair].T, color=COLOURS[1], linestyle="", **PRINTED)
    for names, place in numbered(path.computed[:, pair]):
        axes.annotate(
            names,
            place,
            xytext=_free_side(place, path.along[:, pair]),
            textcoords="offset points",
            ha="center",
            va="center",
        )


def numbered(places: Vector) -> list[tuple[str, Place]]:
    """Return the numbers of the waypoints at each place; those at the same place together."""
    numbers: dict[Place, list[str]] = {}
    for index, (across, up) in enumerate(places.round(3).tolist()):
        numbers.setdefault((across, up), []).append(str(index + 1))
    return [(", ".join(shared), place) for place, shared in numbers.items()]


def _write_distances(axes: Axes, path: Path) -> None:
    """Write into the empty corner how far the print lies from the computed waypoints."""
    lines = [f"{k + 1}: {far:.2f} mm" for k, far in enumerate(path.distances)]
    axes.annotate(
        "\n".join(["distance of the print:", *lines]),
        (1, 1),
        xycoords="axes fraction",
        xytext=(POINTS_PER_INCH * GAP, 0),
        textcoords="offset points",
        va="top",
        linespacing=1.5,
        annotation_clip=False,
    )


def _free_side(place: Place, along: Vector) -> Place:
    """Return an offset in points from a place away from the part of the path close to it."""
    steps = np.array(place) - along
    lengths = np.linalg.norm(steps, axis=1)
    close = (lengths > 0) & (lengths < 0.2 * lengths.max())
    away = steps[close].mean(axis=0) if close.any() else np.ones(2)
    length = float(np.linalg.norm(away))
    across, up = LABEL_DISTANCE * away / length if length else (0.0, LABEL_DISTANCE)
    return float(across), float(up)


def _description(path: Path) -> str:
    computed = "; ".join(
        f"{index + 1} at ({', '.join(f'{value:.3f}' for value in place)})"
        for index, place in enumerate(path.computed)
    )
    text = (
        "Path of the tool seen along each axis, in metres, through the computed waypoints "
        f"{computed}."
    )
    if not path.distances.size:
        return text
    apart = ", ".join(f"{distance:.2f}" for distance in path.distances)
    return f"{text} The printed waypoints lie {apart} mm away from them."


def _frame(path: Path) -> pd.DataFrame:
    rows = [
        (name, index, *place)
        for name, places in zip(NAMES, (path.along, path.computed, path.printed), strict=True)
        for index, place in enumerate(places, start=1)
    ]
    return pd.DataFrame(rows, columns=list(HEADINGS))
