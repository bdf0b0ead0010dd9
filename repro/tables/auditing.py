"""The audit of tables that are read from anywhere: what is read, guessed and found."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

from repro.errors import InputError
from repro.tables.arithmetic import IN_DOUBLES, joined, parted
from repro.tables.audit_options import AuditOptions, Guess
from repro.tables.blocks import Block, known_minimum
from repro.tables.checks import block_rows, fact_rows
from repro.tables.facts import Decision, Fact
from repro.tables.gathered import Gathered, Skipped, gathered
from repro.tables.grids import Grid
from repro.tables.guesses import (
    errors_guess,
    guess_lines,
    guessed_runs,
    sense_lines,
    spread_lines,
)
from repro.tables.levels import level_of
from repro.tables.markup import plain
from repro.tables.possible_runs import TRIED, can_be, possible_runs, rows_at_any_number
from repro.tables.read_blocks import ReadBlock, letters, names_of, read_blocks
from repro.tables.read_facts import facts_of, places_of
from repro.tables.read_ranks import with_ranks
from repro.tables.repeats import repeat_rows
from repro.tables.rows import AuditRow
from repro.tables.senses import in_either_sense
from repro.tables.statistic_words import SPREADS
from repro.tables.texts import Form, tables_in

NO_NEGATIVE = "no value is below 0"
_TITLE = 60
_SHOWN = 6  # blocks that a line names


@dataclass(frozen=True, slots=True, kw_only=True)
class AuditedTable:
    """A table as it is printed, what was read and guessed, and what the audit says of it.

    `places` has the line and column, in `grid`, of each (row, column) that a row names.
    """

    file: str
    label: str
    grid: Grid
    cells: int
    checked: int
    blocks: int
    runs: int | None
    skipped: tuple[Skipped, ...]
    guesses: tuple[Guess, ...]
    rows: tuple[AuditRow, ...]
    places: Mapping[tuple[str, str], tuple[int, int]]

    @property
    def proofs(self) -> tuple[AuditRow, ...]:
        """The rows that hold without any condition."""
        return tuple(row for row in self.rows if row.is_proof)

    def as_json(self) -> dict[str, Any]:
        """Return what `--json` prints of it."""
        read = {
            "cells": self.cells,
            "skipped": [asdict(each) for each in self.skipped],
            "guesses": [guess.says for guess in self.guesses if not guess.told],
        }
        return {"file": self.file, "read": read, "rows": [asdict(row) for row in self.rows]}


def audit_text(
    text: str, options: AuditOptions, *, file: str = "-", form: Form | None = None
) -> list[AuditedTable]:
    """Return the audit of every table of a text; InputError where there are too many cells."""
    return audited(tables_in(text, form), options, file=file, context=text[:20000])


def audited(
    grids: Sequence[Grid], options: AuditOptions, *, file: str, context: str = ""
) -> list[AuditedTable]:
    """Return the audit of tables; `context` is text that may tell the number of runs.

    InputError where something is told of a problem that no table has.
    """
    found: list[AuditedTable] = []
    problems: dict[str, None] = {}
    for k, grid in enumerate(grids):
        label = _label(grid, k, len(grids))
        table = with_ranks(gathered(grid, label), file.rpartition("/")[2])
        if table.entries:
            problems |= dict.fromkeys(entry.problem for entry in table.entries)
            found.append(audited_table(table, grid, options, file=file, context=context))
    if found:
        _refuse_unknown(options, problems, file)
    return found


def _refuse_unknown(options: AuditOptions, problems: Iterable[str], file: str) -> None:
    known = {letters(name) for each in problems for name in names_of(each)}
    for name in (*options.functions, *options.minimum):
        if letters(name) not in known:
            there = ", ".join(filter(None, problems)) or "none that is named"
            message = f"{file}: no problem is called {name!r}; there is {there:.200}"
            raise InputError(message)


def _label(grid: Grid, k: int, tables: int) -> str:
    whole = plain(grid.title)
    title = whole if len(whole) <= _TITLE else f"{whole[:_TITLE]}…"
    if not title:
        return f"table {k + 1}"
    return f"table {k + 1} ({title})" if tables > 1 else title


def audited_table(
    table: Gathered, grid: Grid, options: AuditOptions, *, file: str, context: str = ""
) -> AuditedTable:
    """Return the audit of a table of which it is known what its numbers are of."""
    runs, guess = guessed_runs(table, context, options)
    found = read_blocks(table.entries, runs, options)
    blocks = [each.block for each in found]
    own = {
        (b.block.problem_name, b.block.algorithm): b for b in found if b.block.quantity == "cost"
    }
    level = level_of(table.text, options)
    facts = facts_of(table, own, options, runs=runs, level=level)
    checked = _checked(blocks, facts)
    rows = list(_rows(file, found, facts, runs))
    maximised = any(block.maximise for block in blocks)
    errors = None if maximised else errors_guess(table, options)
    if errors:
        rows.extend(list(_if_errors(file, blocks, runs, rows)))
    told = [each for each in (guess, errors) if each]
    open_n = list(_possible(blocks)) if runs is None else []
    return AuditedTable(
        file=file,
        label=table.label,
        grid=grid,
        cells=len(table.entries),
        checked=len(checked),
        blocks=len(blocks),
        runs=runs,
        skipped=table.skipped,
        guesses=(
            *told,
            *open_n,
            *guess_lines(table, options, checked),
            *sense_lines(found, options),
            *spread_lines(table, options),
            *(level.guesses if any(isinstance(fact, Decision) for fact in facts) else ()),
        ),
        rows=tuple(_in_precision(rows, options.precision)),
        places={(e.number.row, e.number.column): (e.i, e.j) for e in table.entries},
    )


def _checked(blocks: Sequence[Block], facts: Sequence[Fact]) -> set[int]:
    """Return the ids of the numbers that a check looks at."""
    cells = [
        cell
        for block in blocks
        for name, cell in block.cells.items()
        if name not in SPREADS or name == block.spread  # of two spreads checks read one
    ]
    cells += [cell for fact in facts for cell in places_of(fact)]
    return set(map(id, cells))  # two columns of one heading may print the same number


def _rows(
    file: str, found: Sequence[ReadBlock], facts: Sequence[Fact], runs: int | None
) -> Iterator[AuditRow]:
    for each in found:
        rows = list(_of_block(file, each.block, runs))
        if each.other is None or not rows:
            yield from rows
        else:
            yield from in_either_sense(rows, list(_of_block(file, each.other, runs)))
    for fact in facts:
        yield from fact_rows(file, fact)
    yield from repeat_rows(file, [each.block for each in found])


def _of_block(file: str, block: Block, runs: int | None) -> Iterator[AuditRow]:
    if runs is not None:
        yield from block_rows(file, block)
    else:
        yield from rows_at_any_number(block, partial(block_rows, file))


def _if_errors(
    file: str, blocks: Sequence[Block], runs: int | None, found: Sequence[AuditRow]
) -> Iterator[AuditRow]:
    """Yield what blocks say only if none of their values is below 0, beside what is `found`."""
    floor = known_minimum("an error", Fraction(0))
    known = [(row.check, row.cells) for row in found]
    for block in blocks:
        best = block.span("best")
        is_above = best is not None and best.low >= 0  # then the floor tells nothing more
        if block.function is None and block.quantity == "cost" and not is_above:
            for row in _of_block(file, replace(block, function=floor), runs):
                if (row.check, row.cells) not in known:
                    yield replace(row, condition=joined((row.condition, NO_NEGATIVE)))


def _in_precision(rows: Sequence[AuditRow], precision: str | None) -> Iterator[AuditRow]:
    """Yield the rows that hold in the precision that is told, without what it settles."""
    for row in rows:
        conditions = parted(row.condition)
        if precision is None or IN_DOUBLES not in conditions:
            yield row
        elif precision == "double":
            rest = [condition for condition in conditions if condition != IN_DOUBLES]
            yield replace(row, condition=joined(rest))


def _possible(blocks: Sequence[Block]) -> Iterator[Guess]:
    """Yield from which number of runs on the blocks are possible."""
    if not blocks:
        return
    check = partial(block_rows, "")
    more = [
        block for block in blocks if not all(can_be(block, n, check) for n in (TRIED[0], TRIED[-1]))
    ]
    usual = len(blocks) - len(more)
    words = [f"; {_name(block)} {possible_runs(block, check)}" for block in more[:_SHOWN]]
    shown = f"{''.join(words)}{'; …' * (len(more) > _SHOWN)}"
    yield Guess(
        says=f"without n, {usual} of {len(blocks)} blocks can be from n = {TRIED[0]} on{shown}",
        option="runs",
    )


def _name(block: Block) -> str:
    return " of ".join(filter(None, dict.fromkeys((block.problem_name, block.algorithm))))
