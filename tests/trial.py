"""The trial of true tables: whether one is accused, whatever it is and however it was made."""

import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat

from repro.tables.auditing import audit_text
from repro.tables.checks import fact_rows
from repro.tables.rows import AuditRow, Grade
from tests.true_tables.beside import rank_table, success_table, tally_table, test_table
from tests.true_tables.blocks import block_table, function_table, shared_table
from tests.true_tables.samples import Generator, named_rng
from tests.true_tables.written import TrueTable

SEED = "false alarms"
BATCH = 250
KINDS: Mapping[str, Callable[[Generator], TrueTable]] = {
    "statistics of costs": block_table,
    "statistics of functions": function_table,
    "methods that share rows": shared_table,
    "ranks": rank_table,
    "success rates": success_table,
    "tests": test_table,
    "tallies": tally_table,
}
SHARES = (10, 2, 2, 2, 2, 1, 1)  # of 20 tables in a row
OUTCOMES = (
    *("impossible", "inconsistent"),  # under no condition
    *("condition met", "condition broken"),  # whether the table is as the condition says
)
_ORDER = [name for name, share in zip(KINDS, SHARES, strict=True) for _ in range(share)]


def true_table(k: int, seed: str) -> tuple[str, TrueTable]:
    """Return the kind and the k-th table of a seed, the same wherever it is made."""
    kind = _ORDER[k % len(_ORDER)]
    return kind, KINDS[kind](named_rng(seed, k))


def alarms(tables: int, seed: str = SEED, workers: int = 1) -> Counter[tuple[str, str]]:
    """Return how many tables of each kind have each outcome, and how many numbers were read."""
    starts = range(0, tables, BATCH)
    stops = [min(tables, start + BATCH) for start in starts]
    total: Counter[tuple[str, str]] = Counter()
    if workers == 1:
        for found in map(_batch, starts, stops, repeat(seed)):
            total.update(found)
    else:
        with ProcessPoolExecutor(workers) as pool:
            for found in pool.map(_batch, starts, stops, repeat(seed)):
                total.update(found)
    return total


def _batch(start: int, stop: int, seed: str) -> Counter[tuple[str, str]]:
    count: Counter[tuple[str, str]] = Counter()
    for k in range(start, stop):
        kind, table = true_table(k, seed)
        count[kind, "tables"] += 1
        rows: list[AuditRow] = [row for fact in table.facts for row in fact_rows("", fact)]
        for found in audit_text(table.text, table.options):
            count[kind, "numbers"] += found.cells
            count[kind, "checked"] += found.checked
            rows += found.rows
        for outcome in {_outcome(row, table) for row in rows if row.grade is not Grade.NOTED}:
            count[kind, outcome] += 1
        for line in _said(k, table, rows):
            sys.stderr.write(line)
    return count


def _outcome(row: AuditRow, table: TrueTable) -> str:
    if row.condition is None:
        return str(row.grade)
    broken = any(words in row.condition for words in table.broken)
    return "condition broken" if broken else "condition met"


def _said(k: int, table: TrueTable, rows: list[AuditRow]) -> Iterator[str]:
    """Yield what accuses a true table under no condition, or one that it meets."""
    for row in rows:
        if row.grade is not Grade.NOTED and _outcome(row, table) != "condition broken":
            yield f"{k}: {table.made}: {row.check}: {row.explanation}; if {row.condition}\n"
