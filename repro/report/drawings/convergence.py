"""Best cost against iterations: the median run of every algorithm in its range over the runs."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.functions import BenchmarkProblem
from repro.model.evidence import Evidence
from repro.model.figures import Convergence
from repro.report.drawings.style import (
    CURVE_POINTS,
    Plot,
    Style,
    line_style,
    name_left_axis,
    panels_two_abreast,
)
from repro.report.words import number

Vector = NDArray[np.float64]
MOST_POINTS = 3000  # in all curves together, which keeps a drawing of many panels light
HEADINGS = ("problem", "algorithm", "iteration", "lowest", "median", "highest")
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """Best cost over the runs at some iterations: lowest, median, highest; each shape (n,)."""

    iterations: Vector
    lowest: Vector
    median: Vector
    highest: Vector
    runs: int


Panels = Mapping[str, Mapping[str, Curve]]


@dataclass(frozen=True, slots=True, kw_only=True)
class CostScale:
    """Where a cost stands on the axis: at its decimal logarithm, and at `zero` if exactly 0.

    `lowest` and `highest` are the logarithms of the least and greatest cost above 0. Where all
    costs lie within one decade, or some below zero, each stands at its own value instead.
    """

    logarithmic: bool
    lowest: float = 0.0
    highest: float = 0.0

    @classmethod
    def of(cls, costs: Vector) -> "CostScale":
        """Return the scale on which these costs are shown."""
        positive = costs[costs > 0]
        if costs.min() < 0 or not positive.size or positive.max() < 10 * positive.min():
            return cls(logarithmic=False)
        low, high = np.log10([positive.min(), positive.max()])
        return cls(logarithmic=True, lowest=float(low), highest=float(high))

    @property
    def zero(self) -> float:
        """Place of a cost of exactly 0: a little below all others."""
        return self.lowest - 0.12 * (self.highest - self.lowest)

    def place(self, costs: Vector) -> Vector:
        """Return the position of each cost on the axis, same shape."""
        if not self.logarithmic:
            return costs
        return np.log10(costs, out=np.full_like(costs, self.zero), where=costs > 0)

    def ticks(self) -> dict[float, str]:
        """Return the label at each marked position of a logarithmic axis, 0 aside."""
        extent = self.highest - self.lowest
        if extent < 2:
            return self._ticks_within_decades()
        steps = (s * 10**k for k in range(4) for s in (1, 2, 3, 5))
        step = next(s for s in steps if extent <= 5 * s)
        first = math.ceil(self.lowest / step) * step
        return {
            float(k): _power_of_ten(k) for k in range(first, math.floor(self.highest) + 1, step)
        }

    def _ticks_within_decades(self) -> dict[float, str]:
        decades = range(math.floor(self.lowest), math.ceil(self.highest) + 1)
        marks = {math.log10(m) + k: (m, k) for k in decades for m in (1, 2, 5)}
        return {
            place: f"{m * 10.0**k:g}" if -4 < k < 4 else _power_of_ten(k, m)
            for place, (m, k) in marks.items()
            if self.lowest <= place <= self.highest
        }


def _power_of_ten(k: int, m: int = 1) -> str:
    power = f"10{str(k).translate(_SUPERSCRIPT)}"
    return power if m == 1 else f"{m}×{power}"


def convergence_plot(figure: Convergence, evidence: Evidence) -> Plot | None:
    """Return the drawing of an experiment's first repeat, or None where nothing was run."""
    curves, missing = _curves(figure, evidence)
    if not curves:
        return None
    experiment = evidence.experiment(figure.experiment)
    names = tuple(experiment.algorithms)
    legend = [
        Line2D([], [], label=name, **_style(name, names, experiment.proposed))
        for name in names
        if any(name in panel for panel in curves.values())
    ]
    canvas, places = panels_two_abreast(len(curves), height=1.7, legend=legend, gaps=(0.62, 0.62))
    for axes, (problem, panel) in zip(places, curves.items(), strict=True):
        draw_curves(axes, panel, names, experiment.proposed)
        axes.set_title(problem)
    bare = all(isinstance(experiment.problems[name], BenchmarkProblem) for name in curves)
    for axes in places[::2]:
        name_left_axis(axes, "best cost (no unit)" if bare else "best cost")
    for axes in places[-2:]:
        axes.set_xlabel("iteration")
    return Plot(canvas=canvas, description=_description(curves, missing), frame=_frame(curves))


