"""`repro references`: what other planners say of the motion problems."""

from argparse import Namespace

from repro.commands import catalogue
from repro.commands.shown_rows import show
from repro.judge.outside_planners import outside_references


def run(options: Namespace) -> int:
    """Print one line, or one JSON object, per planner and problem."""
    papers = catalogue.chosen(options)
    rows = outside_references(papers)
    lines = [
        f"{row.paper}, {row.problem}, {row.planner}: "
        + (f"skipped, {row.skipped}" if row.time is None else f"{row.time:.6g} s, {row.what}")
        for row in rows
    ]
    asked = {row.paper for row in rows}
    lines += [
        f"{paper.key}: no motion in least time, no planner to ask"
        for paper in papers
        if paper.key not in asked
    ]
    return show(rows, lines, as_json=options.json)
