"""`results.plot`: the figures of the pages, on axes of matplotlib."""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Protocol

import matplotlib as mpl
import pandas as pd
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from repro.errors import InputError
from repro.report.drawings.convergence import curve_of, draw_curves
from repro.report.drawings.distribution import Panel, Strip, draw_strips
from repro.report.drawings.ranks import rank_plot
from repro.report.drawings.style import CURVE_POINTS, WIDTH
from repro.report.plain_rows import FRIEDMAN
from repro.runs.raw_runs import PROTOCOL
from repro.statistics.friedman import Friedman

HEIGHT = 2.6  # in, of a panel that stands alone


class Shows(Protocol):
    """Results that can be drawn."""

    @property
    def tests(self) -> pd.DataFrame:
        """Rank-sum tests and ranks."""

    def runs(self, key: str) -> pd.DataFrame:
        """Return every finished run of a paper."""

    def algorithms(self, key: str, experiment: str, *, study: str = PROTOCOL) -> list[str]:
        """Return the algorithms of an experiment whose curves there are."""

    def figure(self, key: str, label: str) -> Figure:
        """Return a figure of a paper's page."""

    def curves(
        self, key: str, experiment: str, problem: str, algorithm: str, *, study: str = PROTOCOL
    ) -> pd.DataFrame:
        """Return the best cost of every run after each iteration."""


@dataclass(frozen=True, slots=True)
class Plots:
    """Drawings of results; each returns its axes, on `ax` or on a new figure of pyplot."""

    results: Shows

    def runs(
        self, key: str, experiment: str, problem: str, *,
        study: str = PROTOCOL, ax: Axes | None = None,
    ) -> Axes:  # fmt: skip
        """Draw how the runs of every algorithm are spread: all, the middle half, the median."""
        own = _of(self.results.runs(key), study=study, experiment=experiment, problem=problem)
        strips = tuple(
            Strip(algorithm=name, values=group["cost"].to_numpy(), printed={})
            for name, group in own.groupby("algorithm", sort=False)
        )
        axes = _new() if ax is None else ax
        with _as_written():
            draw_strips(axes, Panel(title=problem, unit="", strips=strips))
            axes.set_xlabel("final cost")
        return axes

    def convergence(
        self, key: str, experiment: str, problem: str, *,
        algorithms: Sequence[str] = (), study: str = PROTOCOL, ax: Axes | None = None,
    ) -> Axes:  # fmt: skip
        """Draw the median run of every algorithm in its range, the first repeat; of a store only.

        `algorithms` are all that have runs where none is named.
        """
        names = list(algorithms or self.results.algorithms(key, experiment, study=study))
        curves = {}
        for name in names:
            frame = self.results.curves(key, experiment, problem, name, study=study)
            first = frame.loc[frame.index.get_level_values("repeat").min()]
            curves[name] = curve_of(first.to_numpy(), CURVE_POINTS)
        axes = _new() if ax is None else ax
        with _as_written():
            draw_curves(axes, curves, names)
            axes.set(xlabel="iteration", ylabel="best cost", title=problem)
            axes.legend(axes.lines[-len(names) :], names, frameon=False)
        return axes

    def figure(self, key: str, label: str) -> list[Axes]:
        """Draw a figure that the paper's page draws, Fig. 2 say, of a store only."""
        return list(self.results.figure(key, label).axes)

    def ranks(self, key: str, experiment: str) -> Axes:
        """Draw average ranks, with bars over those that Nemenyi's test does not tell apart."""
        own = _of(self.results.tests, paper=key, test=FRIEDMAN, experiment=experiment)
        first = own.iloc[0]
        found = Friedman(
            ranks=tuple(own["rank"]),
            p=first["p"],
            critical_difference=first["critical_difference"],
            problems=int(first["problems"]),
        )
        with _as_written():
            plot = rank_plot(tuple(own["algorithm"]), found, {}, canvas=_canvas)
        axes: Axes = plot.canvas.axes[0]
        return axes


def _of(frame: pd.DataFrame, **names: str) -> pd.DataFrame:
    """Return the rows of these names; InputError where there are none."""
    left = frame
    for column, name in names.items():
        found = left[left[column] == name]
        if found.empty:
            known = ", ".join(dict.fromkeys(map(str, left[column]))) or "none"
            message = f"no {column} {name!r}; there are: {known}"
            raise InputError(message)
        left = found
    return left


def _as_written() -> AbstractContextManager[None]:
    """Let a dollar in a name be a dollar."""
    settings: AbstractContextManager[None] = mpl.rc_context({"text.parse_math": False})
    return settings


def _new() -> Axes:
    axes: Axes = _canvas(HEIGHT).subplots()
    return axes


def _canvas(height: float) -> Figure:
    """Return a figure that pyplot, and with it a notebook, knows."""
    figure: Figure = plt.figure(figsize=(WIDTH, height))
    return figure
