"""The text of an audited table that a reviewer can paste."""

from collections import Counter
from collections.abc import Iterator

from repro.tables.auditing import AuditedTable
from repro.tables.rows import AuditRow, Grade

_SKIPPED_SHOWN = 8


def paragraph(table: AuditedTable) -> str:
    """Return what was read and what cannot be, with the arithmetic of each."""
    read = read_words(table)
    proofs = table.proofs
    if not proofs:
        return f"{read}; none is impossible."
    found = "; ".join(f"({k}) {row_words(row)}" for k, row in enumerate(proofs, 1))
    return f"{read}; {len(proofs)} cannot be: {found}."


def read_words(table: AuditedTable) -> str:
    """Return how many numbers were read and checked, and the number of runs behind them."""
    skipped = len(table.skipped)
    n = f"n = {table.runs}" if table.runs is not None else "n not told"
    origin = next(
        (guess.says.removeprefix(n) for guess in table.guesses if guess.says.startswith(n)), ""
    )
    return (
        f"{table.file}, {table.label}: checked {table.checked} of {table.cells + skipped} numbers "
        f"in {table.blocks} block{'s' * (table.blocks != 1)}; {skipped} skipped; {n}{origin}"
    )


def lines(table: AuditedTable) -> Iterator[str]:
    """Yield the paragraph, then what holds under a condition, the guesses and what was skipped."""
    yield paragraph(table)
    for row in table.rows:
        if not row.is_proof:
            kind = "impossible if" if row.grade is Grade.IMPOSSIBLE else str(row.grade)
            words = f"  {kind}: {row_words(row)}"
            if row.grade is Grade.IMPOSSIBLE:
                words = f"  {kind} {row.condition}: {row_words(row, with_condition=False)}"
            yield words
    yield from read_lines(table)


def read_lines(table: AuditedTable, *, flag: str = "--") -> Iterator[str]:
    """Yield what is told and guessed, each with its option, and what was skipped."""
    for guess in table.guesses:
        option = f" ({flag}{guess.option})" if guess.option else ""
        yield f"  {guess.kind}: {guess.says}{option}"
    reasons = Counter(each.because for each in table.skipped)
    for because, times in reasons.most_common(_SKIPPED_SHOWN):
        first = next(each for each in table.skipped if each.because == because)
        more = f" and {times - 1} more" if times > 1 else ""
        yield f"  skipped: {first.text!r} ({_short(first.where)}){more}: {because}"
    if len(reasons) > _SKIPPED_SHOWN:
        yield f"  skipped: {len(reasons) - _SKIPPED_SHOWN} more reasons, all in --json"


def row_words(row: AuditRow, *, with_condition: bool = True) -> str:
    """Return where a row is from, what it says and what it needs."""
    cells = row.cells or ({"row": row.row or "", "column": row.column or ""},)
    places = ", ".join(f"{cell['row']} {cell['column']}".strip() for cell in cells[:4])
    more = f" and {len(cells) - 4} more" if len(cells) > 4 else ""
    condition = f"; holds if {row.condition}" if row.condition and with_condition else ""
    return f"{places}{more}: {row.explanation}{condition}"


def _short(where: str) -> str:
    return where if len(where) <= 80 else f"…{where[-79:]}"