def _curves(figure: Convergence, evidence: Evidence) -> tuple[Panels, list[str]]:
    experiment = evidence.experiment(figure.experiment)
    count = len(experiment.problems) * len(experiment.algorithms)
    points = max(10, min(CURVE_POINTS, MOST_POINTS // count))
    curves: dict[str, dict[str, Curve]] = {}
    missing = []
    for problem in experiment.problems:
        for algorithm in experiment.algorithms:
            runs = evidence.runs.get((experiment.name, problem, algorithm))
            if runs is None:
                missing.append(f"{algorithm} on {problem}")
            else:
                curves.setdefault(problem, {})[algorithm] = curve_of(runs.histories[0], points)
    return curves, missing


def curve_of(histories: Vector, points: int) -> Curve:
    """Return the curve of histories (runs, iterations), thinned out to that many points."""
    known = np.flatnonzero(np.isfinite(histories).all(axis=0))  # a search may start without a cost
    picked = known[np.unique(np.linspace(0, len(known) - 1, points).round().astype(int))]
    costs = histories[:, picked]
    return Curve(
        iterations=picked + 1.0,
        lowest=costs.min(axis=0),
        median=np.median(costs, axis=0),
        highest=costs.max(axis=0),
        runs=len(histories),
    )


def _style(algorithm: str, names: Sequence[str], proposed: str = "") -> Style:
    """Return how an algorithm is drawn: the proposed one wider and on top."""
    style = line_style(names.index(algorithm))
    if algorithm == proposed:
        style |= {"linewidth": 2.4, "zorder": 3}
    return style


def draw_curves(
    axes: Axes, panel: Mapping[str, Curve], names: Sequence[str], proposed: str = ""
) -> None:
    """Draw one curve an algorithm; `names` are all that have a style, in their order."""
    costs = np.concatenate([np.concatenate([c.lowest, c.highest]) for c in panel.values()])
    scale = CostScale.of(costs)
    for algorithm, curve in panel.items():
        style = _style(algorithm, names, proposed)
        low, middle, high = map(scale.place, (curve.lowest, curve.median, curve.highest))
        axes.fill_between(
            curve.iterations, low, high, color=style["color"], alpha=0.18, linewidth=0
        )
        axes.plot(curve.iterations, middle, **style)
    axes.set_xlim(left=0)
    axes.locator_params(axis="x", nbins=5)
    if scale.logarithmic:
        ticks = scale.ticks() | ({scale.zero: "0"} if (costs == 0).any() else {})
        axes.set_yticks(list(ticks), list(ticks.values()))
    elif costs.min() == costs.max():
        axes.set_yticks(costs[:1], [number(float(costs[0]))])
    else:
        axes.locator_params(axis="y", nbins=5)


def _description(curves: Panels, missing: Sequence[str]) -> str:
    every = [curve for panel in curves.values() for curve in panel.values()]
    runs = " or ".join(str(n) for n in sorted({curve.runs for curve in every}))
    last = " or ".join(str(n) for n in sorted({int(curve.iterations[-1]) for curve in every}))
    finals = "; ".join(
        f"{problem}: "
        + ", ".join(f"{name} {number(float(curve.median[-1]))}" for name, curve in panel.items())
        for problem, panel in curves.items()
    )
    text = f"Best cost against iterations, {_lines(runs)} after {last} iterations: {finals}."
    if any((curve.lowest == 0).any() for curve in every):
        text += " Costs of exactly 0, which have no logarithm, are drawn at the mark 0."
    if missing:
        text += f" No runs yet of {', '.join(missing)}."
    return text


def _lines(runs: str) -> str:
    if runs == "1":
        return "a line for the one run. Cost"
    return f"a line for the median of {runs} runs in a band from the lowest to the highest. Median"


def _frame(curves: Panels) -> pd.DataFrame:
    parts = [
        pd.DataFrame(
            dict(zip(HEADINGS, (problem, algorithm, curve.iterations.astype(int), *costs),
                     strict=True))
        )
        for problem, panel in curves.items()
        for algorithm, curve in panel.items()
        for costs in [(curve.lowest, curve.median, curve.highest)]
    ]  # fmt: skip
    return pd.concat(parts, ignore_index=True)
