"""The verdicts that a paper is expected to get, and what differs from them.

The list stands beside the paper's module, as KEY.verdicts.csv. No command writes it: it is made
anew on purpose, with a line in the change log that says which verdict changed and why.
"""

import csv
from collections.abc import Iterable, Mapping
from itertools import zip_longest
from pathlib import Path
from typing import Any

from repro.errors import InputError
from repro.judge.verdict import Verdict
from repro.report.results import impossible_rows, verdict_counts

COLUMNS = ("table", "row", "column", "claim", "printed", "verdict", "side", "value", "repeats")
PLACE, SAID = slice(0, 5), slice(5, 7)
NAMED = 5  # differences that the last line names
Row = tuple[str, ...]


def verdict_rows(entry: Mapping[str, Any]) -> list[Row]:
    """Return the rows of one paper's list, from its entry in results.json.

    `value` is that of the first repeat, which does not depend on how many follow.
    """
    return [
        tuple("" if finding[name] is None else str(finding[name]) for name in COLUMNS)
        for finding in entry["findings"]
    ]


def expected_rows(path: Path) -> list[Row] | None:
    """Return the rows of a list, None where there is none; InputError for what is no list."""
    if not path.exists():
        return None
    try:
        with path.open(encoding="utf-8", newline="") as file:
            heading, *rows = [tuple(row) for row in csv.reader(file)] or [()]
    except (OSError, ValueError, csv.Error) as error:
        message = f"{path} cannot be read: {error}"
        raise InputError(message) from None
    for line, row in enumerate((heading, *rows), start=1):
        if (line == 1 and row != COLUMNS) or len(row) != len(COLUMNS):
            message = f"{path}, line {line}, is no row of verdicts: {row}, not {COLUMNS}"
            raise InputError(message)
    return rows


def summary(results: Mapping[str, Any], lists: Mapping[str, Path], master_seed: str = "") -> str:
    """Return the table of verdicts of some papers, and a line on what differs from their lists."""
    entries = [entry for entry in results["papers"] if entry["key"] in lists]
    return "\n".join((*_table(entries), _compared(entries, lists, master_seed))) + "\n"


def _table(entries: Iterable[Mapping[str, Any]]) -> list[str]:
    headings = ("paper", *Verdict, "impossible", "repeats")
    rows = [headings]
    for entry in entries:
        said = verdict_counts(entry)
        counts = (
            *(said[verdict] for verdict in Verdict),
            len(impossible_rows(entry)),
            entry["provenance"]["repeats"],
        )
        rows.append((entry["key"], *map(str, counts)))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            text.rjust(width) if k else text.ljust(width)
            for k, (text, width) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    ]


def _compared(
    entries: Iterable[Mapping[str, Any]], lists: Mapping[str, Path], master_seed: str
) -> str:
    total, other_values, differing, notes = 0, 0, [], []
    for entry in entries:
        key, found = entry["key"], verdict_rows(entry)
        expected = expected_rows(lists[key])
        if expected is None:
            notes.append(
                f"{key} has no list of expected verdicts to compare with ({lists[key].name} beside "
                "its module, which is optional)"
            )
            continue
        total += max(len(found), len(expected))
        differing += [
            f"{key}, {_words(own or listed)}"
            for own, listed in zip_longest(found, expected)
            if not (own and listed) or (own[PLACE], own[SAID]) != (listed[PLACE], listed[SAID])
        ]
        values = zip(found, expected, strict=False)
        other_values += sum(own[7] != listed[7] for own, listed in values)
        made = entry["provenance"]["repeats"]
        depths = {row[8] for row in expected} - {"0"}  # 0 where nothing is run
        if depths and str(made) not in depths:
            notes.append(f"{key} is expected of {max(depths)} repeats, these are {made}")
    line = f"{total - len(differing)} of {total} as expected" if total else ""
    if differing:
        more = f"; and {len(differing) - NAMED} more" if len(differing) > NAMED else ""
        line += f"; not: {'; '.join(differing[:NAMED])}{more}"
    if other_values and not master_seed:
        notes.append(f"the first repeat gives {other_values} other values (another processor?)")
    return "; ".join(filter(None, (line, *notes)))


def _words(row: Row) -> str:
    place = row[3] or ", ".join(row[:3])
    return f"{place}: {' '.join(filter(None, row[SAID]))}"
