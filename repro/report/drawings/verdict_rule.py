"""The rule of verdicts as pictures: a prediction interval beside what is accepted and printed."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes

from repro.judge.verdict import Verdict
from repro.model.tolerances import Interval
from repro.report.drawings.convergence import CostScale
from repro.report.drawings.style import COLOURS, RIGHT, WIDTH, Plot, Style, empty

PRINTED = 10.0
ROUNDING = 0.1
ACCEPTED: Interval = (8.0, 12.0)
SCALE: Interval = (2.0, 20.0)
NAMES = 1.45  # in, to the left of the bars
LINE = 0.3  # in, from bar to bar
BELOW = 0.24  # in, for the words under the bars
INK = "#000000"  # becomes the page's own text colour
BAND: Style = {"color": COLOURS[2], "alpha": 0.3, "linewidth": 0}
BAR: Style = {"color": COLOURS[0], "linewidth": 5, "solid_capstyle": "butt"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Example:
    """An invented number with its verdict; `reading` is the interval under another reading."""

    verdict: Verdict
    measured: Interval
    says: str
    reading: Interval | None = None


EXAMPLES = (
    Example(
        verdict=Verdict.REPRODUCED,
        measured=(9.0, 11.3),
        says="The whole interval lies within what is accepted.",
    ),
    Example(
        verdict=Verdict.CONSISTENT,
        measured=(5.0, 16.0),
        says="The printed number lies in the interval, which reaches beyond what is accepted.",
    ),
    Example(
        verdict=Verdict.UNDECIDED,
        measured=(11.0, 16.0),
        says="The printed number lies outside the interval, which still meets what is accepted.",
    ),
    Example(
        verdict=Verdict.CONTRADICTED,
        measured=(14.0, 18.0),
        says="The interval and what is accepted do not meet, and no reading that was tried "
        "changes that.",
    ),
    Example(
        verdict=Verdict.DEPENDS,
        measured=(14.0, 18.0),
        reading=(8.6, 13.2),
        says="The interval of the re-run does not meet what is accepted, that of another reading "
        "holds the printed number.",
    ),
)


def verdict_plot(example: Example) -> Plot:
    """Return the picture of one verdict: interval, accepted band and printed number."""
    bars = [("re-run", example.measured)]
    if example.reading:
        bars.append(("other reading", example.reading))
    height = LINE * (len(bars) + 1) + BELOW
    canvas = empty(height)
    axes = canvas.add_axes((NAMES / WIDTH, 0, 1 - (NAMES + RIGHT) / WIDTH, 1))
    axes.set(xlim=SCALE, ylim=(height, 0))
    axes.axis("off")
    bottom = LINE * (len(bars) + 1)
    axes.fill_between(ACCEPTED, 0, bottom, **BAND)
    axes.plot([PRINTED] * 2, [0, bottom], color=INK, linewidth=1.2)
    _name(axes, "accepted", LINE / 2)
    for line, (name, ends) in enumerate(bars, start=1):
        axes.plot(ends, [LINE * (line + 0.5)] * 2, **BAR)
        _name(axes, name, LINE * (line + 0.5))
    axes.text(PRINTED, height, "printed", ha="center", va="bottom", color=INK)
    return Plot(
        canvas=canvas,
        description=f"{example.says} Printed {PRINTED:g}, accepted {ACCEPTED[0]:g} to "
        f"{ACCEPTED[1]:g}; " + "; ".join(f"{n} {a:g} to {b:g}" for n, (a, b) in bars) + ".",
        frame=pd.DataFrame(),
    )


def _name(axes: Axes, text: str, y: float) -> None:
    axes.annotate(
        text, (SCALE[0], y), xytext=(-8, 0), textcoords="offset points",
        ha="right", va="center", annotation_clip=False,
    )  # fmt: skip


def draw_verdict(
    axes: Axes, *, measured: Interval, accepted: Interval, printed: float | None
) -> None:
    """Draw one interval under what is accepted; an end that there is not is the axes' own."""
    ends = [*measured, *accepted, *([] if printed is None else [printed])]
    finite = np.array([end for end in ends if np.isfinite(end)])
    scale = CostScale.of(finite)
    low, high = (float(f(scale.place(finite))) for f in (np.min, np.max))
    room = 0.1 * (high - low) or 1.0

    def places(interval: Interval) -> list[float]:
        bounds = (low - room, high + room)
        return [
            float(scale.place(np.array([end]))[0]) if np.isfinite(end) else bounds[end > 0]
            for end in interval
        ]

    axes.fill_between(places(accepted), 0.0, 2.0, **BAND)
    axes.plot(places(measured), [0.5] * 2, **BAR)
    if printed is not None:
        axes.plot(places((printed, printed)), [0.0, 2.0], color=INK, linewidth=1.2)
    axes.set(xlim=(low - room, high + room), ylim=(0.0, 2.0))
    axes.set_yticks([0.5, 1.5], ["re-run", "accepted"])
    if scale.logarithmic:
        ticks = scale.ticks()
        axes.set_xticks(list(ticks), list(ticks.values()))
