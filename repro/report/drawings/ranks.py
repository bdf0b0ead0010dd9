"""Average ranks on a line, with bars over those that Nemenyi's test does not tell apart."""

import math
from collections.abc import Callable, Mapping, Sequence
from textwrap import fill

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from repro.report.drawings.style import RIGHT, TOP, WIDTH, Plot, Style, empty
from repro.statistics.friedman import Friedman, not_told_apart

LINE = 0.24  # in, from one name to the next
BAR = 0.1  # in, from one bar to the next
ABOVE = 0.62  # in, for the numbers of the axis and the bar of the critical difference
MORE = 0.16  # in, for each further line of a long name
MARGIN = 1.35  # in, on either side, for the names
LETTERS = 17  # that fit there
THIN: Style = {"color": "#000000", "linewidth": 0.8, "solid_capstyle": "butt"}
THICK: Style = {"color": "#D55E00", "linewidth": 3.2, "solid_capstyle": "butt"}


def rank_plot(
    names: Sequence[str],
    found: Friedman,
    printed: Mapping[str, str],
    *,
    canvas: Callable[[float], Figure] = empty,
) -> Plot:
    """Return the critical-difference diagram of Demšar (2006), the lowest rank at the left.

    `canvas` makes a figure of our width and a height in inches.
    """
    order = sorted(range(len(names)), key=lambda k: found.ranks[k])
    groups = not_told_apart(found.ranks, found.critical_difference)
    left = order[: math.ceil(len(order) / 2)]
    top = ABOVE + BAR * (len(groups) + 1)
    texts = [
        fill(f"{name} {rank:.2f}", LETTERS) for name, rank in zip(names, found.ranks, strict=True)
    ]
    line = LINE + MORE * max(text.count("\n") for text in texts)
    height = 2 * TOP + top + line * len(left)
    drawn = canvas(height)
    axes = drawn.add_axes((MARGIN / WIDTH, 0, 1 - (2 * MARGIN + RIGHT) / WIDTH, 1 - TOP / height))
    axes.set(xlim=(1, len(names)), ylim=(height - TOP, 0))
    axes.axis("off")
    _draw_axis(axes, len(names), found.critical_difference)
    for level, group in enumerate(groups, start=1):
        ends = [found.ranks[k] for k in (group[0], group[-1])]
        axes.plot(ends, [ABOVE + BAR * level] * 2, clip_on=False, **THICK)
    sides = ((left, 0.0, "right"), (order[: len(left) - 1 : -1], 1.0, "left"))
    for side, edge, alignment in sides:
        for row, k in enumerate(side):
            _draw_name(axes, texts[k], found.ranks[k],
                       y=top + line * (row + 0.5), edge=edge, alignment=alignment)  # fmt: skip
    return Plot(
        canvas=drawn,
        description=_description(names, order, found, groups),
        frame=_frame(names, order, found, printed),
    )


def _draw_axis(axes: Axes, algorithms: int, difference: float) -> None:
    axes.plot([1, algorithms], [ABOVE] * 2, clip_on=False, **THIN)
    for rank in range(1, algorithms + 1):
        axes.plot([rank] * 2, [ABOVE - 0.06, ABOVE], clip_on=False, **THIN)
        axes.text(rank, ABOVE - 0.09, f"{rank}", ha="center", va="bottom")
    axes.plot([1, 1 + difference], [0.24] * 2, clip_on=False, **THICK)
    axes.text(1, 0.19, f"critical difference {difference:.2f}", ha="left", va="bottom")


def _draw_name(
    axes: Axes, text: str, rank: float, *, y: float, edge: float, alignment: str
) -> None:
    low, high = axes.get_xlim()
    end = low + edge * (high - low)
    axes.plot([rank, rank, end], [ABOVE, y, y], clip_on=False, **THIN)
    axes.annotate(
        text, (end, y), xytext=(6 if edge else -6, 0), textcoords="offset points",
        ha=alignment, va="center", annotation_clip=False,
    )  # fmt: skip


def _description(
    names: Sequence[str], order: Sequence[int], found: Friedman, groups: Sequence[Sequence[int]]
) -> str:
    ranks = ", ".join(f"{names[k]} {found.ranks[k]:.2f}" for k in order)
    alike = "; ".join(", ".join(names[k] for k in group) for group in groups)
    return (
        f"Average ranks over {found.problems} problems by mean cost, 1 for the lowest: {ranks}. "
        f"By Nemenyi's test ranks differ at the 5 % level from {found.critical_difference:.2f} on. "
        + (f"Not told apart: {alike}." if groups else "All are told apart.")
    )


def _frame(
    names: Sequence[str], order: Sequence[int], found: Friedman, printed: Mapping[str, str]
) -> pd.DataFrame:
    ordered = [names[k] for k in order]
    return pd.DataFrame({
        "algorithm": ordered,
        "average rank": [found.ranks[k] for k in order],
        "printed average rank": [printed.get(name, "") for name in ordered],
        "critical difference": found.critical_difference,
    })  # fmt: skip
