"""Files of the reports folder: whether it can be written, and writing each at once."""

import csv
import io
import os
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from repro.errors import InputError


def usable_folder(folder: Path) -> None:
    """Make the folder; InputError where it cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        usable = os.access(folder, os.W_OK)
        reason = "no permission to write"
    except OSError as error:
        usable, reason = False, str(error.strerror)
    if not usable:
        message = f"the reports folder {folder} cannot be used: {reason}"
        raise InputError(message)


def csv_text(rows: Iterable[Iterable[object]]) -> str:
    """Return rows as the text of a CSV file."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def write_file(path: Path, text: str) -> None:
    """Replace a file at once, so that no reader sees half of it; InputError where it cannot be."""
    draft = path.with_name(f".{path.name}.{os.getpid()}.draft")  # two calls may write at once
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        draft.write_text(text, encoding="utf-8")
        draft.replace(path)
    except OSError as error:
        with suppress(OSError):
            draft.unlink(missing_ok=True)
        message = f"{path} cannot be written: {error.strerror}"
        raise InputError(message) from None
