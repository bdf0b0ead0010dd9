"""The sheets of a workbook as they are shown; nothing in it is run or fetched."""

import re
import zipfile
from collections.abc import Iterator
from datetime import date, time
from io import BytesIO
from typing import Any

import openpyxl

from repro.errors import InputError
from repro.tables.grids import MOST_CELLS, Grid, grid, parted

MOST_UNPACKED = 64 * 2**20  # bytes
MOST_PARTS = 2000
_CHUNK = 2**16
_DECLARES = re.compile(rb"<!\s*(?:DOCTYPE|ENTITY)", re.IGNORECASE)
_DECIMALS = re.compile(r"[#,]*0?(?:\.(?P<decimals>[0#]+))?(?P<power>E[+-]0+)?(?P<percent>%)?")
_AS_IT_IS = "General"
_SHOWN = 10  # significant digits that a cell without a format shows at most


def workbook_grids(content: bytes) -> list[Grid]:
    """Return the tables of all sheets, numbers with the digits that their format shows.

    InputError for what is no workbook, unpacks to too much or declares entities.
    """
    _refuse_traps(content)
    try:
        shown = openpyxl.load_workbook(BytesIO(content), data_only=True, keep_links=False)
        written = openpyxl.load_workbook(BytesIO(content), data_only=False, keep_links=False)
    except Exception as error:  # noqa: BLE001 (openpyxl raises whatever its parsers raise)
        message = f"it is no workbook that can be read: {_line(error)}"
        raise InputError(message) from None
    found: list[Grid] = []
    for sheet in shown.worksheets:
        if sheet.max_row * sheet.max_column > MOST_CELLS:
            message = f"sheet {sheet.title!r} reaches over more than {MOST_CELLS} cells"
            raise InputError(message)
        found.extend(_tables(sheet, written[sheet.title]))
    return found


def _tables(sheet: Any, written: Any) -> Iterator[Grid]:  # noqa: ANN401 (openpyxl has no types)
    lines, unformatted, formulas = [], 0, 0
    for row in sheet.iter_rows():
        line = []
        for cell in row:
            source = written.cell(row=cell.row, column=cell.column)
            if source.data_type == "f" and cell.value is None:
                line.append(str(source.value))
                continue
            formulas += source.data_type == "f"
            unformatted += isinstance(cell.value, float) and cell.number_format == _AS_IT_IS
            line.append(shown_text(cell.value, cell.number_format))
        lines.append(line)
    notes = []
    if unformatted:
        notes.append(f"{unformatted} cells have no number format: {_SHOWN} digits are taken")
    if formulas:
        notes.append(f"{formulas} formulas stand for the values that the sheet last showed")
    several = f"sheet {sheet.title}"
    for table in parted(grid("", lines, tuple(notes))):
        yield Grid(
            title=f"{several} · {table.title}".strip(" ·"), lines=table.lines, notes=table.notes
        )


def shown_text(value: object, number_format: str) -> str:
    """Return a value with the digits that its number format shows."""
    if value is None:
        return ""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return value.isoformat() if isinstance(value, date | time) else str(value)
    first = number_format.split(";", maxsplit=1)[0].replace("\\", "").replace('"', "").strip()
    match = _DECIMALS.fullmatch(first)
    if first == _AS_IT_IS or match is None:
        return f"{value:.{_SHOWN}g}" if isinstance(value, float) else str(value)
    decimals = len(match["decimals"] or "")
    if match["power"]:
        return f"{value:.{decimals}E}"
    if match["percent"]:
        return f"{value * 100:.{decimals}f}%"
    return f"{value:.{decimals}f}"


def _refuse_traps(content: bytes) -> None:
    """Raise InputError for an archive that unpacks to too much, or whose parts declare entities."""
    left = MOST_UNPACKED
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            parts = archive.infolist()
            if len(parts) > MOST_PARTS:
                message = f"it has {len(parts)} parts; a workbook has at most {MOST_PARTS}"
                raise InputError(message)
            for part in parts:
                left = _read_part(archive, part, left)
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError, EOFError) as error:
        message = f"it is no workbook: {_line(error)}"
        raise InputError(message) from None


def _read_part(archive: zipfile.ZipFile, part: zipfile.ZipInfo, left: int) -> int:
    """Return how many bytes may still be unpacked after this part."""
    before = b""
    with archive.open(part) as unpacked:
        while chunk := unpacked.read(_CHUNK):
            left -= len(chunk)
            if left < 0:
                message = f"it unpacks to more than {MOST_UNPACKED // 2**20} MB"
                raise InputError(message)
            plain = (before + chunk).replace(b"\0", b"")
            if part.filename.endswith((".xml", ".rels", ".vml")) and _DECLARES.search(plain):
                message = f"{part.filename} in it declares entities, which no workbook needs"
                raise InputError(message)
            before = chunk[-32:]
    return left


def _line(error: Exception) -> str:
    return " ".join(str(error).split())[:200] or type(error).__name__
