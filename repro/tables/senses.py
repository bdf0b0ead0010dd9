"""Whether the best run of a block is the least or the greatest one."""

from collections.abc import Sequence
from dataclasses import replace

from repro.tables.arithmetic import is_less
from repro.tables.blocks import Block, turned
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.statistic_words import quantile_share

INNER = ("mean", "median")


def with_senses(paper: str, blocks: Sequence[Block]) -> tuple[list[Block], list[AuditRow]]:
    """Return the blocks with the least run named "best", and a question per reversed table.

    Where all blocks of a table, or two or more of one problem, print a best above their worst and
    nothing says which sense they have, they are taken to maximise, and the row asks.
    """
    groups = _reversed_groups(blocks)
    asked = {id(block) for group in groups for block in group}
    found = [turned(replace(each, maximise=True) if id(each) in asked else each) for each in blocks]
    return found, [_question(paper, group) for group in groups]


def _reversed_groups(blocks: Sequence[Block]) -> list[list[Block]]:
    open_blocks = [each for each in blocks if not each.maximise and each.function is None]
    groups: dict[str, list[Block]] = {}
    for block in open_blocks:
        groups.setdefault(_label(block), []).append(block)
    found = []
    for group in groups.values():
        if _all_reversed(group):
            found.append(group)
            continue
        problems: dict[str, list[Block]] = {}
        for block in group:
            problems.setdefault(block.problem_name, []).append(block)
        found += [same for same in problems.values() if len(same) > 1 and _all_reversed(same)]
    return found


def _label(block: Block) -> str:
    return next(iter(block.cells.values())).label


def _all_reversed(blocks: Sequence[Block]) -> bool:
    telling = [(block, sense) for block in blocks if (sense := _sense(block))]
    if len(telling) == 1 and not {"best", "worst"} <= telling[0][0].cells.keys():
        return False  # of one block without both ends, a wrong number is as likely
    return bool(telling) and all(sense < 0 for _, sense in telling)


def _sense(block: Block) -> int:
    """Return 1 where a block prints best below worst, -1 where above, 0 where neither is sure."""
    inner = [name for name in block.cells if name in INNER or quantile_share(name) is not None]
    names = [name for name in ("best", *inner[:1], "worst") if name in block.cells]
    printed = [block.printed(name) for name in names]
    values = [each.value for each in printed]
    if values == sorted(values):
        return int(any(is_less(printed[0], each) for each in printed[1:]))
    is_reversed = values == sorted(values, reverse=True)
    return -int(is_reversed and any(is_less(each, printed[0]) for each in printed[1:]))


def _question(paper: str, group: Sequence[Block]) -> AuditRow:
    block = group[0]
    return audit_row(
        paper,
        tuple(block.cells[name] for block in group for name in block.cells),
        check="maximisation",
        grade=Grade.NOTED,
        explanation=(
            f"maximisation? In every block whose numbers tell, {len(group)} in all, the best is "
            f"greater than the worst or the mean, as {_example(block)}; they are read so"
        ),
    )


def _example(block: Block) -> str:
    return ", ".join(f"{name} {cell.printed.text}" for name, cell in block.cells.items())
