"""Results of papers from a store, read one run at a time."""

import shlex
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import numpy as np
import pandas as pd

from repro.commands.written_pages import judged
from repro.errors import InputError
from repro.judge.centre_bias import Bias, centre_biases
from repro.model.claims import CellClaim
from repro.model.experiment import Experiment
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.report.drawings.distribution import MARKS
from repro.report.drawings.draw import plot_of
from repro.report.drawings.style import Plot, drawing_style
from repro.report.frames import cell_frame, runs_frame
from repro.report.results import Json, paper_result
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.raw_runs import (
    RawRuns,
    drawn_as,
    every_task,
    experiments_of,
    ran_as,
)
from repro.runs.run import Record
from repro.runs.store.store import Store
from repro.runs.studies import Study, studies


class NoRunsError(InputError):
    """A store in which no run is one of a paper as it stands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Stored:
    """A store, and the papers whose runs are looked for in it."""

    place: Path
    papers: Sequence[Paper]

    @property
    def keys(self) -> tuple[str, ...]:
        """The papers that are known here."""
        return tuple(paper.key for paper in self.papers)

    def entries(self) -> list[Json]:
        """Judge every paper by the runs that are there, which may take minutes."""
        with self._opened() as (store, repeats):
            return [
                paper_result(judged(store, paper, plan([paper], repeats)), "")
                for paper in self.papers
            ]

    def runs(self, key: str) -> pd.DataFrame:
        """Return the runs of a paper; no more than one cell is held beside the frame.

        Raises NoRunsError where there are none.
        """
        paper = self._paper(key)
        with self._opened() as (store, repeats):
            besides = studies(paper, repeats)
            parts = list(_parts(store, every_task(paper, repeats), besides))
            if not parts:
                raise self._without_runs(store, key)
        return runs_frame(key, pd.concat(parts, ignore_index=True), drawn_as(paper, besides))

    def figure(self, key: str, label: str) -> Plot:
        """Return a figure of a paper's page, of the protocol's runs; InputError for none."""
        paper = self._paper(key)
        labels = {figure.label: figure for figure in paper.figures}
        if label not in labels:
            message = f"no figure {label!r} of {key}; there are: {', '.join(labels) or 'none'}"
            raise InputError(message)
        with self._opened() as (store, repeats):
            evidence = gather(store, paper, plan([paper], repeats, protocol_only=True))
            if not evidence.runs:
                raise self._without_runs(store, key)
        with drawing_style():
            return plot_of(labels[label], evidence, paper.assumptions)

    def curves(self, key: str, cell: tuple[str, str, str], study: str) -> pd.DataFrame:
        """Return the curves of one cell; InputError where it has no run."""
        paper = self._paper(key)
        experiment, problem, algorithm = cell
        wanted = (ran_as(study, experiment), problem, algorithm)
        with self._opened() as (store, repeats):
            tasks = [
                task for task in every_task(paper, repeats, wanted[0]) if _cell(task) == wanted
            ]
            records = [record for record in store.records(tasks) if record.reason is None]
        if not records:
            message = f"no runs of {'/'.join(wanted)} of {key} in {self.place}"
            raise InputError(message)
        index = pd.MultiIndex.from_tuples(
            [(record.task.repeat, record.task.run) for record in records], names=["repeat", "run"]
        )
        length = max(len(record.history) for record in records)
        columns = pd.RangeIndex(1, length + 1, name="iteration")
        values = np.full((len(records), length), np.nan)
        for line, record in zip(values, records, strict=True):
            line[: len(record.history)] = record.history
        return pd.DataFrame(values, index=index, columns=columns)

    def algorithms(self, key: str, experiment: str, study: str) -> list[str]:
        """Return the algorithms of an experiment; InputError where there is no such one."""
        with self._opened() as (_, repeats):
            known = experiments_of(self._paper(key), repeats)
        name = ran_as(study, experiment)
        if name not in known:
            message = f"no experiment {name!r} of {key}; there are: {', '.join(known)}"
            raise InputError(message)
        return list(known[name].algorithms)

    def marks(self, key: str, experiment: str, problem: str) -> dict[str, dict[str, float]]:
        """Return the printed costs on a problem, as the paper claims them."""
        found: dict[str, dict[str, float]] = {}
        for claim in self._paper(key).claims:
            measure = claim.measure
            if isinstance(claim, CellClaim) and isinstance(measure, Statistic):
                place = (measure.experiment, measure.problem, measure.quantity)
                if place == (experiment, problem, "cost") and measure.statistic in MARKS:
                    found.setdefault(measure.algorithm, {})[measure.statistic] = claim.printed.si
        return found

    def biases(self, key: str, experiment: str) -> list[Bias]:
        """Return what moved optima do to each algorithm, of the runs that there are."""
        paper = self._paper(key)
        with self._opened() as (store, repeats):
            besides = [s for s in studies(paper, max(2, repeats)) if s.kind == "shift"]
            names = {experiment, *(s.experiment.name for s in besides)}
            planned = plan([paper], max(2, repeats))
            evidence = gather(store, paper, (t for t in planned if t.experiment in names), besides)
        biases = centre_biases(paper, evidence)
        return [b for found in biases if found.experiment.name == experiment for b in found.biases]

    def cells(self, key: str) -> Iterator[tuple[Experiment, list[Record]]]:
        """Yield the finished runs of a paper, those of one algorithm on one problem at a time.

        Raises NoRunsError where there are none.
        """
        paper, found = self._paper(key), False
        with self._opened() as (store, repeats):
            known = experiments_of(paper, repeats)
            for (name, *_), group in groupby(every_task(paper, repeats), key=_cell):
                if records := [each for each in store.records(group) if each.reason is None]:
                    found = True
                    yield known[name], records
            if not found:
                raise self._without_runs(store, key)

    def _without_runs(self, store: Store, key: str) -> NoRunsError:
        held = len(store.finished())
        command = shlex.join(["repro", "reproduce", key, "--store", str(self.place)])
        return NoRunsError(
            f"{self.place} has no run of {key} as it stands, and {held} of other papers, of "
            f"compared searches or of earlier code: `{command}` makes them"
        )

    def _paper(self, key: str) -> Paper:
        return next(paper for paper in self.papers if paper.key == key)

    @contextmanager
    def _opened(self) -> Iterator[tuple[Store, int]]:
        """Yield the store, which is only read, and how many repeats it has."""
        with Store(self.place, writing=False) as store:
            yield store, max(1, store.repeats())


def _cell(task: Task) -> tuple[str, str, str]:
    return task.experiment, task.problem, task.algorithm


def _parts(store: Store, tasks: Iterator[Task], besides: Sequence[Study]) -> Iterator[pd.DataFrame]:
    """Yield a frame a cell; names stand in it once."""
    for _, group in groupby(tasks, key=_cell):
        raw = RawRuns(besides)
        for record in store.records(group):
            raw.note(record)
        yield from map(cell_frame, raw.cells())
