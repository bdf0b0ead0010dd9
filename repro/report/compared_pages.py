"""A comparison of a user's searches as files: a page, Markdown, JSON, and CSV of its runs."""

import json
import math
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pandas as pd

from repro.judge.comparison import Comparison
from repro.judge.users_search import mean_against_chance
from repro.report.compared_drawings import figure_files, pictured
from repro.report.frames import csv_text
from repro.report.plain_rows import rows_of_bias, rows_of_standings
from repro.report.rendering import render
from repro.report.views.users_search import users_search_view
from repro.runs.run import Record
from repro.runs.whole_files import write_file

SCHEMA = 1
RUN = ("paper", "experiment", "problem", "algorithm", "repeat", "run", "cost", "evaluations",
       "seconds", "reason")  # fmt: skip


def compared_files(found: Comparison, called: str = "") -> dict[str, str]:
    """Return the text of each file of a comparison by its place in the folder.

    Without a name, for a page that stands alone, none is named on it.
    """
    pictures = pictured(found)
    context = {
        "name": ", ".join(found.asked.searches),
        "called": called,
        "place": ", ".join(getattr(s, "place", "") for s in found.asked.searches.values()),
        "repeats": found.asked.repeats,
        "papers": _by_paper(found),
        "failed": [(record.task.name, record.reason) for record in found.failed],
        "warnings": found.warnings,
        "missing": found.missing,
        "pictures": pictures,
        "libraries": ", ".join(f"{name} {version}" for name, version in found.libraries.items()),
    }
    return {
        f"{called}.md": render("compare.md", context),
        f"{called}.html": render("compare.html", context),
        f"{called}.json": json.dumps(
            as_json(found), indent=1, ensure_ascii=False, allow_nan=False
        ) + "\n",
        f"{called}.csv": csv_text(pd.DataFrame(run_rows(found), columns=list(RUN))),
        **{f"{called}/{name}": text for name, text in figure_files(pictures)},
    }  # fmt: skip


def write_comparison(folder: Path, called: str, found: Comparison) -> Path:
    """Write a comparison in every form, and return the page's path.

    JSON is first: by it a call after one that was cut short knows whose files these are.
    """
    files = compared_files(found, called)
    for name in sorted(files, key=lambda name: name != f"{called}.json"):
        write_file(folder, name, files[name])
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
        "centre_bias": [
            {"paper": part.paper.key, **row}
            for part in found.parts
            for row in rows_of_bias(part.bias)
        ],
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
