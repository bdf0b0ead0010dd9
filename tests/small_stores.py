"""A store on disk that holds every run of the small paper, and ways to look at it and harm it."""

import sqlite3
from contextlib import closing
from pathlib import Path

from repro.plan import plan
from repro.run import Record, execute
from repro.store import Store
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


def change(folder: Path, statement: str) -> None:
    """Change the database behind the store's back."""
    with closing(sqlite3.connect(folder / "runs.sqlite")) as database:
        database.execute(statement)
        database.commit()


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


def stored(folder: Path) -> list[tuple[object, ...]]:
    """Return the content of every record in the store."""
    with Store(folder) as store:
        return [content(record) for record in store.records(TASKS)]
