"""Tables as they are printed: cells, their places and their units."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import accumulate
from typing import Self

from repro.errors import DeclarationError
from repro.tables.printed import WORDS, Printed, unknown_unit
from repro.tables.units import UNITS, known_unit

__all__ = ["NOTHING", "UNITS", "WORDS", "Column", "Printed", "PublishedTable"]

NOTHING = "–"  # how a declaration writes a cell or row heading that is empty on the page

_CITED = re.compile(r"[-–,.;\s\d]*")  # "[12]" behind a row heading is no unit
_HEADING = re.compile(r"(?P<name>[^\[\]]+?)\s*(?:\[(?P<unit>[^\]]*)\])?")


@dataclass(frozen=True, slots=True)
class Column:
    """A heading: its name and the unit that every cell below it is printed in.

    `levels` are the headings one above the other that the name joins, where there are several.
    """

    name: str
    unit: str
    levels: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class PublishedTable:
    """A table as the page shows it; cells are found by row name and column name.

    `row_units` are the units that row headings name, empty where a row has none of its own.
    """

    label: str
    where: str
    headings: tuple[str, ...]
    columns: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    cells: tuple[tuple[Printed | str, ...], ...]
    row_units: tuple[str, ...] = ()

    @classmethod
    def read(cls, page: str) -> Self:
        """Return the table drawn in `page`.

        The first line says where it stands. The second has the headings, with units in brackets;
        `||` (or else the first `|`) parts the row headings from the values. A blank row heading
        repeats the one above; a dash (–) stands for a cell or heading that is empty on the page.
        Headings that stand under others, as "Best" and "Mean" under "WOA", are a line of their own
        without row headings, and a blank one above them repeats the one to its left. A row heading
        may name a unit, too, for the columns without one; in brackets with
        digits alone, as "PSO [12]", it is a name. Raises DeclarationError with the table, row and
        text at fault.
        """
        where, heading, *body = _lines(page)
        label = where.partition(",")[0]
        names, titles = _split(label, heading)
        levels = [titles]
        while len(body) > 1 and not any(_split(label, body[0])[0]):
            levels.append(_split(label, body.pop(0))[1])
        columns = _columns(label, levels)
        rows: list[tuple[str, ...]] = []
        units, cells = [], []
        above = ("",) * len(names)
        for line in body:
            above, texts = _of_line(label, line, above, len(columns))
            row, unit = _without_unit(label, above)
            rows.append(row)
            units.append(unit)
            cells.append(_read_row(label, _name(row), texts, _of_unit(label, row, columns, unit)))
        _refuse_repeats(label, list(map(_name, rows)))
        _refuse_repeats(label, [column.name for column in columns])
        return cls(
            label=label,
            where=where,
            headings=names,
            columns=columns,
            rows=tuple(rows),
            cells=tuple(cells),
            row_units=tuple(units) if any(units) else (),
        )

    @cached_property
    def row_names(self) -> tuple[str, ...]:
        """Printed row headings, joined by a space, from top to bottom."""
        return tuple(map(_name, self.rows))

    @cached_property
    def column_names(self) -> tuple[str, ...]:
        """Printed column headings without units, from left to right."""
        return tuple(column.name for column in self.columns)

    @cached_property
    def _row_places(self) -> dict[str, int]:
        return {name: k for k, name in enumerate(self.row_names)}

    @cached_property
    def _column_places(self) -> dict[str, int]:
        return {name: k for k, name in enumerate(self.column_names)}

    def __getitem__(self, place: tuple[str, str]) -> Printed:
        """Return the number at (row, column); DeclarationError names the known places."""
        row, column = place
        i = _position(self.label, "row", row, self._row_places)
        cell = self.cells[i][_position(self.label, "column", column, self._column_places)]
        if isinstance(cell, str):
            message = f"{self.label}, row {row!r}, column {column!r}: {cell!r} is not a number"
            raise DeclarationError(message)
        return cell

    def column(self, name: str) -> tuple[float, ...]:
        """Values of one column in SI units, from top to bottom."""
        return tuple(self[row, name].si for row in self.row_names)

    def points(self) -> tuple[tuple[float, ...], ...]:
        """Values row by row in SI units."""
        return tuple(
            tuple(self[row, name].si for name in self.column_names) for row in self.row_names
        )

    def places(self) -> Iterator[tuple[str, str]]:
        """Yield (row, column) of every number, row by row."""
        for row, cells in zip(self.row_names, self.cells, strict=True):
            for column, cell in zip(self.columns, cells, strict=True):
                if isinstance(cell, Printed):
                    yield row, column.name


def _lines(page: str) -> list[str]:
    lines = [line.strip() for line in page.splitlines() if line.strip()]
    if len(lines) < 3:
        message = f"{page.strip()!r} is no table: it needs its place, its headings and a row"
        raise DeclarationError(message)
    return lines


def _name(row: tuple[str, ...]) -> str:
    return " ".join(filter(None, row))


def _split(label: str, line: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    left, bar, right = line.partition("||" if "||" in line else "|")
    if not bar:
        message = f"{label}: no '|' in the line {line!r}"
        raise DeclarationError(message)
    return tuple(part.strip() for part in left.split("|")), tuple(
        part.strip() for part in right.split("|")
    )


def _of_line(
    label: str, line: str, above: tuple[str, ...], columns: int
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the row headings of a line, blank ones repeated from above, and its cells."""
    row, texts = _split(label, line)
    if len(row) != len(above) or len(texts) != columns:
        message = (
            f"{label}, row {' '.join(row)!r}: {len(row)} + {len(texts)} cells, "
            f"but the heading has {len(above)} + {columns}"
        )
        raise DeclarationError(message)
    row = tuple(own or old for own, old in zip(row, above, strict=True))
    if not all(row):
        message = f"{label}, row {line!r}: a blank heading has none above it to repeat"
        raise DeclarationError(message)
    return row, texts


