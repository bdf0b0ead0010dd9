"""What all drawings share: line styles, type sizes, legend, and the panels' places."""

import math
import threading
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import matplotlib as mpl
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import blended_transform_factory

Style = dict[str, Any]  # keyword arguments of matplotlib
Scene = Mapping[str, Any]

# Okabe and Ito's colours (jfly.uni-koeln.de/color, 2008), their orange and sky blue darkened until
# every one stands out from white and from #111 by 3 to 1; black becomes the page's text colour.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#A87900", "#000000", "#3A8FC8")
# Lengths of dash and gap in line widths; none is a solid line.
DASHES: tuple[tuple[float, ...], ...] = (
    (), (5, 1.5), (1.2, 1.2), (6, 1.5, 1.2, 1.5), (3, 1.2), (7, 1.2, 1.2, 1.2, 1.2, 1.2),
)  # fmt: skip
WIDTH = 5.4  # in; at 360 px of screen the smallest text is then 8 px high
LEFT, RIGHT, TOP, BOTTOM = 0.84, 0.1, 0.08, 0.5  # in, around the panels
LEGEND_LINE = 0.23  # in
CURVE_POINTS = 80
GRID: Style = {"color": "#000000", "alpha": 0.25, "linewidth": 0.5}
_SETTINGS: Any = {
    "svg.fonttype": "none",
    "svg.hashsalt": "repro",
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.labelsize": 10,
    "xtick.labelsize": 10,
    "ytick.labelsize": 10,
    "legend.fontsize": 10,
    "text.parse_math": False,
    "lines.linewidth": 1.5,
}
_ONE_AT_A_TIME = threading.Lock()  # matplotlib's settings belong to the whole process


@dataclass(frozen=True, slots=True, kw_only=True)
class Plot:
    """A drawn figure, what it shows in words, and its data.

    `scene`, where given, is what the interactive view of the same draws, ready for JSON.
    """

    canvas: Figure
    description: str
    frame: pd.DataFrame
    scene: Scene | None = None


@contextmanager
def drawing_style() -> Iterator[None]:
    """Draw with our settings on matplotlib's defaults, whatever the user's own settings are."""
    with _ONE_AT_A_TIME, mpl.rc_context(), warnings.catch_warnings():
        # the font that measures texts lacks some signs, which the reader's browser draws
        warnings.filterwarnings("ignore", "Glyph", UserWarning)
        mpl.rcdefaults()
        mpl.rcParams.update(_SETTINGS)
        yield


def line_style(index: int) -> Style:
    """Return colour and dashes of the curve of that index, no two alike among the first 42."""
    dashes = DASHES[index % len(DASHES)]
    return {
        "color": COLOURS[index % len(COLOURS)],
        "linestyle": (0, dashes) if dashes else "-",
    }


def panels(
    rows: int,
    columns: int,
    *,
    height: float,
    legend: Sequence[Line2D],
    title: float,
    gaps: tuple[float, float] = (0.2, 0.16),
    share: bool = True,
) -> tuple[Figure, list[list[Axes]]]:
    """Return a figure with its legend on top and rows of panels of that height below.

    Lengths in inches: `gaps` between (columns, rows), `title` the room above each panel. With
    `share`, panels of a row share their y axis, and all of them their x axis.
    """
    above = legend_height(legend) + title
    total = above + rows * height + (rows - 1) * gaps[1] + BOTTOM
    canvas = empty(total)
    width = (WIDTH - LEFT - RIGHT - (columns - 1) * gaps[0]) / columns
    grid = canvas.subplots(
        rows,
        columns,
        squeeze=False,
        sharex=share,
        sharey="row" if share else False,
        gridspec_kw={
            "left": LEFT / WIDTH,
            "right": 1 - RIGHT / WIDTH,
            "top": 1 - above / total,
            "bottom": BOTTOM / total,
            "wspace": gaps[0] / width,
            "hspace": gaps[1] / height,
        },
    )
    draw_legend(canvas, legend)
    for axes in grid.flat:
        plain(axes)
    return canvas, [list(row) for row in grid]


def panels_two_abreast(
    count: int, *, height: float, legend: Sequence[Line2D], gaps: tuple[float, float]
) -> tuple[Figure, list[Axes]]:
    """Return a figure of so many panels with a title each, every one with axes of its own."""
    across = min(2, count)
    canvas, grid = panels(
        math.ceil(count / across),
        across,
        height=height,
        legend=legend,
        gaps=gaps,
        title=0.28,
        share=False,
    )
    places = [axes for row in grid for axes in row]
    for axes in places[count:]:
        axes.remove()
    return canvas, places[:count]


def empty(height: float) -> Figure:
    """Return a transparent figure of our width and of that height in inches."""
    canvas = Figure(figsize=(WIDTH, height))
    canvas.patch.set_visible(False)
    return canvas


def plain(axes: Axes) -> None:
    """Give a panel a see-through ground, a quiet grid and no frame on the far sides."""
    axes.patch.set_visible(False)
    axes.grid(visible=True, **GRID)
    axes.spines[["top", "right"]].set_visible(False)


def name_left_axis(axes: Axes, name: str) -> None:
    """Write the name of a y axis along the left edge of the figure, however wide its numbers."""
    canvas = axes.get_figure(root=True)
    axes.set_ylabel(name, va="top")
    if canvas is not None:
        place = blended_transform_factory(canvas.transFigure, axes.transAxes)
        axes.yaxis.set_label_coords(0.0, 0.5, transform=place)


def legend_columns(legend: Sequence[Line2D]) -> int:
    """Return how many entries stand side by side so that every line is about equally full."""
    lengths = [len(str(entry.get_label())) for entry in legend]

    def width(across: int) -> float:
        # in: the sample with its gaps, then the letters at their mean width
        return sum(0.52 + 0.083 * max(lengths[k::across]) for k in range(across))

    fit = next((n for n in range(len(legend), 1, -1) if width(n) <= WIDTH - RIGHT), 1)
    return math.ceil(len(legend) / math.ceil(len(legend) / fit))


def legend_height(legend: Sequence[Line2D]) -> float:
    """Return the room that the legend takes at the top of the figure, in inches."""
    return TOP + LEGEND_LINE * math.ceil(len(legend) / legend_columns(legend))


def draw_legend(canvas: Figure, legend: Sequence[Line2D]) -> None:
    """Draw one legend at the top of the figure, read line by line."""
    across = legend_columns(legend)
    ordered = [entry for column in range(across) for entry in legend[column::across]]
    canvas.legend(
        handles=ordered,
        loc="upper center",
        ncols=across,
        frameon=False,
        handlelength=2.6,
        columnspacing=1.2,
        handletextpad=0.5,
        borderaxespad=0.1,
        borderpad=0.1,
    )
