"""Files of the reports folder: whether it can be written, and writing each at once."""

import os
from contextlib import suppress
from pathlib import Path

from repro.errors import InputError

Texts = dict[str, str]
"""Texts of files by their place in a folder."""


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


def write_file(path: Path, content: str | bytes) -> None:
    """Replace a file at once, so that no reader sees half of it; InputError where it cannot be."""
    draft = path.with_name(f".{path.name}.{os.getpid()}.draft")  # two calls may write at once
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        draft.write_bytes(content.encode() if isinstance(content, str) else content)
        draft.replace(path)
    except OSError as error:
        with suppress(OSError):
            draft.unlink(missing_ok=True)
        message = f"{path} cannot be written: {error.strerror}"
        raise InputError(message) from None
