"""Strips of runs: from the lowest to the highest, the middle half, the median, what is printed."""

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.report.drawings.convergence import CostScale
from repro.report.drawings.style import Plot, Style, panels_two_abreast
from repro.report.words import number

Vector = NDArray[np.float64]
LINE = 0.24  # in, from one algorithm to the next
LONGEST = 9  # letters of a name in one line
QUANTILES = (0.0, 0.25, 0.5, 0.75, 1.0)
RANGE: Style = {"color": "#0072B2", "linewidth": 1.2, "solid_capstyle": "butt"}
HALF: Style = {"color": "#0072B2", "linewidth": 5.0, "solid_capstyle": "butt"}
MEDIAN: Style = {
    "color": "#000000", "linestyle": "none", "marker": "|", "markersize": 9.0,
    "markeredgewidth": 1.6,
}  # fmt: skip
PRINTED: Style = {
    "color": "#D55E00", "linestyle": "none", "markersize": 6.0, "markerfacecolor": "none",
    "markeredgewidth": 1.4,
}  # fmt: skip
MARKS: Mapping[str, str] = {"mean": "D", "best": "<", "single": "s"}
SAYS: Mapping[str, str] = {
    "mean": "printed mean", "best": "printed best", "single": "printed (one run)",
}  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Strip:
    """Every run of one algorithm, shape (n,), and what is printed of them by statistic."""

    algorithm: str
    values: Vector
    printed: Mapping[str, float]

    @property
    def quantiles(self) -> Vector:
        """Lowest, lower quartile, median, upper quartile and highest, each one that a run has."""
        return np.asarray(np.quantile(self.values, QUANTILES, method="closest_observation"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Panel:
    """The strips of all algorithms on one problem, in the printed unit."""

    title: str
    unit: str
    strips: tuple[Strip, ...]


def distribution_plot(drawn: Sequence[Panel]) -> Plot:
    """Return the drawing of one panel per problem; zeros stand on a mark of their own."""
    most = max(len(panel.strips) for panel in drawn)
    canvas, places = panels_two_abreast(
        len(drawn), height=LINE * (most + 0.5), legend=_legend(drawn), gaps=(0.86, 0.55)
    )
    for axes, panel in zip(places, drawn, strict=True):
        draw_strips(axes, panel)
    return Plot(canvas=canvas, description=_description(drawn), frame=_frame(drawn))


def _legend(drawn: Sequence[Panel]) -> list[Line2D]:
    marked = {name for panel in drawn for strip in panel.strips for name in strip.printed}
    return [
        Line2D([], [], label="all runs", **RANGE),
        Line2D([], [], label="middle half", **HALF),
        Line2D([], [], label="median", **MEDIAN),
        *(
            Line2D([], [], label=SAYS[name], marker=marker, **PRINTED)
            for name, marker in MARKS.items()
            if name in marked
        ),
    ]


def draw_strips(axes: Axes, panel: Panel) -> None:
    """Draw the strips of one panel from the top down."""
    everything = np.concatenate(
        [[*strip.quantiles, *strip.printed.values()] for strip in panel.strips]
    )
    scale = CostScale.of(everything)
    places = np.array([scale.place(strip.quantiles) for strip in panel.strips])
    lines = np.arange(float(len(panel.strips)))
    axes.plot(*_joined(places[:, [0, 4]], lines), **RANGE)
    axes.plot(*_joined(places[:, [1, 3]], lines), **HALF)
    axes.plot(places[:, 2], lines, **MEDIAN)
    for name, marker in MARKS.items():
        marks = [
            (strip.printed[name], y)
            for y, strip in enumerate(panel.strips)
            if name in strip.printed
        ]
        if marks:
            values, heights = np.array(marks).T
            axes.plot(scale.place(values), heights, marker=marker, **PRINTED)
    axes.set_ylim(len(lines) - 0.4, -0.6)
    axes.set_yticks(lines, [textwrap.fill(strip.algorithm, LONGEST) for strip in panel.strips])
    axes.set_title(f"{panel.title} [{panel.unit}]" if panel.unit else panel.title)
    _ticks(axes, scale, everything)


def _joined(ends: Vector, lines: Vector) -> tuple[Vector, Vector]:
    """Return the points of separate lines as those of one path with gaps."""
    gaps = np.full(len(lines), np.nan)
    return np.column_stack([ends, gaps]).ravel(), np.column_stack([lines, lines, gaps]).ravel()


def _ticks(axes: Axes, scale: CostScale, values: Vector) -> None:
    if scale.logarithmic:
        ticks = scale.ticks() | ({scale.zero: "0"} if (values == 0).any() else {})
        axes.set_xticks(list(ticks), list(ticks.values()))
    elif values.min() == values.max():
        axes.set_xticks(values[:1], [number(float(values[0]))])
    else:
        axes.locator_params(axis="x", nbins=4)
        axes.ticklabel_format(axis="x", useOffset=False)


def _description(drawn: Sequence[Panel]) -> str:
    runs = " or ".join(f"{n}" for n in sorted({len(s.values) for p in drawn for s in p.strips}))
    medians = "; ".join(
        f"{panel.title}: " + ", ".join(_said(strip) for strip in panel.strips) for panel in drawn
    )
    text = (
        f"All {runs} runs of each algorithm, from the lowest to the highest, with the middle half "
        f"and the median, against what is printed. Medians: {medians}."
    )
    if any((strip.values == 0).any() for panel in drawn for strip in panel.strips):
        text += " Values of exactly 0, which have no logarithm, stand at the mark 0."
    return text


def _said(strip: Strip) -> str:
    printed = "".join(
        f" ({SAYS[name]} {number(value)})"
        for name, value in strip.printed.items()
        if name != "best"
    )
    return f"{strip.algorithm} {number(float(strip.quantiles[2]))}{printed}"


def _frame(drawn: Sequence[Panel]) -> pd.DataFrame:
    headings = (
        *("problem", "unit", "algorithm", "runs", "lowest", "lower quartile", "median"),
        *("upper quartile", "highest", "zeros", *SAYS.values()),
    )
    rows = [
        (panel.title, panel.unit, strip.algorithm, len(strip.values), *strip.quantiles,
         int((strip.values == 0).sum()), *map(strip.printed.get, SAYS))
        for panel in drawn
        for strip in panel.strips
    ]  # fmt: skip
    frame = pd.DataFrame(rows, columns=list(headings))
    return frame.astype(dict.fromkeys(SAYS.values(), float))
