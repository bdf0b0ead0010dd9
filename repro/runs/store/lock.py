"""The lock of a store: one writer at a time, and nobody else's file touched for it.

Its name is one that nothing else has, it is opened without following a link, and what stands there
is neither emptied nor replaced.
"""

import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path

from repro.errors import InputError

try:
    import fcntl
except ImportError:  # Windows
    message = (
        "the store cannot be locked on this system: runs are made and read on Linux and macOS "
        "(on Windows in WSL)"
    )
    raise InputError(message) from None

LOCK = "repro.lock"
# a pipe with this name is not waited for
_FLAGS = os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


# what open(2) says of a link that it may not follow, and of a folder
_NO_FILE = {errno.ELOOP: "a link", errno.EISDIR: "a folder"}
# of NFS without its lock daemon, of FUSE and of Lustre as they may be mounted
_NO_LOCKS = {errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOTSUP, errno.ENOSYS, errno.EINVAL}


class Lock:
    """A locked file, until it is closed."""

    def __init__(self, number: int) -> None:
        """Take the number of an open file over."""
        self._number: int | None = number

    def close(self) -> None:
        """Unlock, once."""
        if self._number is not None:
            os.close(self._number)
            self._number = None


def lock(folder: Path, say: Callable[[str], None]) -> Lock:
    """Return the lock of a folder, both made where they have to be; wait while it is taken.

    Raises InputError for a folder that cannot be used.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        number = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | _FLAGS, 0o666)
    except OSError as error:
        raise _unusable(folder, error) from None
    try:
        _refuse_special(folder, number)
        try:
            fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"the store {folder} is in use by another call; waiting until it is free")
            fcntl.flock(number, fcntl.LOCK_EX)
    except OSError as error:
        os.close(number)
        raise _unusable(folder, error) from None
    except BaseException:
        os.close(number)
        raise
    return Lock(number)


def lock_to_read(folder: Path) -> Lock | None:
    """Return the lock, shared with other readers; None while somebody writes.

    Raises InputError for what is no folder, or one that may not be read.
    """
    try:
        if not stat.S_ISDIR(folder.stat().st_mode):
            message = f"the store folder {folder} cannot be used: it is a file"
            raise InputError(message)
        if not os.access(folder, os.X_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except FileNotFoundError:
        pass
    except OSError as error:
        raise _unusable(folder, error) from None
    try:
        number = os.open(folder / LOCK, os.O_RDONLY | _FLAGS)
    except OSError:  # nobody ever wrote, or nobody here may
        return Lock(os.open(os.devnull, os.O_RDONLY))
    try:
        fcntl.flock(number, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(number)
        return None
    except OSError as error:
        os.close(number)
        raise _unusable(folder, error) from None
    return Lock(number)


def _refuse_special(folder: Path, number: int) -> None:
    if not stat.S_ISREG(os.fstat(number).st_mode):
        message = f"the store folder {folder} cannot be used: {LOCK} in it is no file"
        raise InputError(message)


def _unusable(folder: Path, error: OSError) -> InputError:
    reason = error.strerror
    if error.errno in _NO_FILE:
        reason = f"{LOCK} in it is {_NO_FILE[error.errno]}"
    elif error.errno in _NO_LOCKS:
        reason = f"its disk locks no files ({reason}): name a store on another"
    return InputError(f"the store folder {folder} cannot be used: {reason}")
