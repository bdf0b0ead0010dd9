"""What the numbers of a declared table are of, by the words of its own headings."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace

from repro.tables.gathered import Entry, Gathered, gathered_cells
from repro.tables.grids import Grid, grid
from repro.tables.layout import GridCell, Label, Layout
from repro.tables.markup import plain
from repro.tables.published import Printed, PublishedTable
from repro.tables.read_ranks import with_ranks
from repro.tables.relations import PlacedNumber


def published_grid(table: PublishedTable) -> Grid:
    """Return the texts of a declared table, its headings in the first line."""
    body = (
        (*headings, *(cell if isinstance(cell, str) else cell.text for cell in cells))
        for headings, cells in zip(table.rows, table.cells, strict=True)
    )
    return grid(table.where, [(*table.headings, *table.column_names), *body])


def read_published(table: PublishedTable) -> Gathered:
    """Return the numbers of a declared table, at the places and in the units that it declares.

    Numbers of one problem and algorithm in several units are of as many quantities.
    """
    found = Layout(cells=tuple(_cells(table, published_grid(table))), footers=())
    read = with_ranks(gathered_cells(found, table.label, title=table.where))
    entries = [_placed(table, entry) for entry in read.entries]
    units: dict[tuple[str, str, str], set[str]] = defaultdict(set)
    for entry in entries:
        units[_of(entry)].add(entry.number.printed.unit)
    return replace(
        read,
        entries=tuple(
            replace(entry, quantity=entry.quantity or entry.number.printed.unit)
            if len(units[_of(entry)]) > 1
            else entry
            for entry in entries
        ),
    )


def _cells(table: PublishedTable, drawn: Grid) -> Iterator[GridCell]:
    first = len(table.headings)
    for i, line in enumerate(drawn.lines[1:], start=1):
        row = tuple(
            Label(text=plain(text), heading=heading)
            for text, heading in zip(line[:first], table.headings, strict=True)
            if text
        )
        for j in range(first, len(line)):
            if line[j]:
                levels = table.columns[j - first].levels or (drawn.lines[0][j],)
                column = tuple(Label(text=plain(text)) for text in levels if text)
                yield GridCell(text=line[j], i=i, j=j, row=row, column=column)


def _of(entry: Entry) -> tuple[str, str, str]:
    return entry.problem, entry.algorithm, entry.quantity


def _placed(table: PublishedTable, entry: Entry) -> Entry:
    """Return the entry with the place as declared, and the unit where the cell is one number."""
    k = entry.j - len(table.headings)
    cell = table.cells[entry.i - 1][k]
    number = PlacedNumber(
        printed=cell if isinstance(cell, Printed) else entry.number.printed,
        label=table.label,
        row=table.row_names[entry.i - 1],
        column=table.column_names[k],
    )
    return replace(entry, number=number)
