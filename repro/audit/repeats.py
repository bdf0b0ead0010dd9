"""Equal numbers in places that have nothing to do with each other."""

import itertools
from collections import defaultdict
from collections.abc import Iterator, Sequence

from repro.audit.blocks import Block
from repro.audit.rows import AuditRow, Grade, audit_row
from repro.audit.spans import shown
from repro.published import Printed
from repro.relations import TableCell

DIGITS = 4  # significant digits from which an equal number is worth a note
DIGITS_WITH_POWER = 3  # as above, where a power of ten agrees too
DIGITS_OF_BLOCK = 6  # digits of a whole block that recur with other powers of ten

Entry = tuple[Block, str]  # a block and the name of one of its statistics


def repeat_rows(paper: str, blocks: Sequence[Block]) -> Iterator[AuditRow]:
    """Yield a row per number, and per set of digits, that recurs in different blocks."""
    entries = [(block, name) for block in blocks for name in block.claims if _stands(block, name)]
    seen = defaultdict(list)
    for block, name in entries:
        seen[block.quantity, block.printed(name).value].append((block, name))
    for same in seen.values():
        if len({id(block) for block, _ in same}) > 1:
            yield _equal_cells(paper, same, among=len(entries))
    yield from _equal_digits(paper, blocks)


def digits(printed: Printed) -> str:
    """Return the significant digits without sign, point and power of ten."""
    mantissa = printed.text.replace("−", "-")
    for mark in "×xeE":
        mantissa = mantissa.partition(mark)[0]
    return mantissa.strip().lstrip("+-").replace(".", "").lstrip("0")


def _stands(block: Block, name: str) -> bool:
    """Say whether the number is long enough to be telling, and not one that the function fixes."""
    printed = block.printed(name)
    scientific = any(mark in printed.text for mark in "×xeE")
    if len(digits(printed)) < (DIGITS_WITH_POWER if scientific else DIGITS):
        return False
    function = block.function
    if function is None:
        return True
    least = function(function.minimiser(block.problem.dimension))
    return all(abs(printed.value - value) > printed.rounding for value in (least, function.minimum))


def _equal_cells(paper: str, same: Sequence[Entry], *, among: int) -> AuditRow:
    block, name = same[0]
    printed = block.printed(name)
    places = "; ".join(f"{b.problem_name} {statistic} of {b.algorithm}" for b, statistic in same)
    pairs = among * (among - 1) // 2
    chance = pairs / (9 * 10 ** (len(digits(printed)) - 1))
    return audit_row(
        paper,
        _cells(same),
        check="repeat",
        grade=Grade.NOTED,
        explanation=(
            f"{printed.text} stands in {len(same)} cells: {places}. Among {among} numbers of this "
            f"length there are {pairs} pairs; if digits were random, {shown(chance)} of them "
            f"would agree in all {len(digits(printed))} digits, fewer still in the power of ten"
        ),
    )


def _equal_digits(paper: str, blocks: Sequence[Block]) -> Iterator[AuditRow]:
    """Yield a row per series of digits that a whole block shares with others, powers aside."""
    seen = defaultdict(list)
    for block in blocks:
        names = tuple(block.claims)
        series = tuple(digits(block.printed(name)) for name in names)
        if len(set(series)) == len(names) > 1 and sum(map(len, series)) >= DIGITS_OF_BLOCK:
            seen[block.quantity, names, series].append(block)
    for (_, names, series), same in seen.items():
        values = {tuple(block.printed(name).value for name in names) for block in same}
        if len(same) > 1 and len(values) > 1:
            places = "; ".join(f"{block.algorithm} on {block.problem_name}" for block in same)
            yield audit_row(
                paper,
                _cells(tuple(itertools.product(same, names))),
                check="repeat-digits",
                grade=Grade.NOTED,
                explanation=(
                    f"the digits {' and '.join(series)} ({' and '.join(names)}) stand in "
                    f"{len(same)} places, powers of ten aside: {places}"
                ),
            )


def _cells(entries: Sequence[Entry]) -> tuple[TableCell, ...]:
    return tuple(block.cell(name) for block, name in entries)
