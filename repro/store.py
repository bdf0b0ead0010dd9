"""Finished runs on disk: one SQLite file, each run written once, each row under a digest."""

import fcntl
import hashlib
import json
import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, closing, contextmanager
from functools import partial
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from repro.errors import InputError, StoreError
from repro.plan import Task
from repro.run import Record

SCHEMA = 1
APPLICATION = 0x52455052  # "REPR"
_FLOAT = np.dtype("<f8")
# what SQLite says where the place is at fault and not the file
_UNUSABLE = ("SQLITE_CANTOPEN", "SQLITE_FULL", "SQLITE_IOERR", "SQLITE_READONLY")
_TABLES = """
create table env(id integer primary key, json text unique not null);
create table run(
    id integer primary key, key text unique not null, paper text not null, experiment text not null,
    problem text not null, algorithm text not null, repeat integer not null, run integer not null,
    cost real, x blob not null, evaluations integer not null, seconds real not null,
    reason text, env integer not null references env(id), sha text not null);
create table curve(id integer primary key references run(id), y blob not null);
"""
_COLUMNS = (
    "key, paper, experiment, problem, algorithm, repeat, run, cost, x, evaluations, seconds, "
    "reason, env"
)


class Store:
    """The store in one folder; a context manager that holds its lock."""

    def __init__(self, folder: Path) -> None:
        """Name the folder; nothing is touched before the store is entered."""
        self.folder = folder
        self.path = folder / "runs.sqlite"
        self._env: int | None = None
        self._environment = ""

    def __enter__(self) -> Self:
        """Lock and open; InputError for a folder that cannot be used, StoreError otherwise."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._lock = (self.folder / "lock").open("w")
        except OSError as error:
            message = f"the store folder {self.folder} cannot be used: {error.strerror}"
            raise InputError(message) from None
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self._lock.close()
            message = f"the store {self.folder} is in use by another run; wait or name another"
            raise StoreError(message) from None
        try:
            self._open()
        except BaseException:
            self._lock.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        """Close and unlock."""
        self._database.close()
        self._lock.close()

    def _open(self) -> None:
        with self._refusing():
            self._database = sqlite3.connect(self.path)
        try:
            with self._refusing():
                self._prepare()
        except BaseException:
            self._database.close()
            raise

    def _prepare(self) -> None:
        # damaged text is for the digest of its row to find, which can name the row
        self._database.text_factory = partial(str, encoding="utf-8", errors="replace")
        made = _is_made(self._database, self.path)
        self._database.execute("pragma journal_mode=wal")
        self._database.execute("pragma synchronous=full")
        if not made:
            # in one transaction: a crash leaves a whole store or none
            self._database.executescript(
                f"begin; {_TABLES} pragma application_id={APPLICATION}; "
                f"pragma user_version={SCHEMA}; commit;"
            )

    def _refusing(self) -> AbstractContextManager[None]:
        return _refusing(self.path)

    def begin(self, environment: Mapping[str, object]) -> None:
        """Say under which environment the runs that follow are made."""
        text = json.dumps(environment, sort_keys=True)
        with self._refusing(), self._database:
            self._database.execute("insert or ignore into env(json) values (?)", (text,))
            found = self._database.execute("select id from env where json = ?", (text,))
            self._env = int(found.fetchone()[0])
            self._environment = text

    def missing(self, tasks: Iterable[Task]) -> list[Task]:
        """Return the tasks without a finished run, in order; failed runs are tried again."""
        with self._refusing():
            rows = self._database.execute("select key from run where reason is null")
            finished = {key for (key,) in rows}
        return [task for task in tasks if task.key not in finished]

    def add(self, records: Iterable[Record]) -> None:
        """Write finished runs in one transaction."""
        marks = ", ".join("?" * 14)
        with self._refusing(), self._database:
            for record in records:
                values = self._values(record)
                curve = record.history.astype(_FLOAT).tobytes()
                self._database.execute(
                    "delete from curve where id = (select id from run where key = ?)", values[:1]
                )
                added = self._database.execute(
                    f"insert or replace into run({_COLUMNS}, sha) values ({marks})",  # noqa: S608
                    (*values, _digest(values, self._environment, curve)),
                )
                self._database.execute(
                    "insert into curve(id, y) values (?, ?)", (added.lastrowid, curve)
                )

    def _values(self, record: Record) -> tuple[object, ...]:
        task = record.task
        return (
            task.key,
            task.paper,
            task.experiment,
            task.problem,
            task.algorithm,
            task.repeat,
            task.run,
            None if record.reason else float(record.cost) + 0.0,  # SQLite keeps no negative zero
            record.x.astype(_FLOAT).tobytes(),
            int(record.evaluations),
            float(record.seconds),
            record.reason,
            self._env,
        )

    def records(self, tasks: Iterable[Task]) -> Iterator[Record]:
        """Yield the stored record of each task that has one, in the order of the tasks.

        Raises StoreError for a row that is not what was written.
        """
        query = (
            f"select {_COLUMNS}, sha, json, y from run left join curve using (id) "  # noqa: S608
            "left join env on env.id = run.env where run.id = ?"
        )
        with self._refusing():
            # read from the rows, as `missing` does: a damaged index must hide none
            ids = dict(self._database.execute("select key, id from run not indexed").fetchall())
        for task in tasks:
            if task.key in ids:
                with self._refusing():
                    row = self._database.execute(query, (ids[task.key],)).fetchone()
                yield self._record(task, row)

    def _record(self, task: Task, row: tuple[object, ...] | None) -> Record:
        *values, sha, environment, curve = row or (None, None, None)
        if not isinstance(curve, bytes) or sha != _digest(tuple(values), environment, curve):
            message = f"{self.path}: the row of {task.name} is damaged; delete it or the store"
            raise StoreError(message)
        cost, x, evaluations, seconds, reason = values[7:12]
        return Record(
            task=task,
            cost=float("nan") if cost is None else float(str(cost)),
            x=_vector(x),
            history=_vector(curve),
            evaluations=int(str(evaluations)),
            seconds=float(str(seconds)),
            reason=None if reason is None else str(reason),
        )

    def environments(self, tasks: Iterable[Task]) -> list[dict[str, object]]:
        """Return the environments in which the stored runs of these tasks were made, in order."""
        wanted = {task.key for task in tasks}
        with self._refusing():
            rows = self._database.execute("select key, env from run").fetchall()
            texts = dict(self._database.execute("select id, json from env").fetchall())
        used = sorted({env for key, env in rows if key in wanted})
        try:
            return [json.loads(texts[env]) for env in used]
        except (KeyError, ValueError):
            message = f"{self.path}: the environment of a run is damaged; delete the store"
            raise StoreError(message) from None


def _vector(blob: object) -> NDArray[np.float64]:
    return np.frombuffer(blob if isinstance(blob, bytes) else b"", dtype=_FLOAT).astype(np.float64)


def _digest(values: tuple[object, ...], environment: object, curve: bytes) -> str:
    digest = hashlib.sha256()
    for value in (*values, environment):
        text = value.hex() if isinstance(value, float | bytes) else repr(value)
        digest.update(f"{type(value).__name__}:{text}\0".encode())
    digest.update(curve)
    return digest.hexdigest()


def finished_keys(folder: Path) -> frozenset[str]:
    """Return the keys of all finished runs in a store that is only read; none where none is.

    Raises StoreError for a file that is no store or a newer one.
    """
    path = folder / "runs.sqlite"
    if folder.exists() and not folder.is_dir():
        message = f"the store folder {folder} cannot be used: it is a file"
        raise InputError(message)
    if not path.exists():
        return frozenset()
    with (
        _refusing(path),
        closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as database,
    ):
        made = _is_made(database, path)
        rows = database.execute("select key from run where reason is null") if made else ()
        return frozenset(key for (key,) in rows)


def _is_made(database: sqlite3.Connection, path: Path) -> bool:
    """Return whether the file holds a store, False where it is empty; StoreError for any other."""
    version, application = (
        int(database.execute(f"pragma {name}").fetchone()[0])
        for name in ("user_version", "application_id")
    )
    empty = database.execute("select count(*) from sqlite_master").fetchone() == (0,)
    if application != APPLICATION and (application or version or not empty):
        message = f"{path} is not a store of repro: name another folder with --store"
        raise StoreError(message)
    if version > SCHEMA:
        message = f"{path} has schema {version}, newer than {SCHEMA}: update repro"
        raise StoreError(message)
    return version > 0


@contextmanager
def _refusing(path: Path) -> Iterator[None]:
    try:
        yield
    except sqlite3.Error as error:
        unusable = getattr(error, "sqlite_errorname", "").startswith(_UNUSABLE)
        message = f"{path} cannot be used as a store: {error}"
        raise (InputError if unusable else StoreError)(message) from None
