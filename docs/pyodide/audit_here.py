"""What the page calls: the audit of a pasted text, with what is told of it, as JSON."""

import json
from collections.abc import Callable, Mapping
from typing import Any

from repro.commands.audit_settings import options_of
from repro.commands.table_files import STANDARD_INPUT
from repro.errors import InputError
from repro.tables.audit_words import paragraph
from repro.tables.auditing import AuditedTable, audit_text

PASTED = "pasted text"
MEANS: Mapping[str, Callable[[str], Any]] = {
    "runs": int,
    "significant": int,
    "sided": int,
    "alpha": float,
    "maximise": "yes".__eq__,
    "errors": "yes".__eq__,
    "integers": "yes".__eq__,
    "minimum": str.split,
}


def answer(text: str, told: str) -> str:
    """Return the audited tables of a text, or why there is none; `told` are options by name."""
    try:
        tables = _tables(text, json.loads(told))
    except InputError as error:
        return json.dumps({"error": str(error), "tables": []})
    return json.dumps({"error": None, "tables": tables})


def _tables(text: str, told: Mapping[str, str]) -> list[dict[str, Any]]:
    known = {"function": None, **{name: _value(name, told[name]) for name in told}}
    found = audit_text(text, options_of(STANDARD_INPUT, known, None), file=PASTED)
    if not found:
        message = "no table with numbers in it was found"
        raise InputError(message)
    return [_shown(table) for table in found]


def _value(name: str, text: str) -> object:
    try:
        return MEANS.get(name, str)(text)
    except ValueError:
        message = f"{name} {text!r} is not a number"
        raise InputError(message) from None


def _shown(table: AuditedTable) -> dict[str, Any]:
    """Return what --json says of a table, and besides where its numbers stand."""
    found = table.as_json()
    for row, entry in zip(table.rows, found["rows"], strict=True):
        cells = row.cells or ({"row": row.row or "", "column": row.column or ""},)
        places = [table.places.get((cell["row"], cell["column"])) for cell in cells]
        entry["at"] = [place for place in places if place is not None]
    return {
        **found,
        "label": table.label,
        "paragraph": paragraph(table),
        "grid": table.grid.lines,
        "guesses": [{"says": guess.says, "option": guess.option} for guess in table.guesses],
    }
