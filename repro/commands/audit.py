"""`repro audit`: what the printed tables say about themselves."""

from argparse import Namespace

from repro.audit import audit
from repro.commands import catalogue
from repro.commands.shown_rows import show


def run(options: Namespace) -> int:
    """Print one line, or one JSON object, per audit row."""
    rows = [row for paper in catalogue.chosen(options) for row in audit(paper)]
    lines = [
        f"{row.grade}: {row.paper}, {row.table}, {row.row or 'several cells'}"
        f"{f', {row.column}' if row.column else ''}: {row.explanation}"
        f"{f'; holds if {row.condition}' if row.condition else ''}"
        for row in rows
    ]
    return show(rows, lines, as_json=options.json)
