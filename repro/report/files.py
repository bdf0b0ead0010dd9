"""Files of the reports folder: whether it can be written, and writing each at once."""

import os
import secrets
from contextlib import suppress
from itertools import count
from pathlib import Path

from repro.errors import InputError

_TOP = 1000  # characters within which a page says what made it
Texts = dict[str, str]
"""Texts of files by their place in a folder."""


def usable_folder(folder: Path, called: str = "the reports folder") -> None:
    """Make the folder; InputError where it cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        usable = os.access(folder, os.W_OK)
        reason = "no permission to write"
    except OSError as error:
        usable, reason = False, str(error.strerror)
    if not usable:
        message = f"{called} {folder} cannot be used: {reason}"
        raise InputError(message)


def set_aside(path: Path) -> Path:
    """Give a file a name that no other has, and return that; InputError where it cannot be."""
    try:
        for number in count(1):
            aside = path.with_name(f"{path.stem}-set-aside-{number}{path.suffix}")
            with suppress(FileExistsError):
                aside.open("xb").close()
                break
        return path.replace(aside)
    except OSError as error:
        message = f"{path} cannot be set aside: {error.strerror}"
        raise InputError(message) from None


def remove_ours(path: Path, mark: str) -> None:
    """Remove a page that is no longer made, if it carries our mark near its top; no other file."""
    with suppress(OSError, UnicodeDecodeError):
        if not path.is_symlink() and mark in path.read_text(encoding="utf-8")[:_TOP]:
            path.unlink()


def write_file(path: Path, content: str | bytes) -> None:
    """Replace a file at once, so that no reader sees half of it; InputError where it cannot be.

    The draft is a new file with a name that nobody can foresee: what stands there is not written.
    """
    draft = path.with_name(f".repro-{secrets.token_hex(8)}.draft")
    made = False
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with draft.open("xb") as file:  # follows no link
            made = True
            file.write(content.encode() if isinstance(content, str) else content)
        draft.replace(path)
    except OSError as error:
        if made:
            with suppress(OSError):
                draft.unlink(missing_ok=True)
        message = f"{path} cannot be written: {error.strerror}"
        raise InputError(message) from None
