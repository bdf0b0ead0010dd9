"""What is asked of a store's tables besides single rows."""

import sqlite3
from collections.abc import Sequence
from typing import Any

HELD = 1_000_000  # runs of a store above which their keys are looked up and not held
AT_ONCE = 500  # keys of one question: not every SQLite takes more than 999

Kind = tuple[str, str, str, str]
"""Paper, experiment, problem and algorithm."""


def finished_keys(database: sqlite3.Connection, paper: str | None = None) -> frozenset[str]:
    """Return the keys of all finished runs, or of those of one paper."""
    query = "select key from run not indexed where reason is null"
    own = (f"{query} and paper = ?", (paper,)) if paper else (query,)
    rows = database.execute(*own)
    return frozenset(key for (key,) in rows)


def held_keys(database: sqlite3.Connection) -> frozenset[str] | None:
    """Return the keys of all finished runs; None where they are too many to hold."""
    (count,) = database.execute("select count(*) from run").fetchone()
    return finished_keys(database) if count <= HELD else None


def finished_of(database: sqlite3.Connection, keys: Sequence[str]) -> frozenset[str]:
    """Return which of some keys are finished, as the index has them."""
    marks = ", ".join("?" * len(keys))
    query = f"select key from run where key in ({marks}) and reason is null"  # noqa: S608
    return frozenset(key for (key,) in database.execute(query, keys))


def numbers_of(database: sqlite3.Connection, keys: Sequence[str]) -> dict[str, Any]:
    """Return by key the ids that the index has under some keys, be it damaged or not."""
    # of the index alone: a row is then read by its id, and a key that is damaged in it is seen
    marks = ", ".join("?" * len(keys))
    query = f"select key, id from run indexed by sqlite_autoindex_run_1 where key in ({marks})"  # noqa: S608
    return dict(database.execute(query, keys).fetchall())


def seconds_by_kind(database: sqlite3.Connection) -> dict[Kind, float]:
    """Return what a finished run took; the longest is left out, as the first one was compiled."""
    rows = database.execute(
        "select paper, experiment, problem, algorithm, count(*), sum(seconds), max(seconds) "
        "from run where reason is null group by 1, 2, 3, 4"
    )
    return {
        (paper, experiment, problem, algorithm): (
            (total - longest) / (count - 1) if count > 1 else total
        )
        for paper, experiment, problem, algorithm, count, total, longest in rows
    }
