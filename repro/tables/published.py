"""Numbers and tables as they are printed: text, unit, place and rounding."""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Self

from repro.errors import DeclarationError
from repro.tables.numbers import NoNumber, NumberForm, number_form
from repro.tables.units import UNITS, is_same_unit, known_unit

__all__ = ["NOTHING", "UNITS", "WORDS", "Column", "Printed", "PublishedTable"]

WORDS = "text"
NOTHING = "–"  # how a declaration writes a cell or row heading that is empty on the page

_SHOWN = 60  # characters of a text in a message

_HEADING = re.compile(r"(?P<name>[^\[\]]+?)\s*(?:\[(?P<unit>[^\]]*)\])?")


@dataclass(frozen=True, slots=True)
class Printed:
    """A number as it stands on the page: the text is the datum, the value follows from it.

    A mark of significance may follow it, as in "0.002/+", and a unit, which is then the number's.
    """

    text: str
    unit: str = ""

    def __post_init__(self) -> None:
        """Raise DeclarationError for an unknown unit or a text that is no number."""
        if self.unit not in UNITS:
            raise DeclarationError(_unknown_unit(self.text, self.unit))
        form = number_form(self.text)
        if isinstance(form, NoNumber):
            because = f": {form.because}" if form.because else ""
            message = f"{self.text[:_SHOWN]!r} is not a number{because}"
            raise DeclarationError(message)
        if not math.isfinite(form.value):
            message = f"{self.text!r} is greater than any double"
            raise DeclarationError(message)
        if form.unit and not self.unit:
            object.__setattr__(self, "unit", form.unit)
        elif form.unit and not is_same_unit(form.unit, self.unit):
            message = f"{self.text!r} is in {form.unit}, but its place says {self.unit}"
            raise DeclarationError(message)

    @property
    def value(self) -> float:
        """Value in the printed unit."""
        return self._form.value

    @property
    def rounding(self) -> float:
        """Half a unit of the last printed digit, in the printed unit; 0 for π/2 and for 4/30."""
        return self._form.rounding

    @property
    def mantissa(self) -> str:
        """Digits with sign and point, without the power of ten; empty for π/2 and for 4/30."""
        return self._form.mantissa

    @property
    def power(self) -> int | None:
        """Power of ten that is printed; None where there is none."""
        return self._form.power

    @property
    def mark(self) -> str:
        """What stands behind the number, such as "/+" or "†"; it says nothing of the value."""
        return self._form.mark

    @property
    def si(self) -> float:
        """Value in SI units."""
        return self.value * UNITS[self.unit]

    @property
    def _form(self) -> NumberForm:
        form = number_form(self.text)
        if isinstance(form, NoNumber):  # excluded when the number was made
            raise DeclarationError(self.text)
        return form


@dataclass(frozen=True, slots=True)
class Column:
    """A heading: its name and the unit that every cell below it is printed in."""

    name: str
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class PublishedTable:
    """A table as the page shows it; cells are found by row name and column name."""

    label: str
    where: str
    headings: tuple[str, ...]
    columns: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    cells: tuple[tuple[Printed | str, ...], ...]

    @classmethod
    def read(cls, page: str) -> Self:
        """Return the table drawn in `page`.

        The first line says where it stands. The second has the headings, with units in brackets;
        `||` (or else the first `|`) parts the row headings from the values. A blank row heading
        repeats the one above; a dash (–) stands for a cell or row heading that is empty on the
        page. Raises DeclarationError with the table, row and text at fault.
        """
        where, heading, *body = _lines(page)
        label = where.partition(",")[0]
        names, titles = _split(label, heading)
        columns = tuple(_column(label, title) for title in titles)
        rows: list[tuple[str, ...]] = []
        cells = []
        for line in body:
            row, texts = _split(label, line)
            if len(row) != len(names) or len(texts) != len(columns):
                message = (
                    f"{label}, row {' '.join(row)!r}: {len(row)} + {len(texts)} cells, "
                    f"but the heading has {len(names)} + {len(columns)}"
                )
                raise DeclarationError(message)
            above = rows[-1] if rows else row
            rows.append(tuple(own or old for own, old in zip(row, above, strict=True)))
            if not all(rows[-1]):
                message = f"{label}, row {line!r}: a blank heading has none above it to repeat"
                raise DeclarationError(message)
            rows[-1] = tuple("" if heading == NOTHING else heading for heading in rows[-1])
            cells.append(_read_row(label, _name(rows[-1]), texts, columns))
        _refuse_repeats(label, list(map(_name, rows)))
        _refuse_repeats(label, [column.name for column in columns])
        return cls(
            label=label,
            where=where,
            headings=names,
            columns=columns,
            rows=tuple(rows),
            cells=tuple(cells),
        )

    @property
    def row_names(self) -> tuple[str, ...]:
        """Printed row headings, joined by a space, from top to bottom."""
        return tuple(map(_name, self.rows))

    @property
    def column_names(self) -> tuple[str, ...]:
        """Printed column headings without units, from left to right."""
        return tuple(column.name for column in self.columns)

    def __getitem__(self, place: tuple[str, str]) -> Printed:
        """Return the number at (row, column); DeclarationError names the known places."""
        row, column = place
        i = _position(self.label, "row", row, self.row_names)
        cell = self.cells[i][_position(self.label, "column", column, self.column_names)]
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


def _column(label: str, title: str) -> Column:
    match = _HEADING.fullmatch(title)
    if match is None:
        message = f"{label}: heading {title!r} is not 'name' or 'name [unit]'"
        raise DeclarationError(message)
    unit = match["unit"] or ""
    known = unit if unit == WORDS else known_unit(unit)
    if known is None:
        raise DeclarationError(_unknown_unit(f"{label}, heading {title!r}", unit))
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


def _unknown_unit(place: str, unit: str) -> str:
    return f"{place}: unknown unit {unit!r}; known: {', '.join(filter(None, UNITS))}, {WORDS}"


def _refuse_repeats(label: str, names: list[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            message = f"{label}: {name!r} stands there twice"
            raise DeclarationError(message)


def _position(label: str, kind: str, name: str, known: tuple[str, ...]) -> int:
    if name not in known:
        message = f"{label} has no {kind} {name!r}; it has {', '.join(map(repr, known))}"
        raise DeclarationError(message)
    return known.index(name)
