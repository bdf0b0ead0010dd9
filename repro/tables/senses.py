"""Whether the best run of a block is the least or the greatest one."""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations, product

from repro.tables.arithmetic import Arithmetic, both, is_less
from repro.tables.blocks import Block, turned
from repro.tables.published import Printed
from repro.tables.relations import Cell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.statistic_words import quantile_share

MANY_RUNS = 1000
LEAST_IS_BEST = "the best run is the least one"
# what is the better the greater it is, wherever it is measured
_GREATER_IS_BETTER = re.compile(
    r"\b(?:accurac\w*|precision|recall|f1[\s-]?score|auc|profits?|revenues?|rewards?"
    r"|hyper-?volumes?|psnr|ssim|sensitivity|specificity|throughput)\b",
    re.IGNORECASE,
)
_INNER = ("mean", "lowest", "highest")  # of which one may be the best, and one the worst
Numbers = Mapping[str, Cell]  # of one block, by statistic


@dataclass(frozen=True, slots=True, kw_only=True)
class Numbered:
    """The numbers of a block, and what it is of."""

    numbers: Numbers
    problem: str
    name: str  # problem, algorithm and quantity, as far as they are told


def sense_of(numbers: Numbers, runs: int | None = None, significant: int | None = None) -> int:
    """Return 1 where the best is surely the least number, -1 where the greatest, 0 where open.

    Numbers that are equal but for their rounding do not tell, nor does a mean within what the
    summing of so many `runs` may lose; of a block that is in order in neither sense, best and worst
    alone tell. Digits that are `significant` are told of every number.
    """
    ends = {name: numbers[name] for name in ("best", "worst") if name in numbers}
    summing = 2 * ((runs or MANY_RUNS) + 2) * Arithmetic().roundoff
    rises = falls = False
    for names in _in_order(numbers):
        one, other = (numbers[name].printed for name in names)
        share = summing if "mean" in names else None
        alike = share is None and _shape(one, significant) == _shape(other, significant)
        rises = rises or _less(one, other, share, alike=alike)
        falls = falls or _less(other, one, share, alike=alike)
    if rises and falls and len(numbers) > len(ends):
        return sense_of(ends, runs, significant)
    return rises - falls


def _less(one: Printed, other: Printed, share: Fraction | None, *, alike: bool) -> bool:
    # what is rounded alike stays in order
    return one.value < other.value and (alike or is_less(one, other, share=share or Fraction(0)))


def _shape(printed: Printed, significant: int | None) -> tuple[object, ...]:
    """Return where a number was rounded, as far as its digits show; numbers of one shape alike."""
    whole, point, decimals = printed.mantissa.lstrip("+-").partition(".")
    if printed.power is not None:
        return "power", len(whole), len(decimals)
    if point:
        return "fixed", len(decimals)
    kept = len(whole.rstrip("0"))  # none of a 0, which may stand for anything that is small
    if significant is not None and kept:
        return ("whole",)
    return ("whole", len(whole) - kept) if kept else (object(),)


def _in_order(numbers: Numbers) -> list[tuple[str, str]]:
    """Return the pairs of statistics of which the first is no worse than the second."""
    inner = [name for name in numbers if name in _INNER or quantile_share(name) is not None]
    groups = [[name for name in names if name in numbers] for names in (["best"], inner, ["worst"])]
    pairs = [pair for two in combinations(groups, 2) for pair in product(*two)]
    return sorted(pairs, key=lambda pair: "mean" in pair)  # which tell the least go last


def guessed_senses(
    parts: Sequence[Numbered], runs: int | None = None, significant: int | None = None
) -> list[int]:
    """Return the sense of each block of a table of which none is told; 0 where nothing tells one.

    Two or more blocks of one problem that agree have their own sense, as has what is the better
    the greater it is; all others that of most blocks, the least being the best of as many.
    """
    own = [sense_of(part.numbers, runs, significant) for part in parts]
    most = -1 if sum(own) < 0 else int(any(own))
    groups: dict[str, list[int]] = defaultdict(list)
    for part, sense in zip(parts, own, strict=True):
        if sense:
            groups[_group(part)].append(sense)
    agreed = {
        group: senses[0]
        for group, senses in groups.items()
        if len(set(senses)) == 1 and (len(senses) > 1 or _GREATER_IS_BETTER.search(group))
    }
    return [agreed.get(_group(part), most) for part in parts]


def _group(part: Numbered) -> str:
    """Return what shares its sense with a block: its problem, or a quantity as accuracy is."""
    named = _GREATER_IS_BETTER.search(part.name)
    return named[0].lower() if named else part.problem


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
    telling = [(block, sense) for block in blocks if (sense := sense_of(block.cells, block.n))]
    if len(telling) == 1 and not {"best", "worst"} <= telling[0][0].cells.keys():
        return False  # of one block without both ends, a wrong number is as likely
    return bool(telling) and all(sense < 0 for _, sense in telling)


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


def in_either_sense(
    rows: Iterable[AuditRow], turned_round: Sequence[AuditRow]
) -> Iterator[AuditRow]:
    """Yield rows of a block whose sense is open, which hold where those of the other sense do.

    The others hold if the least run is the best.
    """
    others = {(row.check, _places(row)): row for row in turned_round}
    for row in rows:
        other = others.get((row.check, _places(row)))
        more = LEAST_IS_BEST if other is None else other.condition
        yield replace(row, condition=both(row.condition, more))


def _places(row: AuditRow) -> frozenset[tuple[str | None, str | None]]:
    if row.cells:
        return frozenset((cell["row"], cell["column"]) for cell in row.cells)
    return frozenset([(row.row, row.column)])
