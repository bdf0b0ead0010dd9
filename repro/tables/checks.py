"""Every check that a table alone allows, over its blocks and over what else it prints."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from repro.tables.blocks import Block, turned
from repro.tables.counts import success_rows, tally_rows
from repro.tables.decisions import decision_rows
from repro.tables.doubles import double_rows
from repro.tables.facts import Decision, Fact, RankedRows, Success, WinsAndLosses
from repro.tables.order import order_rows
from repro.tables.quantiles import quantile_rows
from repro.tables.ranges import range_rows_of
from repro.tables.rankings import ranking_rows
from repro.tables.rows import AuditRow
from repro.tables.senses import with_senses
from repro.tables.spread import spread_rows
from repro.tables.wholes import whole_rows

_OF_A_BLOCK = (order_rows, spread_rows, quantile_rows, range_rows_of, whole_rows, double_rows)


def rows_of_blocks(paper: str, blocks: Sequence[Block]) -> Iterator[AuditRow]:
    """Yield what each block says of itself; where all are reversed, a question of their sense."""
    found, questions = with_senses(paper, blocks)
    yield from questions
    for block in found:
        yield from block_rows(paper, block)


def block_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield what one block says of itself."""
    for check in _OF_A_BLOCK:
        yield from check(paper, turned(block))


def fact_rows(paper: str, fact: Fact) -> Iterator[AuditRow]:
    """Yield what one fact says of itself."""
    checks: dict[type, Callable[[str, Any], Iterator[AuditRow]]] = {
        WinsAndLosses: tally_rows,
        Success: success_rows,
        Decision: decision_rows,
        RankedRows: ranking_rows,
    }
    return checks[type(fact)](paper, fact)
