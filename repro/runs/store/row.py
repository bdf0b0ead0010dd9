"""What one row of the store holds: a record, packed, under a digest of all of it."""

import hashlib
import sqlite3
import zlib

import numpy as np
from numpy.typing import NDArray

from repro.runs.plan import Task
from repro.runs.run import Record

FLOAT = np.dtype("<f8")
COLUMNS = (
    "key, paper, experiment, problem, algorithm, repeat, run, cost, x, evaluations, seconds, "
    "reason, env"
)
LEVEL = 1  # of zlib: a third of the size for 45 µs a curve; level 6 saves another hundredth
LONGEST = 1 << 28  # bytes that a curve may unpack to: far more than any, and no machine's memory

_IN_HEX = {float, bytes}
Values = tuple[object, ...]
Row = tuple[object, ...]
"""The columns, then digest, environment, packed curve, and whether the curve is packed."""


def values_of(record: Record, environment: int | None) -> Values:
    """Return the values of the columns, in their order."""
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
        record.x.astype(FLOAT).tobytes(),
        int(record.evaluations),
        float(record.seconds),
        record.reason,
        environment,
    )


def curve_of(record: Record) -> bytes:
    """Return the bytes of the history."""
    return record.history.astype(FLOAT).tobytes()


def pack(curve: bytes) -> bytes:
    """Return the bytes of a curve, packed."""
    return zlib.compress(curve, LEVEL)


def unpack(blob: object, packed: object) -> bytes | None:
    """Return the bytes of a stored curve; None where it is damaged."""
    if not isinstance(blob, bytes) or packed not in (0, 1):
        return None
    if not packed:
        return blob
    unpacking = zlib.decompressobj()
    try:
        curve = unpacking.decompress(blob, LONGEST)
    except zlib.error:
        return None
    return curve if unpacking.eof and not unpacking.unused_data else None


def digest(values: Values, environment: object, curve: bytes) -> str:
    """Return the digest of everything that a row says."""
    texts = [
        f"{type(value).__name__}:{value.hex() if type(value) in _IN_HEX else repr(value)}\0"  # type: ignore[attr-defined]
        for value in (*values, environment)
    ]
    state = hashlib.sha256("".join(texts).encode())
    state.update(curve)
    return state.hexdigest()


def whole_curve(row: Row | None) -> bytes | None:
    """Return the curve of a row that is what was written; None for any other row."""
    if row is None:
        return None
    *values, sha, environment, blob, packed = row
    curve = unpack(blob, packed)
    if curve is None or sha != digest(tuple(values), environment, curve):
        return None
    return curve


def record_of(task: Task, row: Row | None) -> Record | None:
    """Return the record that a row holds for a task; None where the row is damaged."""
    curve = whole_curve(row)
    if row is None or curve is None or row[0] != task.key:
        return None
    cost, x, evaluations, seconds, reason = row[7:12]
    return Record(
        task=task,
        cost=float("nan") if cost is None else float(str(cost)),
        x=vector(x),
        history=vector(curve),
        evaluations=int(str(evaluations)),
        seconds=float(str(seconds)),
        reason=None if reason is None else str(reason),
    )


def vector(blob: object) -> NDArray[np.float64]:
    """Return the numbers of a blob; none for what is no blob."""
    return np.frombuffer(blob if isinstance(blob, bytes) else b"", dtype=FLOAT).astype(np.float64)


def write(database: sqlite3.Connection, record: Record, env: int | None, environment: str) -> None:
    """Write one run with its curve, in place of one of the same key."""
    values, curve = values_of(record, env), curve_of(record)
    database.execute("delete from curve where id = (select id from run where key = ?)", values[:1])
    added = database.execute(
        f"insert or replace into run({COLUMNS}, sha) values ({', '.join('?' * 14)})",  # noqa: S608
        (*values, digest(values, environment, curve)),
    )
    database.execute(
        "insert into curve(id, y, packed) values (?, ?, 1)", (added.lastrowid, pack(curve))
    )
