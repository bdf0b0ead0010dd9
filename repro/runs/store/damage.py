"""Setting aside what is damaged in a store: never trusted again, never deleted."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing, suppress
from itertools import count, islice
from pathlib import Path

from repro.errors import DamageError
from repro.runs.store.file import UNREADABLE, read_any_text
from repro.runs.store.row import COLUMNS, Row, digest, unpack, whole_curve
from repro.runs.store.settled import NAME

SIDE_FOLDER = "set-aside"
_AT_ONCE = 1000  # rows that one transaction takes over


def row_query(database: sqlite3.Connection) -> str:
    """Return the query of one row by its id; a store of schema 1 has no column `packed`."""
    columns = database.execute("pragma table_info(curve)").fetchall()
    packed = "packed" if any(column[1] == "packed" for column in columns) else "0"
    return (
        f"select {COLUMNS}, sha, json, y, {packed} "  # noqa: S608
        f"from run left join curve using (id) left join env on env.id = run.env where run.id = ?"
    )


def index_hides_a_row(database: sqlite3.Connection) -> bool:
    """Return whether the index lacks a row that the table has."""
    query = """select count(*) from run as whole not indexed where not exists (
        select 1 from run indexed by sqlite_autoindex_run_1
        where key = whole.key and id = whole.id)"""
    return bool(database.execute(query).fetchone() != (0,))


def damaged_rows(database: sqlite3.Connection) -> Iterator[str]:
    """Yield the name of every row that is not what was written."""
    query = row_query(database)
    for (number,) in database.execute("select id from run not indexed"):
        row: Row = database.execute(query, (number,)).fetchone()
        if whole_curve(row) is None:
            yield name_of(row)


def name_of(row: Row | None) -> str:
    """Return the name that a row gives to its run, fit for a terminal whatever it holds."""
    if row is None:
        return "a run without a name"
    text = "/".join(map(str, row[1:7]))
    return text if text.isprintable() and len(text) < 200 else ascii(text)[:200]


def set_file_aside(folder: Path) -> Path:
    """Move the file of the store and its journal into a new side folder; return the file there."""
    for number in count(1):
        side = folder / f"{SIDE_FOLDER}-{number}"
        with suppress(FileExistsError):
            side.mkdir()
            break
    for name in (NAME, *(f"{NAME}-{kind}" for kind in ("wal", "shm", "journal"))):
        with suppress(FileNotFoundError):
            (folder / name).replace(side / name)
    return side / NAME


def whole_rows(path: Path) -> Iterator[Row]:
    """Yield every row of a damaged file that is what was written, as far as it can be read."""
    with (
        suppress(*UNREADABLE),
        closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as database,
    ):
        read_any_text(database)
        query = row_query(database)
        for number in _ids(database):
            with suppress(*UNREADABLE):
                row: Row | None = database.execute(query, (number,)).fetchone()
                if row is not None and whole_curve(row) is not None:
                    yield row


def _ids(database: sqlite3.Connection) -> list[int]:
    """Return the ids that can be read from either end of either table."""
    found: set[int] = set()
    for table in ("run", "curve"):
        for order in ("asc", "desc"):
            with suppress(*UNREADABLE):
                rows = database.execute(f"select id from {table} order by id {order}")  # noqa: S608
                found.update(number for (number,) in rows if isinstance(number, int))
    return sorted(found)


def take_over(database: sqlite3.Connection, rows: Iterator[Row]) -> int:
    """Write whole rows of another file as they are; return how many."""
    kept = 0
    while batch := list(islice(rows, _AT_ONCE)):
        with database:
            for row in batch:
                _take_over_one(database, row)
        kept += len(batch)
    return kept


def _take_over_one(database: sqlite3.Connection, row: Row) -> None:
    *values, _, environment, curve, packed = row
    database.execute("insert or ignore into env(json) values (?)", (environment,))
    found = database.execute("select id from env where json = ?", (environment,)).fetchone()
    values[-1] = found[0]
    sha = digest(tuple(values), environment, unpack(curve, packed) or b"")
    added = database.execute(
        f"insert or replace into run({COLUMNS}, sha) values ({', '.join('?' * 14)})",  # noqa: S608
        (*values, sha),
    )
    database.execute("insert into curve values (?, ?, ?)", (added.lastrowid, curve, packed))


def with_cure(damage: DamageError) -> DamageError:
    """Return the error with what mends the file, for who only reads it."""
    return DamageError(f"{damage}; `repro reproduce` sets it aside and runs again what it held")
