"""Files and folders that we write: each file whole or not at all, and nobody else's in their place.

Below a folder that the user named no link is followed, be it to a folder or to a file; the named
folder itself, and a file that the user named, may be links.
"""

import os
import secrets
import stat
from contextlib import suppress
from itertools import count
from pathlib import Path

from repro.errors import InputError

_STREAMS = ("/dev", "/proc")  # files there stand for what is open already


def usable_folder(folder: Path, called: str = "the reports folder") -> None:
    """Make the folder; InputError where it cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        usable = os.access(folder, os.W_OK | os.X_OK)
        reason = "no permission to write"
    except OSError as error:
        usable, reason = False, str(error.strerror)
    if not usable:
        message = f"{called} {folder} cannot be used: {reason}"
        raise InputError(message)


def read_file(path: Path) -> bytes:
    """Return what a file holds; OSError for what is none: nothing is waited for at a pipe."""
    number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    with open(number, "rb") as file:  # noqa: PTH123 (it is open)
        if not stat.S_ISREG(os.fstat(number).st_mode):
            raise OSError(None, "it is no file", str(path))
        return file.read()


def set_aside(path: Path) -> Path:
    """Give a file or folder a name that no other has; InputError where it cannot be."""
    try:
        for number in count(1):
            aside = path.with_name(f"{path.stem}-set-aside-{number}{path.suffix}")
            with suppress(FileExistsError):
                if path.is_dir() and not path.is_symlink():
                    aside.mkdir()
                else:
                    aside.open("xb").close()
                break
        return path.replace(aside)
    except OSError as error:
        message = f"{path} cannot be set aside: {error.strerror}"
        raise InputError(message) from None


def write_file(folder: Path, name: str, content: str | bytes, *, lasting: bool = False) -> None:
    """Replace a file of a folder at once, so that no reader sees half of it.

    Folders between are made, and none of them may be a link. A `lasting` one is on the disk when
    this returns. Raises InputError where it cannot be written.
    """
    path = folder / name
    try:
        for between in reversed(path.relative_to(folder).parents[:-1]):
            if (folder / between).is_symlink():
                message = f"{path} cannot be written: {folder / between} is a link"
                raise InputError(message)
            (folder / between).mkdir(exist_ok=True)
        _replace(path, content.encode() if isinstance(content, str) else content, lasting=lasting)
    except OSError as error:
        message = f"{path} cannot be written: {error.strerror}"
        raise InputError(message) from None


def _replace(path: Path, content: bytes, *, lasting: bool) -> None:
    """Write a draft, a new file with a name that nobody can foresee, and let it be the file."""
    draft = path.with_name(f".repro-{secrets.token_hex(8)}.draft")
    with draft.open("xb") as file:  # follows no link, and writes nothing that stands there
        try:
            file.write(content)
            file.flush()
            if lasting:
                os.fsync(file.fileno())
            draft.replace(path)
        except BaseException:
            with suppress(OSError):
                draft.unlink()
            raise


def write_named(path: Path, content: str) -> None:
    """Write a file that the user named: where a link leads, and into a pipe or a device as it is.

    Raises InputError where it cannot be written.
    """
    try:
        streams = any(path.absolute().is_relative_to(each) for each in _STREAMS)
        if path.exists() and (streams or not path.is_file()):
            path.write_text(content, encoding="utf-8")
            return
        with suppress(FileNotFoundError):
            path.stat()  # which says of a link that it leads in a circle
    except OSError as error:
        message = f"{path} cannot be written: {error.strerror}"
        raise InputError(message) from None
    place = Path(os.path.realpath(path)) if path.is_symlink() else path
    write_file(place.parent, place.name, content)
