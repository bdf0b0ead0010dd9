"""All checks of one block."""

from collections.abc import Iterator

from repro.tables.blocks import Block
from repro.tables.doubles import double_rows
from repro.tables.order import order_rows
from repro.tables.rows import AuditRow
from repro.tables.spread import spread_rows


def block_rows(paper: str, block: Block) -> Iterator[AuditRow]:
    """Yield every row that the numbers of one block give."""
    yield from order_rows(paper, block)
    yield from spread_rows(paper, block)
    yield from double_rows(paper, block)
