"""`repro audit`: what the printed tables say about themselves."""

from argparse import Namespace

from repro.audit import audit
from repro.commands import catalogue
from repro.commands.shown_rows import show
from repro.model.paper import Paper


def run(options: Namespace) -> int:
    """Print one line, or one JSON object, per audit row."""
    papers = catalogue.chosen(options)
    found = {paper.key: audit(paper) for paper in papers}
    rows = [row for each in found.values() for row in each]
    lines = [
        f"{row.grade}: {row.paper}, {row.table}, {row.row or 'several cells'}"
        f"{f', {row.column}' if row.column else ''}: {row.explanation}"
        f"{f'; holds if {row.condition}' if row.condition else ''}"
        for row in rows
    ]
    lines += [_nothing(paper) for paper in papers if not found[paper.key]]
    return show(rows, lines, as_json=options.json)


def _nothing(paper: Paper) -> str:
    """Return what was looked at where nothing was found."""
    tables = (*paper.inputs, *paper.results)
    numbers = sum(1 for table in tables for _ in table.places())
    return f"{paper.key}: nothing found; {len(tables)} tables of {numbers} numbers are declared"
