"""The file of the store: how it is made, recognised, migrated and opened."""

import math
import os
import sqlite3
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path

from repro.errors import DamageError, InputError, StoreError
from repro.runs.store.row import LONGEST
from repro.runs.store.settled import is_settled

SCHEMA = 2
APPLICATION = 0x52455052  # "REPR"
# what SQLite says where the place is at fault and not the file
_UNUSABLE = ("SQLITE_CANTOPEN", "SQLITE_FULL", "SQLITE_IOERR", "SQLITE_READONLY", "SQLITE_PERM")
UNREADABLE = (sqlite3.Error, UnicodeDecodeError)  # the second in what SQLite says of damage
_FULL = "no room is left; finished runs are kept, make room and run the same command again"
TABLES = """
create table env(id integer primary key, json text unique not null);
create table run(
    id integer primary key, key text unique not null, paper text not null, experiment text not null,
    problem text not null, algorithm text not null, repeat integer not null, run integer not null,
    cost real, x blob not null, evaluations integer not null, seconds real not null,
    reason text, env integer not null references env(id), sha text not null);
create table curve(
    id integer primary key references run(id), y blob not null, packed integer not null default 0);
"""
# schema 1 kept every curve as it is
_FROM_1 = "alter table curve add column packed integer not null default 0;"
# how SQLite's journals begin; one of them holds nothing where power was lost
_BESIDE = {
    "wal": (b"\x37\x7f\x06\x82", b"\x37\x7f\x06\x83"),
    "journal": (b"\xd9\xd5\x05\xf9", bytes(4)),
}
_FIRST, _PAGE = 3, 4096  # bytes of what SQLite shares: when it is made, and by which it grows


def open_to_write(path: Path) -> sqlite3.Connection:
    """Return a connection to a store that is made or migrated where it has to be.

    Raises DamageError for a file that is damaged or not ours, StoreError for a newer schema.
    """
    with refusing(path):
        _refuse_foreign(path, most=1)
        database = sqlite3.connect(path)
    try:
        with refusing(path):
            _prepare(database, path)
    except BaseException:
        # an error on closing would hide the one that matters
        with suppress(*UNREADABLE):
            database.close()
        raise
    return database


def _prepare(database: sqlite3.Connection, path: Path) -> None:
    read_any_text(database)
    version = version_of(database, path)
    database.execute("pragma journal_mode=wal")
    database.execute("pragma synchronous=full")
    if version < SCHEMA:
        # in one transaction: a crash leaves a whole store or none, of the one schema or the other
        change = _FROM_1 if version else f"{TABLES} pragma application_id={APPLICATION};"
        database.executescript(f"begin; {change} pragma user_version={SCHEMA}; commit;")


def open_to_read(path: Path, *, alone: bool) -> sqlite3.Connection:
    """Return a connection that changes nothing, to an empty store in memory where no file is.

    `alone` says that nobody writes meanwhile; then no file is made beside the store either.
    """
    with refusing(path):
        _refuse_foreign(path)
    if not path.exists():
        database = sqlite3.connect(":memory:")
        database.executescript(TABLES)
        return database
    settled = alone and is_settled(path)
    with refusing(path):
        place = f"{path.resolve().as_uri()}?mode=ro{'&immutable=1' if settled else ''}"
        database = sqlite3.connect(place, uri=True)
    try:
        with refusing(path):
            read_any_text(database)
            made = version_of(database, path) > 0
            database.execute("begin")  # one state of the store, however long the reading takes
    except BaseException:
        database.close()
        raise
    if made:
        return database
    database.close()
    return open_to_read(path.with_name("nothing is made yet"), alone=alone)


def read_any_text(database: sqlite3.Connection) -> None:
    """Let damaged rows be read, but none that would fill the memory."""
    # damaged text is for the digest of its row to find, which can name the row
    database.text_factory = partial(str, encoding="utf-8", errors="replace")
    database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST)


def version_of(database: sqlite3.Connection, path: Path) -> int:
    """Return the schema of a store, 0 for an empty file.

    Raises DamageError for a file that is damaged or not ours, StoreError for a newer schema.
    """
    if not set(_start(path, 20)[18:]) <= {1, 2}:  # SQLite would call such a file read-only
        message = f"{path} is damaged: its header names no format of SQLite"
        raise DamageError(message)
    version, application = (
        int(database.execute(f"pragma {name}").fetchone()[0])
        for name in ("user_version", "application_id")
    )
    empty = database.execute("select count(*) from sqlite_master").fetchone() == (0,)
    if application != APPLICATION and not empty and not _has_our_tables(database):
        message = f"{path} is a database of another program: name another folder for the store"
        raise StoreError(message)
    if application != APPLICATION and (application or version or not empty):
        message = f"{path} is not a store of repro"
        raise DamageError(message)
    if version > SCHEMA:
        message = f"{path} has schema {version}, newer than {SCHEMA}: update repro"
        raise StoreError(message)
    if version < 0 or (empty and version) or not (empty or version):
        message = f"{path} is damaged: it has schema {version}"
        raise DamageError(message)
    return version


def _has_our_tables(database: sqlite3.Connection) -> bool:
    """Return whether any table has the name of one of ours: then the mark is damaged."""
    names = {name for (name,) in database.execute("select name from sqlite_master")}
    return not names.isdisjoint(("env", "run", "curve"))


def _start(path: Path, count: int) -> bytes:
    if not path.is_file():
        return b""
    with path.open("rb") as file:
        return file.read(count)


def _refuse_foreign(path: Path, most: float = math.inf) -> None:
    """Raise InputError for what is no file of a store, DamageError for a journal of others.

    SQLite looks for its journals where a link leads, and locks one name of a file alone: `most`
    is how many names it may have.
    """
    for kind in ("", "shm", *_BESIDE):
        place = path.with_name(f"{path.name}-{kind}" if kind else path.name)
        if not os.path.lexists(place):
            continue
        found = place.lstat()
        if reason := _reason_against(found, most, shared=kind == "shm"):
            message = f"{place} cannot be used as a store: {reason}"
            raise InputError(message)
        start = _start(place, 4) if kind in _BESIDE else b""
        if start and start not in _BESIDE[kind]:
            message = f"{place} is no journal of a store"
            raise DamageError(message)


def _reason_against(found: os.stat_result, most: float, *, shared: bool) -> str:
    if stat.S_ISLNK(found.st_mode):
        return "it is a link"
    if not stat.S_ISREG(found.st_mode):
        return "it is no file"
    if found.st_nlink > most:
        return "it has a second name, so copy it"
    # not opened for a look: closing it would drop the locks of this process's other connections
    if shared and found.st_size != _FIRST and found.st_size % _PAGE:
        return "it is of another program"
    return ""


@contextmanager
def refusing(path: Path) -> Iterator[None]:
    """Raise what SQLite says of the file at a path as one of our errors."""
    try:
        yield
    except sqlite3.Error as error:
        name = getattr(error, "sqlite_errorname", "")
        if name == "SQLITE_FULL":
            message = f"{path} cannot be written: {_FULL}"
            raise InputError(message) from None
        if name.startswith(_UNUSABLE):
            message = f"{path} cannot be used as a store: {error}"
            raise InputError(message) from None
        message = f"{path} is damaged: {error}"
        raise DamageError(message) from None
    except UnicodeDecodeError:
        message = f"{path} is damaged: a name in it is no text"
        raise DamageError(message) from None
    except OSError as error:
        message = f"{path} cannot be used as a store: {error.strerror}"
        raise InputError(message) from None
