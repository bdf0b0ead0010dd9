"""A comparison of a user's searches as files: a page, Markdown, JSON, and CSV of its runs."""

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from repro.judge.comparison import Comparison, Part
from repro.judge.users_search import mean_against_chance
from repro.model.evidence import Evidence
from repro.model.figures import Convergence
from repro.report.drawings.draw import Drawing, draw, drawing
from repro.report.drawings.ecdf import ecdf_plot
from repro.report.drawings.ranks import rank_plot
from repro.report.files import write_file
from repro.report.frames import csv_text
from repro.report.plain_rows import rows_of_standings
from repro.report.rendering import render
from repro.report.views.users_search import users_search_view
from repro.runs.baseline_study import STUDY_OF
from repro.runs.equal_budget import EQUAL_BUDGET
from repro.runs.run import Record
from repro.runs.studies import study_name
from repro.statistics.friedman import Friedman, friedman

SCHEMA = 1
RUN = ("paper", "experiment", "problem", "algorithm", "repeat", "run", "cost", "evaluations",
       "seconds", "reason")  # fmt: skip
MOST_PANELS = 24  # of a drawing of curves: more are no longer looked at


def compared_files(found: Comparison, called: str) -> Mapping[str, str]:
    """Return the text of each file of a comparison by its suffix."""
    context = {
        "name": ", ".join(found.asked.searches),
        "called": called,
        "place": ", ".join(getattr(s, "place", "") for s in found.asked.searches.values()),
        "repeats": found.asked.repeats,
        "papers": _by_paper(found),
        "failed": [(record.task.name, record.reason) for record in found.failed],
        "warnings": found.warnings,
        "missing": found.missing,
        "drawings": _drawings(found),
        "libraries": ", ".join(f"{name} {version}" for name, version in found.libraries.items()),
    }
    return {
        "md": render("compare.md", context),
        "html": render("compare.html", context),
        "json": json.dumps(as_json(found), indent=1, ensure_ascii=False, allow_nan=False) + "\n",
        "csv": csv_text(pd.DataFrame(run_rows(found), columns=list(RUN))),
    }


def write_comparison(folder: Path, called: str, found: Comparison) -> Path:
    """Write a comparison in every form, and return the page's path."""
    for suffix, text in compared_files(found, called).items():
        write_file(folder / f"{called}.{suffix}", text)
    return folder / f"{called}.html"


def as_json(found: Comparison) -> dict[str, Any]:
    """Return everything that a comparison found as plain values."""
    return {
        "schema": SCHEMA,
        "names": list(found.asked.searches),
        "places": {n: getattr(s, "place", "") for n, s in found.asked.searches.items()},
        "repeats": found.asked.repeats,
        "libraries": dict(found.libraries),
        "runs": run_rows(found),
        "standings": [
            {"paper": part.paper.key, **row}
            for part in found.parts
            for row in rows_of_standings([part.found.standings])
        ],
        "tests": list(_tests(found)),
        "warnings": [asdict(warned) for warned in found.warnings],
        "missing": [asdict(each) for each in found.missing],
    }


def run_rows(found: Comparison) -> list[dict[str, Any]]:
    """Return a row for each run of the comparison's own searches; a failed one has a reason."""
    return [_row(record) for record in found.records]


def _row(record: Record) -> dict[str, Any]:
    task = record.task
    return {
        "paper": task.paper, "experiment": task.experiment, "problem": task.problem,
        "algorithm": task.algorithm, "repeat": task.repeat, "run": task.run,
        "cost": record.cost if math.isfinite(record.cost) else None,
        "evaluations": record.evaluations, "seconds": record.seconds, "reason": record.reason,
    }  # fmt: skip


def _tests(found: Comparison) -> Iterator[dict[str, Any]]:
    for part in found.parts:
        for test in part.found.tests:
            yield {
                "paper": part.paper.key, "experiment": part.experiment.name,
                "problem": test.problem, "algorithm": test.own.algorithm,
                "against": test.other.algorithm, "kind": test.other.kind, "p": test.p,
                "holm": test.holm, "wins": test.wins,
                "mean_against_chance": mean_against_chance(test),
            }  # fmt: skip


