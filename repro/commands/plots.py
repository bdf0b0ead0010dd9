"""`results.plot`: the figures of the pages, on axes of matplotlib."""

import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Protocol

import matplotlib as mpl
import pandas as pd
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from repro.errors import InputError
from repro.judge.centre_bias import Bias
from repro.judge.findings import IN_WORDS
from repro.report.drawings.centre_bias import bias_plot
from repro.report.drawings.convergence import curve_of, draw_curves
from repro.report.drawings.distribution import Panel, Strip, draw_strips
from repro.report.drawings.ranks import rank_plot
from repro.report.drawings.style import CURVE_POINTS, WIDTH
from repro.report.drawings.verdict_rule import draw_verdict
from repro.report.plain_rows import FRIEDMAN
from repro.runs.raw_runs import PROTOCOL
from repro.statistics.friedman import Friedman
from repro.tables.printed import Printed

Marks = Mapping[str, Mapping[str, float]]
_COST = re.compile(r"(?:(?P<statistic>mean|best) )?cost of (?P<algorithm>.+) on (?P<problem>.+)")
HEIGHT = 2.6  # in, of a panel that stands alone


class Shows(Protocol):
    """Results that can be drawn."""

    @property
    def tests(self) -> pd.DataFrame:
        """Rank-sum tests and ranks."""

    @property
    def findings(self) -> pd.DataFrame:
        """Printed numbers with their verdicts."""

    def marks(self, key: str, experiment: str, problem: str) -> Marks:
        """Return the printed costs on a problem, by algorithm and statistic."""

    def biases(self, key: str, experiment: str) -> list[Bias]:
        """Return what moved optima do to each algorithm of an experiment."""

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
        """Draw how the runs of every algorithm are spread: all, the middle half, the median.

        Of the protocol's own what is printed is marked, too.
        """
        own = _of(self.results.runs(key), study=study, experiment=experiment, problem=problem)
        marks = self.results.marks(key, experiment, problem) if study == PROTOCOL else {}
        strips = tuple(
            Strip(algorithm=name, values=group["cost"].to_numpy(), printed=marks.get(name, {}))
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

    def centre_bias(self, key: str, experiment: str) -> Axes:
        """Draw how much worse each algorithm gets when the optimum leaves the centre."""
        found = self.results.biases(key, experiment)
        names = tuple(dict.fromkeys(bias.algorithm for bias in found))
        with _as_written():
            plot = bias_plot(names, found, canvas=_canvas)
        axes: Axes = plot.canvas.axes[0]
        return axes

    def verdict(self, key: str, name: str, *, ax: Axes | None = None) -> Axes:
        """Draw the interval of a finding, named by its `id`, the accepted band and the print."""
        one = _of(self.results.findings, paper=key, id=name).iloc[0]
        if pd.isna(one["measured_low"]):
            message = f"{name} of {key} has no interval: {one['verdict']}"
            raise InputError(message)
        printed = None if one["printed"] == IN_WORDS else Printed(one["printed"], one["unit"]).value
        axes = _new() if ax is None else ax
        with _as_written():
            draw_verdict(
                axes, measured=(one["measured_low"], one["measured_high"]),
                accepted=(one["accepted_low"], one["accepted_high"]), printed=printed,
            )  # fmt: skip
            axes.set_title(f"{name}: {one['verdict']}")
        return axes

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


def marks_of_findings(findings: Iterable[Mapping[str, Any]], problem: str) -> Marks:
    """Return the printed costs on a problem, by algorithm and statistic, of rows of findings."""
    found: dict[str, dict[str, float]] = {}
    for one in findings:
        said = _COST.fullmatch(one["measure"] or "")
        if one["table"] and said and said["problem"] == problem:
            marks = found.setdefault(said["algorithm"], {})
            marks[said["statistic"] or "single"] = Printed(one["printed"], one["unit"]).si
    return found


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
