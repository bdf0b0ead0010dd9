"""A page of audited tables as they are printed, with flags beside their cells, in one file."""

from collections.abc import Sequence

from jinja2 import Environment, PackageLoader, StrictUndefined

from repro.tables.audit_words import paragraph, row_words
from repro.tables.auditing import AuditedTable
from repro.tables.markup import plain


def page(tables: Sequence[AuditedTable]) -> str:
    """Return the page as HTML; every text of a table is escaped."""
    environment = Environment(
        loader=PackageLoader("repro.report"), autoescape=True, undefined=StrictUndefined
    )
    template = environment.get_template("audited.html.jinja")
    return template.render(
        tables=[{"table": each, "says": paragraph(each), "lines": _lines(each)} for each in tables],
        row_words=row_words,
    )


def _lines(table: AuditedTable) -> list[list[tuple[str, list[tuple[int, str]]]]]:
    """Return the texts of the grid, each with the flags on it: number and grade of a row."""
    flags: dict[tuple[int, int], list[tuple[int, str]]] = {}
    for k, row in enumerate(table.rows, 1):
        cells = [(cell["row"], cell["column"]) for cell in row.cells]
        for place in cells or [(row.row or "", row.column or "")]:
            if place in table.places:
                grade = "proof" if row.is_proof else str(row.grade)
                flags.setdefault(table.places[place], []).append((k, grade))
    return [
        [(plain(text), flags.get((i, j), [])) for j, text in enumerate(line)]
        for i, line in enumerate(table.grid.lines)
    ]
