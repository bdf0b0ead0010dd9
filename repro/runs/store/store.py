"""Finished runs on disk: one SQLite file, each run written once, each row under a digest."""

import hashlib
import json
import sqlite3
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from repro.errors import DamageError, StoreError
from repro.runs.plan import Task
from repro.runs.run import Record
from repro.runs.store.contents import contents, environments
from repro.runs.store.damage import (
    damaged_rows,
    index_hides_a_row,
    row_query,
    set_file_aside,
    take_over,
    whole_rows,
    with_cure,
)
from repro.runs.store.file import UNREADABLE, open_to_read, open_to_write, refusing
from repro.runs.store.lock import lock, lock_to_read
from repro.runs.store.questions import (
    AT_ONCE,
    Kind,
    finished_of,
    held_keys,
    numbers_of,
    seconds_by_kind,
)
from repro.runs.store.questions import finished_keys as finished_keys_of
from repro.runs.store.row import record_of, write
from repro.runs.store.settled import NAME, is_settled

if TYPE_CHECKING:
    from io import BufferedReader

_NAMED = 20  # damaged rows that are named one by one


class Store:
    """The store in one folder; a context manager that holds its lock.

    Whoever writes waits for the lock and sets aside what is damaged when it opens the file, with a
    line to `say` for each. Whoever only reads (`writing=False`) changes nothing, waits for nobody
    and refuses a damaged file.
    """

    def __init__(
        self, folder: Path, *, writing: bool = True, say: Callable[[str], None] = lambda _: None
    ) -> None:
        """Name the folder; nothing is touched before the store is entered."""
        self.folder = folder
        self.path = folder / NAME
        self._writing = writing
        self._say = say
        self._env: int | None = None
        self._environment = ""
        self._file: BufferedReader | None = None

    def __enter__(self) -> Self:
        """Lock and open; InputError for a folder that cannot be used, StoreError otherwise."""
        self._lock = lock(self.folder, self._say) if self._writing else lock_to_read(self.folder)
        try:
            self._open()
        except BaseException:
            self._unlock()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        """Close and unlock."""
        self._close()
        self._unlock()

    def _close(self) -> None:
        with suppress(*UNREADABLE):  # what was committed is on disk already
            self._database.close()
        if self._file is not None:
            self._file.close()
            self._file = None

    def _unlock(self) -> None:
        if self._lock is not None:
            self._lock.close()

    def _open(self) -> None:
        try:
            if self._writing:
                self._use(open_to_write(self.path))
            else:
                self._use(open_to_read(self.path, alone=self._lock is not None))
        except DamageError as damage:
            if not self._writing:
                raise with_cure(damage) from None
            self._set_file_aside(damage)

    def _use(self, database: sqlite3.Connection) -> None:
        self._database = database
        self._hides_none = False
        with self._refusing():
            self._row = row_query(database)

    @contextmanager
    def _refusing(self) -> Iterator[None]:
        try:
            with refusing(self.path):
                yield
        except DamageError as damage:
            if self._writing:
                raise
            raise with_cure(damage) from None

    def begin(self, environment: Mapping[str, object]) -> None:
        """Say under which environment the runs that follow are made."""
        text = json.dumps(environment, sort_keys=True)
        with self._refusing(), self._database:
            self._database.execute("insert or ignore into env(json) values (?)", (text,))
            found = self._database.execute(
                "select id from env not indexed where json = ?", (text,)
            ).fetchone()
            number = found[0] if found else None  # where the index alone has it
            if not isinstance(number, int):
                message = f"{self.path}: an environment is damaged"
                raise DamageError(message)
            self._env = number
            self._environment = text

    def missing(self, tasks: Iterable[Task]) -> list[Task]:
        """Return the tasks without a finished run, in order; see `lacking`."""
        return list(self.lacking(tasks))

    def lacking(self, tasks: Iterable[Task]) -> Iterator[Task]:
        """Yield the tasks without a finished run, in order; failed runs are tried again.

        Raises DamageError for a run that is missing because its row is damaged.
        """
        rest = iter(tasks)
        with self._refusing():
            held = held_keys(self._database)
        while some := list(islice(rest, AT_ONCE)):
            finished = held
            if finished is None:
                with self._refusing():
                    finished = finished_of(self._database, [task.key for task in some])
            for task in some:
                if task.key not in finished:
                    self._refuse_damaged(task, hidden=held is None)
                    yield task

    def _refuse_damaged(self, task: Task, *, hidden: bool) -> None:
        """Raise DamageError for the damaged row of a task that has no finished one."""
        number = self._number(task)
        if number is not None:
            self._record(task, number)
        elif hidden:
            self._refuse_hidden()

    def _number(self, task: Task) -> Any:  # noqa: ANN401 (what a damaged index holds)
        """Return the id that the index has for a task; None where it has none."""
        with self._refusing():
            return numbers_of(self._database, [task.key]).get(task.key)

    def _refuse_hidden(self) -> None:
        """Raise DamageError where the index hides a row; looked at once."""
        if self._hides_none:
            return
        with self._refusing():
            if index_hides_a_row(self._database):
                message = f"{self.path}: the index is damaged"
                raise DamageError(message)
        self._hides_none = True

    def _record(self, task: Task, number: int) -> Record:
        with self._refusing():
            record = record_of(task, self._database.execute(self._row, (number,)).fetchone())
            if record is None:
                message = f"{self.path}: the row of {task.name} is damaged"
                raise DamageError(message)
        return record

    def finished(self, paper: str | None = None) -> frozenset[str]:
        """Return the keys of all finished runs, or of those of one paper."""
        with self._refusing():
            return finished_keys_of(self._database, paper)

    def seconds(self) -> dict[Kind, float]:
        """Return what a finished run took, by kind."""
        with self._refusing():
            return seconds_by_kind(self._database)

    def fingerprint(self) -> str | None:
        """Return a digest of the whole file; None while a reader keeps runs in the journal."""
        if self._writing:
            with self._refusing():
                (busy, *_) = self._database.execute("pragma wal_checkpoint(truncate)").fetchone()
            if busy:
                return None
        elif self._lock is None or not is_settled(self.path):
            return None
        if self._file is None:
            # open as long as the database: closing a handle of a file drops all its locks (POSIX)
            self._file = self.path.open("rb")
        self._file.seek(0)
        return hashlib.file_digest(self._file, "sha256").hexdigest()

    def contents(self) -> dict[str, str]:
        """Return a digest of all that is stored of each paper, whole or not."""
        with self._refusing():
            return contents(self._database)

    @contextmanager
    def set_down(self) -> Iterator[None]:
        """Close the file for a while, and keep the lock: copies of this process may read it."""
        self._close()
        try:
            yield
        finally:
            self._open()

    @contextmanager
    def taken_up(self) -> Iterator[None]:
        """Open the file for a while where it is set down."""
        self._open()
        try:
            yield
        finally:
            self._close()

    def repeats(self) -> int:
        """Return how many repeats the runs are of; a damaged row adds one at most."""
        with self._refusing():
            found = self._database.execute("select count(distinct repeat) from run").fetchone()
            return int(found[0])

    def add(self, records: Iterable[Record]) -> None:
        """Write finished runs in one transaction."""
        with self._refusing(), self._database:
            for record in records:
                write(self._database, record, self._env, self._environment)

    def records(self, tasks: Iterable[Task]) -> Iterator[Record]:
        """Yield the stored record of each task that has one, in the order of the tasks.

        Raises DamageError for a row that is not what was written.
        """
        left = iter(tasks)
        while some := list(islice(left, AT_ONCE)):
            with self._refusing():
                numbers = numbers_of(self._database, [task.key for task in some])
            for task in some:
                number = numbers.get(task.key)
                if number is not None:  # read one by one: curves of a whole question are long
                    yield self._record(task, number)
                else:
                    self._refuse_hidden()

    def environments(self, tasks: Iterable[Task]) -> list[dict[str, object]]:
        """Return the environments in which the stored runs of these tasks were made, in order."""
        with self._refusing():
            try:
                return environments(self._database, tasks)
            except (KeyError, TypeError, ValueError):
                message = f"{self.path}: the environment of a run is damaged"
                raise DamageError(message) from None

    def damaged(self) -> Iterator[str]:
        """Yield the name of every row that is not what was written."""
        with self._refusing():
            yield from damaged_rows(self._database)

    def mend(self, damage: DamageError) -> None:
        """Name the rows that are damaged, set the file aside, and take over every whole row."""
        names: list[str] = []
        with suppress(StoreError):  # of a file past reading
            names.extend(self.damaged())
        for name in names[:_NAMED]:
            self._say(f"{self.path}: the row of {name} is damaged")
        if len(names) > _NAMED:
            self._say(f"{self.path}: {len(names) - _NAMED} more rows are damaged")
        self._close()
        self._set_file_aside(damage)

    def _set_file_aside(self, damage: DamageError) -> None:
        with refusing(self.folder):
            aside = set_file_aside(self.folder)
        self._use(open_to_write(self.path))
        with self._refusing():
            kept = take_over(self._database, whole_rows(aside))
        self._say(
            f"{damage}; it is set aside as {aside}, {kept} whole runs are taken over from it, "
            "and any other is made again where it is asked for"
        )
