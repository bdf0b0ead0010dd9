"""`repro.load`: what a reports folder or a store holds, as DataFrames."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Protocol

import pandas as pd
from matplotlib.figure import Figure

from repro.commands.catalogue import found_papers
from repro.commands.plots import Marks, Plots, marks_of_findings
from repro.commands.stored_results import Stored
from repro.errors import InputError
from repro.judge.centre_bias import Bias
from repro.report.drawings.style import Plot
from repro.report.frames import (
    audit_frame,
    certificates_frame,
    findings_frame,
    frame_of_tests,
    runs_frame,
    standings_frame,
)
from repro.report.results import SCHEMA, Json, read_json, read_results
from repro.report.run_files import place_of_biases, place_of_runs, read_biases, read_runs
from repro.runs.raw_runs import PROTOCOL
from repro.runs.store.settled import NAME

RESULTS = "results.json"


class Place(Protocol):
    """Where results come from: entries of results.json, runs and curves."""

    @property
    def place(self) -> Path:
        """The folder."""

    @property
    def keys(self) -> tuple[str, ...]:
        """The papers of which something may be had."""

    def entries(self) -> list[Json]:
        """Return what results.json says of each paper."""

    def runs(self, key: str) -> pd.DataFrame:
        """Return every finished run of a paper."""

    def algorithms(self, key: str, experiment: str, study: str) -> list[str]:
        """Return the algorithms of an experiment whose curves there are."""

    def figure(self, key: str, label: str) -> Plot:
        """Return a declared figure of a paper, drawn."""

    def marks(self, key: str, experiment: str, problem: str) -> Marks:
        """Return the printed costs on a problem by algorithm and statistic."""

    def biases(self, key: str, experiment: str) -> list[Bias]:
        """Return what moved optima do to each algorithm of an experiment."""

    def curves(self, key: str, cell: tuple[str, str, str], study: str) -> pd.DataFrame:
        """Return the best cost of every run after each iteration."""


@dataclass(frozen=True)
class Results:
    """Results as DataFrames, each read when it is first asked for; docs/data.md has the columns."""

    source: Place = field(repr=False)

    @property
    def papers(self) -> tuple[str, ...]:
        """The keys of the papers."""
        return self.source.keys

    @cached_property
    def _entries(self) -> list[Json]:
        return self.source.entries()

    @cached_property
    def findings(self) -> pd.DataFrame:
        """A row for each printed number or sentence, with its verdict."""
        return findings_frame(self._entries)

    @cached_property
    def audit(self) -> pd.DataFrame:
        """A row for each thing that the printed tables say about themselves."""
        return audit_frame(self._entries)

    @cached_property
    def certificates(self) -> pd.DataFrame:
        """A row for each motion whose least time was asked for."""
        return certificates_frame(self._entries)

    @cached_property
    def tests(self) -> pd.DataFrame:
        """A row for each rank-sum test, and for each algorithm's rank by Friedman's test."""
        return frame_of_tests(self._entries)

    @cached_property
    def standings(self) -> pd.DataFrame:
        """A row for each algorithm on each problem, beside the baselines."""
        return standings_frame(self._entries)

    def runs(self, key: str) -> pd.DataFrame:
        """Return a row for each finished run of a paper; InputError for a key without runs."""
        self._checked(key)
        return self.source.runs(key)

    def curves(
        self, key: str, experiment: str, problem: str, algorithm: str, *, study: str = PROTOCOL
    ) -> pd.DataFrame:
        """Return the best cost after each iteration: a row a run, a column an iteration.

        InputError where it is not read from a store, and for a cell that has no run.
        """
        self._checked(key)
        return self.source.curves(key, (experiment, problem, algorithm), study)

    def algorithms(self, key: str, experiment: str, *, study: str = PROTOCOL) -> list[str]:
        """Return the algorithms of an experiment whose curves there are; InputError as `curves`."""
        self._checked(key)
        return self.source.algorithms(key, experiment, study)

    def figure(self, key: str, label: str) -> Figure:
        """Return a figure of a paper's page, of a store only; `axes` of it are its panels."""
        self._checked(key)
        figure: Figure = self.source.figure(key, label).canvas
        return figure

    def marks(self, key: str, experiment: str, problem: str) -> Marks:
        """Return the printed costs on a problem, by algorithm and statistic."""
        self._checked(key)
        return self.source.marks(key, experiment, problem)

    def biases(self, key: str, experiment: str) -> list[Bias]:
        """Return what moved optima do to each algorithm; InputError where none was moved."""
        self._checked(key)
        found = self.source.biases(key, experiment)
        if not found:
            message = f"no optimum of {experiment} of {key} was moved in {self.source.place}"
            raise InputError(message)
        return found

    @property
    def plot(self) -> Plots:
        """The figures of the pages, as axes of matplotlib."""
        return Plots(self)

    def _checked(self, key: str) -> None:
        if key not in self.papers:
            message = f"no paper {key!r} in {self.source.place}; it has {', '.join(self.papers)}"
            raise InputError(message)


