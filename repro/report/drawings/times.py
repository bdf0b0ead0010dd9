"""Times of a motion on one axis: what is printed, what comes out, and what is proved."""

import math
from collections.abc import Iterator

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from repro.judge.proved_times import ProvedTime
from repro.judge.times_beside import TimeBeside, TimesBeside
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

NAMES = 1.55  # in, for the names of the searches
LINE = 0.4  # in, from one search to the next
DIGITS = 5
BREAKS = "Times left of the line break a printed limit"
PRINTED: Style = {"color": "#000000", "marker": "o", "markersize": 7, "fillstyle": "none",
                  "linestyle": "none"}  # fmt: skip
RERUN: Style = {"color": COLOURS[0], "marker": "D", "markersize": 5, "linestyle": "none"}
BASELINE: Style = {"color": COLOURS[1], "marker": "s", "markersize": 5, "linestyle": "none"}
PROVED: Style = {"color": COLOURS[2], "linewidth": 2.0}
READING: Style = {"color": COLOURS[2], "linewidth": 1.2, "linestyle": (0, (3, 2))}
BETWEEN: Style = {"color": "#000000", "alpha": 0.5, "linewidth": 0.8}
HEADINGS = ("search", "kind", "time [s]", "low [s]", "high [s]")


def times_plot(found: TimesBeside) -> Plot:
    """Return the drawing: a line a search, from its printed to its re-run time."""
    legend = list(_legend(found))
    above = legend_height(legend) + 0.1
    total = above + LINE * len(found.rows) + BOTTOM
    canvas = empty(total)
    axes = canvas.add_axes((
        NAMES / WIDTH, BOTTOM / total, 1 - (NAMES + RIGHT) / WIDTH, LINE * len(found.rows) / total,
    ))  # fmt: skip
    draw_legend(canvas, legend)
    plain(axes)
    for time in found.proved.readings:
        axes.axvline(time, **READING)
    axes.axvline(_least(found.proved), **PROVED)
    for y, row in enumerate(found.rows):
        _row(axes, y, row)
    axes.margins(x=0.06)
    axes.set_ylim(len(found.rows) - 0.5, -0.5)
    axes.set_yticks(
        range(len(found.rows)), [row.name.replace(" (", "\n(", 1) for row in found.rows]
    )
    axes.set_xlabel("whole time of the motion [s]")
    return Plot(canvas=canvas, description=_description(found), frame=_frame(found))


def _legend(found: TimesBeside) -> Iterator[Line2D]:
    yield Line2D([], [], label="printed", **PRINTED)
    if any(row.value is not None and not row.baseline for row in found.rows):
        yield Line2D([], [], label="re-run", **RERUN)
    if any(row.baseline for row in found.rows):
        yield Line2D([], [], label="baseline", **BASELINE)
    yield Line2D([], [], label=_proved_words(found.proved), **PROVED)
    if found.proved.readings:
        yield Line2D([], [], label="least under another reading", **READING)


def _proved_words(proved: ProvedTime) -> str:
    kind = "proved least" if proved.least is not None else "proved bound"
    return f"{kind}: {number(_least(proved))} s"


def _least(proved: ProvedTime) -> float:
    known = proved.bound if proved.least is None else proved.least
    return math.nan if known is None else known


def _row(axes: Axes, y: int, row: TimeBeside) -> None:
    style = BASELINE if row.baseline else RERUN
    if row.interval and all(map(math.isfinite, row.interval)):
        axes.plot(row.interval, [y, y], color=style["color"], linewidth=2.5)
    if row.printed is not None and row.value is not None:
        axes.plot([row.printed, row.value], [y, y], **BETWEEN)
    if row.value is not None:
        axes.plot([row.value], [y], **style)
    if row.printed is not None:
        axes.plot([row.printed], [y], **PRINTED)


def _description(found: TimesBeside) -> str:
    readings = ", ".join(f"{number(time, DIGITS)} s" for time in found.proved.readings)
    return (
        f"{'; '.join(map(_in_words, found.rows))}; {_proved_words(found.proved)}"
        + (f", under other readings of the motion {readings}" if readings else "")
        + (f". {BREAKS}." if found.breaks_limits else ".")
    )


def _in_words(row: TimeBeside) -> str:
    parts = [] if row.printed is None else [f"printed {row.printed:.10g} s"]
    if row.value is not None:
        parts.append(f"{'mean' if row.baseline else 're-run'} {number(row.value, DIGITS)} s")
    if row.interval:
        low, high = (number(end, DIGITS) for end in row.interval)
        parts[-1] += f" ({low} to {high} s)" if low != high else ""
    return f"{row.name} {', '.join(parts)}"


def _frame(found: TimesBeside) -> pd.DataFrame:
    proved = found.proved
    rows: list[tuple[object, ...]] = []
    for row in found.rows:
        if row.printed is not None:
            rows.append((row.name, "printed", row.printed, None, None))
        if row.value is not None:
            kind = "baseline" if row.baseline else "re-run"
            rows.append((row.name, kind, row.value, *(row.interval or (None, None))))
    kind = "proved minimum" if proved.least is not None else "proved bound"
    rows.append(("", kind, _least(proved), None, None))
    rows += [("", "proved minimum, other reading", time, None, None) for time in proved.readings]
    return pd.DataFrame(rows, columns=list(HEADINGS))
