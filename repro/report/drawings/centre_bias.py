"""Ratios of errors with the optimum off the centre: a line per algorithm, a mark per shift."""

from collections.abc import Callable, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from repro.judge.centre_bias import FLAG, Bias
from repro.report.drawings.convergence import CostScale
from repro.report.drawings.style import (
    BOTTOM,
    COLOURS,
    RIGHT,
    WIDTH,
    Plot,
    Style,
    draw_legend,
    empty,
    legend_height,
    plain,
)
from repro.report.words import number

MARKERS = ("o", "s", "D")  # one per size of shift, from the smallest on
NAMES = 1.75  # in, for the names of the algorithms
LINE = 0.42  # in, from one algorithm to the next
APART = 0.22  # of a line, from one shift to the next
FLAG_LINE: Style = {"color": "#000000", "linestyle": (0, (4, 2)), "linewidth": 1.0}


def bias_plot(
    names: Sequence[str], found: Sequence[Bias], *, canvas: Callable[[float], Figure] = empty
) -> Plot:
    """Return the drawing of all ratios with their intervals, and the line from which one flags.

    `canvas` makes a figure of our width and a height in inches.
    """
    shifts = sorted({bias.shift for bias in found})
    legend = [
        Line2D([], [], linestyle="none", label=f"shift {shift:g}", **_mark(k))
        for k, shift in enumerate(shifts)
    ]
    above = legend_height(legend) + 0.25
    total = above + LINE * len(names) + BOTTOM
    drawn = canvas(total)
    axes = drawn.add_axes(
        (NAMES / WIDTH, BOTTOM / total, 1 - (NAMES + RIGHT) / WIDTH, LINE * len(names) / total)
    )
    draw_legend(drawn, legend)
    plain(axes)
    scale = _scale(found)
    for bias in found:
        k = shifts.index(bias.shift)
        y = names.index(bias.algorithm) + APART * (k - (len(shifts) - 1) / 2)
        style = _mark(k)
        axes.plot(np.log10(bias.interval), [y, y], color=style["color"], linewidth=1.0)
        axes.plot([np.log10(bias.ratio)], [y], linestyle="none", **style)
    _finish(axes, names, scale)
    return Plot(canvas=drawn, description=_description(names, found), frame=_frame(found))


def _mark(k: int) -> Style:
    return {"color": COLOURS[k], "marker": MARKERS[k % len(MARKERS)], "markersize": 5.0}


def _scale(found: Sequence[Bias]) -> CostScale:
    """Return a scale on which 1 and the flag stand as well as every interval."""
    logs = np.log10([end for bias in found for end in (*bias.interval, bias.ratio)])
    return CostScale(
        logarithmic=True,
        lowest=min(-0.3, float(logs.min())),
        highest=max(np.log10(FLAG) + 0.3, float(logs.max())),
    )


def _finish(axes: Axes, names: Sequence[str], scale: CostScale) -> None:
    flag = float(np.log10(FLAG))
    axes.axvline(flag, **FLAG_LINE)
    axes.annotate(
        f"{FLAG:g}: centre bias", (flag, 1), xycoords=("data", "axes fraction"),
        xytext=(3, 3), textcoords="offset points", ha="left", va="bottom",
    )  # fmt: skip
    space = 0.04 * (scale.highest - scale.lowest)
    axes.set_xlim(scale.lowest - space, scale.highest + space)
    ticks = scale.ticks()
    axes.set_xticks(list(ticks), list(ticks.values()))
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_yticks(range(len(names)), names)
    axes.set_xlabel("mean error shifted / in place, geometric mean")


def _description(names: Sequence[str], found: Sequence[Bias]) -> str:
    ratios = "; ".join(
        f"{name} "
        + ", ".join(
            f"{number(bias.ratio, 3)} at {bias.shift:g}" for bias in found if bias.algorithm == name
        )
        for name in names
    )
    flagged = dict.fromkeys(bias.algorithm for bias in found if bias.flagged)
    return (
        "Mean error with the optimum moved aside over mean error in place, geometric mean over the "
        "functions, with the 95 % interval, by size of shift in half widths of the box. "
        f"{ratios}. Above {FLAG:g} an algorithm counts as biased to the centre: "
        f"{', '.join(flagged) or 'none'}."
    )


def _frame(found: Sequence[Bias]) -> pd.DataFrame:
    headings = ("algorithm", "shift", "problem", "ratio", "low", "high", "p by Holm")
    rows: list[tuple[object, ...]] = []
    for bias in found:
        place = (bias.algorithm, bias.shift)
        rows.append((*place, "geometric mean", bias.ratio, *bias.interval, bias.p))
        rows += [(*place, name, ratio, None, None, None) for name, ratio in bias.ratios.items()]
    return pd.DataFrame(rows, columns=list(headings))
