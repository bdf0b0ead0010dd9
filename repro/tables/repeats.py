"""Equal numbers in places that have nothing to do with each other."""

import itertools
import math
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence

from repro.tables.blocks import Block
from repro.tables.published import Printed
from repro.tables.relations import Cell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import is_scientific_number, shown

DIGITS = 4  # significant digits from which an equal number is worth a note
DIGITS_WITH_POWER = 3  # as above, where a power of ten agrees too
DIGITS_OF_BLOCK = 6  # digits of a whole block that recur with other powers of ten
CHANCE = 0.1  # agreeing pairs expected by chance from which on an agreement says nothing

Entry = tuple[Block, str]  # a block and the name of one of its statistics


def repeat_rows(paper: str, blocks: Sequence[Block]) -> Iterator[AuditRow]:
    """Yield a row per number, and per set of digits, that recurs in different blocks."""
    alike, equal = defaultdict(list), defaultdict(list)
    for block in blocks:
        for name in block.cells:
            if _stands(block, name):
                printed = block.printed(name)
                decade = math.floor(math.log10(abs(printed.value)))
                size = (block.quantity, len(_telling(printed)), decade)
                alike[size].append((block, name))
                equal[size, printed.value].append((block, name))
    pairs_of = {size: _pairs(entries) for size, entries in alike.items()}
    for (size, _), same in equal.items():
        pairs = pairs_of[size]
        chance = pairs / (9 * 10 ** (size[1] - 1))
        if chance < CHANCE and _pairs(same) and not _is_one_optimum(same):
            yield _equal_cells(paper, same, pairs=pairs, chance=chance)
    yield from _equal_digits(paper, blocks)


def _is_one_optimum(same: Sequence[Entry]) -> bool:
    """Say whether different searches have one best of one problem: all may have found it."""
    problems = {b.problem_name if b.problem_name != b.algorithm else "" for b, _ in same}
    return {name for _, name in same} == {"best"} and len(problems) == 1


def _pairs(entries: Sequence[Entry]) -> int:
    """Return how many pairs of different blocks the entries form."""
    if len(entries) < 2:
        return 0
    same = Counter(id(block) for block, _ in entries).values()
    return math.comb(len(entries), 2) - sum(math.comb(times, 2) for times in same)


def digits(printed: Printed) -> str:
    """Return the significant digits without sign, point and power of ten."""
    return printed.mantissa.lstrip("+-").replace(".", "").lstrip("0")


def _telling(printed: Printed) -> str:
    """Return the digits but for zeros behind the point of a whole number: they are no chance."""
    whole, _, fraction = printed.mantissa.partition(".")
    is_whole = printed.power is None and not fraction.strip("0")
    return whole.lstrip("+-0") if is_whole else digits(printed)


def _stands(block: Block, name: str) -> bool:
    """Say whether the number is long enough to be telling, and not one that the function fixes."""
    printed = block.printed(name)
    scientific = is_scientific_number(printed)
    if len(_telling(printed)) < (DIGITS_WITH_POWER if scientific else DIGITS):
        return False
    fixed = block.function.fixed if block.function else ()
    return all(abs(printed.value - value) > printed.rounding for value in fixed)


def _equal_cells(paper: str, same: Sequence[Entry], *, pairs: int, chance: float) -> AuditRow:
    block, name = same[0]
    places = "; ".join(_in_words(block, statistic) for block, statistic in same)
    return audit_row(
        paper,
        _cells(same),
        check="repeat",
        grade=Grade.NOTED,
        explanation=(
            f"{block.printed(name).text} stands in {len(same)} cells: {places}. The numbers of "
            f"this length and power of ten form {pairs} pair{'s' * (pairs > 1)} across blocks; if "
            f"digits were random, {shown(chance)} of these would agree"
        ),
    )


def _in_words(block: Block, statistic: str) -> str:
    """Return the statistic and whose it is, of the names that the table gives."""
    problem = block.problem_name if block.problem_name != block.algorithm else ""
    own = f"{problem} {statistic}".strip()
    return f"{own} of {block.algorithm}" if block.algorithm else own


def _equal_digits(paper: str, blocks: Sequence[Block]) -> Iterator[AuditRow]:
    """Yield a row per series of digits that a whole block shares with others, powers aside."""
    seen = defaultdict(list)
    for block in blocks:
        names = tuple(block.cells)
        series = tuple(digits(block.printed(name)) for name in names)
        if len(set(series)) == len(names) > 1 and sum(map(len, series)) >= DIGITS_OF_BLOCK:
            seen[block.quantity, names, series].append(block)
    for (_, names, _), same in seen.items():
        values = {tuple(block.printed(name).value for name in names) for block in same}
        if len(same) > 1 and len(values) > 1:
            shown_digits = " and ".join(same[0].printed(name).mantissa for name in names)
            places = "; ".join(
                " on ".join(filter(None, dict.fromkeys((block.algorithm, block.problem_name))))
                for block in same
            )
            yield audit_row(
                paper,
                _cells(tuple(itertools.product(same, names))),
                check="repeat-digits",
                grade=Grade.NOTED,
                explanation=(
                    f"the digits {shown_digits} ({' and '.join(names)}) stand in "
                    f"{len(same)} places, powers of ten aside: {places}"
                ),
            )


def _cells(entries: Sequence[Entry]) -> tuple[Cell, ...]:
    return tuple(block.cells[name] for block, name in entries)
