"""A store on disk that holds every run of the small paper, and ways to look at it and harm it."""

import sqlite3
from concurrent.futures import Executor, Future
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

from repro.commands.written_pages import write_pages
from repro.runs.plan import plan
from repro.runs.run import Record, execute
from repro.runs.session import mended, run_missing
from repro.runs.store.store import Store
from tests.small_papers import PAPER

TASKS = plan([PAPER], 1)
RECORDS = tuple(execute(task) for task in TASKS)
ENVIRONMENT = {"python": "3.11", "cores": 2}


def filled(folder: Path) -> Path:
    """Return the folder, with a store that holds every run of the small paper."""
    with Store(folder) as store:
        store.begin(ENVIRONMENT)
        store.add(RECORDS)
    return folder


def with_pages(folder: Path, store: str = "store") -> Path:
    """Return the folder, with a filled store and the reports of it."""
    filled(folder / store)
    with Store(folder / store) as opened:
        write_pages(opened, [PAPER], TASKS, folder / "reports", [PAPER.key])
    return folder


def change(folder: Path, statement: str) -> None:
    """Change the database behind the store's back."""
    with closing(sqlite3.connect(folder / "runs.sqlite")) as database:
        database.execute(statement)
        database.commit()


def finished_keys(folder: Path) -> frozenset[str]:
    """Return the keys of all finished runs in a store that is only read."""
    with Store(folder, writing=False) as store:
        return store.finished()


def content(record: Record) -> tuple[object, ...]:
    """Return everything that a record says, bit by bit."""
    return (
        record.task.name,
        (record.cost + 0.0).hex(),  # SQLite keeps no sign of zero
        record.x.tobytes(),
        record.history.tobytes(),
        record.evaluations,
        record.seconds.hex(),
        record.reason,
    )


def reproduced(folder: Path) -> tuple[list[tuple[object, ...]], list[str], list[str]]:
    """Run what the store lacks, as `repro reproduce` does.

    Return what it holds then but for the seconds, the names of the runs that were made, and what
    was said.
    """
    said: list[str] = []
    made: list[str] = []

    with Store(folder, say=said.append) as store, InOrder(made) as executor:

        def work() -> list[tuple[object, ...]]:
            run_missing(
                store,
                TASKS,
                executor=executor,
                workers=1,
                environment=lambda: ENVIRONMENT,
                report=lambda _done, _to_do: None,
            )
            return [timeless(record) for record in store.records(TASKS)]

        return mended(store, work), made, said


class InOrder(Executor):
    """Runs each batch of tasks at once and notes their names."""

    def __init__(self, names: list[str]) -> None:
        """Note the names in a list."""
        self._names = names

    def submit(self, function: Any, /, *arguments: Any, **named: Any) -> Future[Any]:  # noqa: ANN401
        """Run at once."""
        self._names.extend(task.name for task in arguments[0])
        future: Future[Any] = Future()
        future.set_result(function(*arguments, **named))
        return future


def timeless(record: Record) -> tuple[object, ...]:
    """Return everything that a record says but the seconds that it took."""
    return content(replace(record, seconds=0.0))


def read(folder: Path) -> list[tuple[object, ...]]:
    """Return what a reader finds, but for the seconds."""
    with Store(folder, writing=False) as store:
        store.environments(TASKS)
        return [timeless(record) for record in store.records(TASKS)]


def stored(folder: Path) -> list[tuple[object, ...]]:
    """Return the content of every record in the store."""
    with Store(folder) as store:
        return [content(record) for record in store.records(TASKS)]


INTACT = [timeless(record) for record in RECORDS]
