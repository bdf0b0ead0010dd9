"""Files that hold tables: their bytes, their encoding, their text."""

import codecs
import stat
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from repro.errors import InputError
from repro.tables.grids import Grid
from repro.tables.texts import Form, tables_in

LONGEST = 32 * 2**20  # bytes of a file
FORMS: dict[str, Form] = {
    ".csv": "separated",
    ".tsv": "separated",
    ".tab": "separated",
    ".md": "markdown",
    ".markdown": "markdown",
    ".tex": "latex",
    ".html": "html",
    ".htm": "html",
}
WORKBOOKS = (".xlsx", ".xlsm")
STANDARD_INPUT = "-"
_KINDS = {
    b"%PDF": "a PDF: copy its table as text",
    b"PK\x03\x04": "an archive: a workbook is named .xlsx",
    b"\xd0\xcf\x11\xe0": "an old Office file: save the sheet as .xlsx",
    b"\x1f\x8b": "compressed",
    b"\x89PNG": "a picture",
    b"\xff\xd8\xff": "a picture",
}
_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)

SheetReader = Callable[[bytes], list[Grid]]


@dataclass(frozen=True, slots=True, kw_only=True)
class TableFile:
    """The tables of a file, and text beside them that may tell the number of runs."""

    name: str
    grids: list[Grid]
    context: str
    notes: tuple[str, ...] = ()


def is_workbook(name: str) -> bool:
    """Say whether a file is a workbook by its name."""
    return Path(name).suffix.lower() in WORKBOOKS


def read_tables(name: str, sheets: SheetReader | None) -> TableFile:
    """Return the tables of a file, "-" for standard input; InputError in one line for any other."""
    content = _bytes(name)
    shown = "standard input" if name == STANDARD_INPUT else name
    try:
        if sheets is not None and is_workbook(name):
            return TableFile(name=shown, grids=sheets(content), context="")
        text, notes = _decoded(content)
        return TableFile(
            name=shown,
            grids=tables_in(text, FORMS.get(Path(name).suffix.lower())),
            context=text[:LONGEST_CONTEXT],
            notes=notes,
        )
    except InputError as error:
        message = f"{shown}: {error}"
        raise InputError(message) from None


LONGEST_CONTEXT = 20_000  # letters that are searched for the number of runs


def _bytes(name: str) -> bytes:
    try:
        content = _standard_input() if name == STANDARD_INPUT else _of_file(Path(name))
    except InputError:
        raise
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        message = f"{name}: cannot be read: {reason}"
        raise InputError(message) from None
    if len(content) > LONGEST:
        message = f"{name}: it is longer than {LONGEST // 2**20} MB, the most that is read"
        raise InputError(message)
    return content


def _standard_input() -> bytes:
    if sys.stdin is None:
        message = "standard input: it is closed"
        raise InputError(message)
    return sys.stdin.buffer.read(LONGEST + 1)


def _of_file(path: Path) -> bytes:
    if not stat.S_ISREG(path.stat().st_mode):
        message = f"{path}: it is no file"
        raise InputError(message)
    with path.open("rb") as file:
        return file.read(LONGEST + 1)


def _decoded(content: bytes) -> tuple[str, tuple[str, ...]]:
    """Return the text of bytes, and what was guessed of its encoding."""
    if not content.strip():
        message = "it is empty"
        raise InputError(message)
    for start, kind in _KINDS.items():
        if content.startswith(start):
            message = f"it is {kind}"
            raise InputError(message)
    for mark, encoding in _MARKS:
        if content.startswith(mark):
            return _in_encoding(content, encoding), ()
    if encoding := _wide_encoding(content):
        return _in_encoding(content, encoding), (f"the encoding is taken for {encoding}",)
    if b"\0" in content:
        message = "it holds bytes that no text has"
        raise InputError(message)
    try:
        return content.decode("utf-8"), ()
    except UnicodeDecodeError:
        text = content.decode("cp1252", errors="replace")
    strange = sum(not (letter.isprintable() or letter.isspace()) for letter in text)
    if strange * 20 > len(text):
        message = "it holds bytes that no text has"
        raise InputError(message)
    return text, ("the encoding is taken for Windows-1252",)


def _in_encoding(content: bytes, encoding: str) -> str:
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        message = f"it is no {encoding} text: {error.reason}"
        raise InputError(message) from None


def _wide_encoding(content: bytes) -> str:
    """Return the form of UTF-16 that text without a mark is in, by where its zeros stand."""
    start = content[:2000]
    even, odd = start[::2].count(0), start[1::2].count(0)
    half = len(start) // 2
    if odd * 10 > half * 7 and even * 10 < half:
        return "utf-16-le"
    if even * 10 > half * 7 and odd * 10 < half:
        return "utf-16-be"
    return ""