def _by_paper(found: Comparison) -> list[tuple[Any, list[Any]]]:
    grouped: dict[str, tuple[Any, list[Any]]] = {}
    for part in found.parts:
        grouped.setdefault(part.paper.key, (part.paper, []))[1].append(
            users_search_view(part.found)
        )
    return list(grouped.values())


def _drawings(found: Comparison) -> dict[tuple[str, str], list[Drawing]]:
    """Return the figures of each experiment, by paper and experiment."""
    return {
        (part.paper.key, part.experiment.name): list(_drawn(part, f"c{k}", found))
        for k, part in enumerate(found.parts)
    }


def _drawn(part: Part, identifier: str, found: Comparison) -> Iterator[Drawing]:
    """Yield convergence, targets reached, and average ranks, as far as there are runs."""
    evidence = shown(part, found)
    (experiment,) = evidence.experiments
    name = experiment.name
    if not evidence.runs:
        return
    figure = Convergence(label=name, caption="median run in the range of its runs", experiment=name)
    yield draw(figure, evidence, f"{identifier}v")
    yield drawing(
        lambda: ecdf_plot(experiment, evidence), title=f"{name}: share of targets reached",
        identifier=f"{identifier}e",
    )  # fmt: skip
    names, ranks = average_ranks(evidence)
    if ranks:
        yield drawing(
            lambda: rank_plot(names, ranks, {}), title=f"{name}: average ranks",
            identifier=f"{identifier}r",
        )  # fmt: skip


def shown(part: Part, found: Comparison) -> Evidence:
    """Return the runs that stand beside each other, as of one experiment: searches of all kinds.

    Names are those of the standings; the first of the user's own is drawn as the proposed one.
    """
    standings = part.found.standings
    places = {(row.algorithm, row.kind): None for p in standings.problems for row in p.rows}
    names = {place: _shown_name(*place) for place in places}
    runs = {
        (part.experiment.name, problem, name): part.evidence.runs[cell]
        for place, name in names.items()
        for problem in list(part.experiment.problems)[:MOST_PANELS]
        if (cell := (_study(part, *place), problem, place[0])) in part.evidence.runs
    }
    first = next(iter(found.asked.searches))
    own = next(iter(found.asked.searches.values()))
    known = {name: part.experiment.algorithms.get(place[0], own) for place, name in names.items()}
    problems = dict(list(part.experiment.problems.items())[:MOST_PANELS])
    experiment = replace(
        part.experiment, algorithms={first: own, **known}, proposed=first, problems=problems
    )
    return Evidence(part.paper.key, (experiment,), runs)


def _study(part: Part, algorithm: str, kind: str) -> str:
    """Return the name of the experiment that a standing's runs are of."""
    departs = {"equal evaluations": EQUAL_BUDGET, "baseline": STUDY_OF.get(algorithm)}.get(kind)
    return study_name(part.experiment.name, departs) if departs else part.experiment.name


def _shown_name(algorithm: str, kind: str) -> str:
    return f"{algorithm}, {kind}" if kind == "equal evaluations" else algorithm


def average_ranks(evidence: Evidence) -> tuple[tuple[str, ...], Friedman | None]:
    """Return who was run on every problem, and Friedman's test of them where there is one."""
    (experiment,) = evidence.experiments
    names = tuple(
        name for name in experiment.algorithms
        if all((experiment.name, p, name) in evidence.runs for p in experiment.problems)
    )  # fmt: skip
    if len(names) < 3 or len(experiment.problems) < 2:
        return names, None
    means = [
        [float(evidence.runs[experiment.name, p, name].costs[0].mean()) for name in names]
        for p in experiment.problems
    ]
    return names, friedman(np.array(means))