def _without_unit(label: str, row: tuple[str, ...]) -> tuple[tuple[str, ...], str]:
    """Return row headings without the unit that one of them names, and the unit."""
    names, units = [], []
    for heading in row:
        rest = heading.partition("[")[2]
        if heading == NOTHING or not rest.endswith("]") or _CITED.fullmatch(rest[:-1]):
            names.append("" if heading == NOTHING else heading)
            continue
        column = _column(label, heading)
        names.append(column.name)
        units.append(column.unit)
    if len(units) > 1:
        message = f"{label}, row {' '.join(row)!r}: two units, {' and '.join(units)}"
        raise DeclarationError(message)
    return tuple(names), "".join(units)


def _of_unit(
    label: str, row: tuple[str, ...], columns: tuple[Column, ...], unit: str
) -> tuple[Column, ...]:
    """Return the columns as the row's unit, if any, has them."""
    for column in columns:
        if unit and column.unit not in ("", unit, WORDS):
            message = (
                f"{label}, row {_name(row)!r}: its unit is {unit}, but column {column.name!r} is "
                f"in {column.unit}"
            )
            raise DeclarationError(message)
    return tuple(replace(column, unit=column.unit or unit) for column in columns)


def _columns(label: str, levels: list[tuple[str, ...]]) -> tuple[Column, ...]:
    """Return the columns of one line of headings, or of several, the uppermost first."""
    *upper, lowest = levels
    if not upper:
        return tuple(_column(label, title) for title in lowest)
    lines = [*map(_spread, upper), lowest]
    wide = max(map(len, lines))
    for line in lines:
        if len(line) != wide or not all(line):
            shown = " | ".join(line)
            message = (
                f"{label}, headings {shown!r}: each of the {wide} columns needs one; a "
                "blank one above others repeats the one to its left, a dash (–) is none"
            )
            raise DeclarationError(message)
    return tuple(_joined(label, titles) for titles in zip(*lines, strict=True))


def _spread(titles: tuple[str, ...]) -> tuple[str, ...]:
    """Return headings with each blank one as the one to its left."""
    return tuple(accumulate(titles, lambda left, own: own or left))


def _joined(label: str, titles: tuple[str, ...]) -> Column:
    """Return the column under several headings, of which one may have a unit."""
    parts = [Column("", "") if each == NOTHING else _column(label, each) for each in titles]
    units = [part.unit for part in parts if part.unit]
    if len(units) > 1:
        message = f"{label}, heading {' '.join(titles)!r}: two units, {' and '.join(units)}"
        raise DeclarationError(message)
    names = tuple(part.name for part in parts)
    return Column(_name(names), "".join(units), names)


def _column(label: str, title: str) -> Column:
    match = _HEADING.fullmatch(title)
    if match is None:
        message = f"{label}: heading {title!r} is not 'name' or 'name [unit]'"
        raise DeclarationError(message)
    unit = match["unit"] or ""
    known = unit if unit == WORDS else known_unit(unit)
    if known is None:
        raise DeclarationError(unknown_unit(f"{label}, heading {title!r}", unit))
    return Column(match["name"], known)


def _read_row(
    label: str, row: str, texts: tuple[str, ...], columns: tuple[Column, ...]
) -> tuple[Printed | str, ...]:
    try:
        return tuple(map(_cell, texts, columns))
    except DeclarationError as error:
        message = f"{label}, row {row!r}: {error}"
        raise DeclarationError(message) from None


def _cell(text: str, column: Column) -> Printed | str:
    if text == NOTHING:
        return ""
    return text if column.unit == WORDS else Printed(text, column.unit)


def _refuse_repeats(label: str, names: list[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            message = f"{label}: {name!r} stands there twice"
            raise DeclarationError(message)


def _position(label: str, kind: str, name: str, known: Mapping[str, int]) -> int:
    if name not in known:
        message = f"{label} has no {kind} {name!r}; it has {', '.join(map(repr, known))}"
        raise DeclarationError(message)
    return known[name]
