"""`repro.audit_table`: the audit of a frame or a file, as a frame."""

import dataclasses
from collections.abc import Iterator
from os import PathLike, fspath
from typing import Any

import pandas as pd

from repro.commands.audit_files import audit_file
from repro.commands.audit_functions import named_bounds
from repro.commands.audit_settings import NAMES, options_of
from repro.commands.sheets import workbook_grids
from repro.errors import InputError
from repro.tables.auditing import AuditedTable, audited
from repro.tables.grids import Grid, grid
from repro.tables.rows import AuditRow

_FRAME = "frame"
_COLUMNS = ["file", *(field.name for field in dataclasses.fields(AuditRow)), "is_proof"]


def audit_table(frame_or_path: Any, **told: Any) -> pd.DataFrame:  # noqa: ANN401 (pandas has none)
    """Return one row per finding of a DataFrame, or of the tables of a file.

    `told` are the options of `repro audit FILE` by name: runs, maximise, minimum, errors, function,
    integers, precision, significant, spread, test, sided, alpha, ties. `minimum` and `function` are
    dictionaries by problem. The attribute `read` of the frame has what was read, skipped and
    guessed of each table. InputError for an unknown option or an input that is no table.
    """
    unknown = [name for name in told if name not in NAMES]
    if unknown:
        message = f"unknown option {unknown[0]!r}; known: {', '.join(NAMES)}"
        raise InputError(message)
    if isinstance(frame_or_path, pd.DataFrame):
        options = options_of(_FRAME, told, named_bounds)
        tables = audited([frame_grid(frame_or_path)], options, file=_FRAME)
    elif isinstance(frame_or_path, str | PathLike):
        tables = audit_file(fspath(frame_or_path), told, sheets=workbook_grids, bounds=named_bounds)
    else:
        message = f"{type(frame_or_path).__name__} is neither a DataFrame nor a path"
        raise InputError(message)
    found = pd.DataFrame([row for table in tables for row in _rows(table)], columns=_COLUMNS)
    found.attrs["read"] = [table.as_json()["read"] for table in tables]
    return found


def _rows(table: AuditedTable) -> Iterator[dict[str, Any]]:
    for row in table.rows:
        yield {"file": table.file, **dataclasses.asdict(row), "is_proof": row.is_proof}


def frame_grid(frame: pd.DataFrame) -> Grid:
    """Return a frame as a grid: its column names above, its index at the left if it has names."""
    own = frame if isinstance(frame.index, pd.RangeIndex) else frame.reset_index()
    names = [name if isinstance(name, tuple) else (name,) for name in own.columns]
    levels = max(map(len, names), default=1)
    heads = [[_text(name[k]) if k < len(name) else "" for name in names] for k in range(levels)]
    body = [[_text(value) for value in row] for row in own.itertuples(index=False, name=None)]
    digits = "numbers of a frame have the digits that Python shows of them"
    has_floats = any(isinstance(value, float) for row in own.to_numpy().tolist() for value in row)
    return grid("", [*heads, *body], (digits,) if has_floats else ())


def _text(value: Any) -> str:  # noqa: ANN401 (anything may stand in a frame)
    return "" if value is None or value is pd.NA else str(value)
