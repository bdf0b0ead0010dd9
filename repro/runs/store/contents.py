"""What a store holds of each paper, as digests: equal ones mean equal rows to the last bit."""

import hashlib
import json
import sqlite3
from collections.abc import Iterable

from repro.runs.plan import Task
from repro.runs.store.row import COLUMNS


def contents(database: sqlite3.Connection) -> dict[str, str]:
    """Return a digest of every paper's rows, curves and environments, in the order of writing.

    Rows are read as they stand: it is not looked at whether they are what was written.
    """
    query = (
        f"select paper, run.id, {COLUMNS}, sha, json, y "  # noqa: S608
        "from run not indexed left join curve using (id) left join env on env.id = run.env "
        "order by run.id"
    )
    found: dict[str, hashlib._Hash] = {}
    for paper, *values, curve in database.execute(query):
        state = found.setdefault(paper, hashlib.sha256())
        state.update(repr(values).encode())
        state.update(curve if isinstance(curve, bytes) else repr(curve).encode())
    return {paper: state.hexdigest() for paper, state in found.items()}


def environments(database: sqlite3.Connection, tasks: Iterable[Task]) -> list[dict[str, object]]:
    """Return the environments in which the stored runs of these tasks were made, in order.

    Raises KeyError, TypeError or ValueError where one is damaged.
    """
    wanted: dict[str, set[str]] = {}
    for task in tasks:
        wanted.setdefault(task.paper, set()).add(task.key)
    query = "select key, env from run not indexed where paper = ?"
    used = {
        env
        for paper, keys in wanted.items()
        for key, env in database.execute(query, (paper,))
        if key in keys
    }
    texts = dict(database.execute("select id, json from env").fetchall())
    return [json.loads(texts[env]) for env in sorted(used)]
