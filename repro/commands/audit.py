"""`repro audit`: what the printed tables say about themselves."""

from argparse import Namespace
from collections.abc import Iterator

from repro.audit import audit
from repro.audit.alone import tables_alone
from repro.commands import catalogue
from repro.commands.kept_output import tell
from repro.commands.shown_rows import text_of
from repro.model.paper import Paper
from repro.report.words import count_of
from repro.tables.audit_words import read_lines, read_words


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
    for paper in papers:
        lines.extend(_looked_at(paper, nothing=not found[paper.key]))
    tell(options, text_of(rows, lines, as_json=options.json))
    return 0


def _looked_at(paper: Paper, *, nothing: bool) -> Iterator[str]:
    """Yield what was read of tables that no run stands behind, and what was where nothing is."""
    if nothing:
        numbers = sum(1 for table in paper.tables for _ in table.places())
        declared = f"{count_of(len(paper.tables), 'table')} of {count_of(numbers, 'number')}"
        yield (
            f"{paper.key}: nothing found; {declared} "
            f"{'is' if len(paper.tables) == 1 else 'are'} declared"
        )
    for table in tables_alone(paper):
        yield read_words(table)
        yield from read_lines(table, flag="")
