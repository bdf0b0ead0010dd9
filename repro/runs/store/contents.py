"""What a store holds of each paper, as digests: equal ones mean equal rows to the last bit."""

import hashlib
import json
import sqlite3
from collections.abc import Iterable
from itertools import islice

from repro.runs.plan import Task
from repro.runs.store.questions import AT_ONCE
from repro.runs.store.row import COLUMNS


def contents(database: sqlite3.Connection) -> dict[str, str]:
    """Return a digest of every paper's rows, curves and environments, in the order of writing.

    Rows are read as they stand: it is not looked at whether they are what was written.
    """
    columns = COLUMNS.replace(" x,", "")
    query = (
        f"select paper, env, x, y, {columns}, run.id, sha "  # noqa: S608
        "from run not indexed left join curve using (id) order by run.id"
    )
    found: dict[str, hashlib._Hash] = {}
    used: dict[str, set[object]] = {}
    for paper, env, x, curve, *values in database.execute(query):
        state = found.setdefault(paper, hashlib.sha256())
        used.setdefault(paper, set()).add(env)
        # bytes as they are: written out they would take longer than all the rest
        blobs = [each if isinstance(each, bytes) else repr(each).encode() for each in (x, curve)]
        state.update(f"{values} {[*map(len, blobs)]}".encode())
        for each in blobs:
            state.update(each)
    texts = dict(database.execute("select id, json from env").fetchall())
    for paper, state in found.items():
        state.update(
            repr(sorted((repr(env), repr(texts.get(env))) for env in used[paper])).encode()
        )
    return {paper: state.hexdigest() for paper, state in found.items()}


def environments(database: sqlite3.Connection, tasks: Iterable[Task]) -> list[dict[str, object]]:
    """Return the environments in which the stored runs of these tasks were made, in order.

    Raises KeyError, TypeError or ValueError where one is damaged.
    """
    used: set[int] = set()
    keys = (task.key for task in tasks)
    while some := list(islice(keys, AT_ONCE)):
        marks = ", ".join("?" * len(some))
        query = f"select distinct env from run where key in ({marks})"  # noqa: S608
        used |= {env for (env,) in database.execute(query, some)}
    texts = dict(database.execute("select id, json from env").fetchall())
    return [json.loads(texts[env]) for env in sorted(used)]