def load(place: str | PathLike[str], papers: Iterable[str] = ()) -> Results:
    """Return what a folder of reports, or a store, holds.

    `papers` are keys, files and folders of the papers of a store, by default all that are known
    here. InputError where the folder is neither.
    """
    path = Path(fspath(place))
    folder = path.parent if path.name in {RESULTS, NAME} else path
    if (folder / NAME).exists() and path.name != RESULTS:
        return Results(Stored(place=folder, papers=found_papers(papers)))
    if (results := read_results(folder / RESULTS)) is not None:
        return Results(Reports(place=folder, results=results))
    if (held := read_json(folder / RESULTS)) is not None:
        message = (
            f"{folder / RESULTS} is of schema {held.get('schema')!r:.20}, and this version reads "
            f"{SCHEMA}: `repro report` writes it anew"
        )
        raise InputError(message)
    message = f"{path} is neither a folder of reports with {RESULTS} nor a store with {NAME}"
    raise InputError(message)


@dataclass(frozen=True, slots=True, kw_only=True)
class Reports:
    """A folder that `repro report` wrote."""

    place: Path
    results: Json

    @property
    def keys(self) -> tuple[str, ...]:
        """The papers of results.json."""
        return tuple(entry["key"] for entry in self.results["papers"])

    def entries(self) -> list[Json]:
        """Return the entries of results.json."""
        found: list[Json] = self.results["papers"]
        return found

    def runs(self, key: str) -> pd.DataFrame:
        """Return the published runs; InputError where there is no file of them."""
        published = read_runs(self.place / place_of_runs(key))
        entry = next(entry for entry in self.entries() if entry["key"] == key)
        how: Mapping[str, Any] = entry["provenance"]
        return runs_frame(key, published, how.get("drawn_as", {}), how["master_seed"])

    def algorithms(self, key: str, experiment: str, study: str) -> list[str]:
        """Raise InputError: pages hold no curves."""
        raise self._without_curves(key, experiment, study)

    def curves(self, key: str, cell: tuple[str, str, str], study: str) -> pd.DataFrame:
        """Raise InputError: pages hold no curves."""
        raise self._without_curves(key, "/".join(cell), study)

    def figure(self, key: str, label: str) -> Plot:
        """Raise InputError: pages hold no curves."""
        raise self._without_curves(key, label, PROTOCOL)

    def marks(self, key: str, experiment: str, problem: str) -> Marks:  # noqa: ARG002
        """Return the printed costs as the findings name them, whatever the experiment."""
        entry = next(entry for entry in self.entries() if entry["key"] == key)
        return marks_of_findings(entry["findings"], problem)

    def biases(self, key: str, experiment: str) -> list[Bias]:
        """Return what the table of the page says."""
        return read_biases(self.place / place_of_biases(key, experiment))

    def _without_curves(self, key: str, what: str, study: str) -> InputError:
        return InputError(
            f"curves of {key} ({study}, {what}) are not in {self.place}: "
            'only a store has them, as in repro.load(".repro")'
        )
