"""What each cell of a grid stands under: headings of lines and of columns."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from repro.tables.decision_words import is_decision
from repro.tables.grids import Grid
from repro.tables.headings import (
    heads_algorithms,
    heads_problems,
    heads_runs,
    heads_statistics,
    is_statistic,
    statistics_in,
)
from repro.tables.markup import plain
from repro.tables.numbers import NumberForm, is_word, number_form, split_pair
from repro.tables.shares import quantile_words

_MOST_HEADINGS = 4
_LONG = 60  # letters of a lone text below the numbers that is a note


@dataclass(frozen=True, slots=True, kw_only=True)
class Label:
    """A text that a cell stands under, and the heading of the column of that text, if any.

    `statistic` is what it names only among others: "q1" of 25 %.
    """

    text: str
    heading: str = ""
    statistic: str = ""

    @property
    def statistics(self) -> tuple[tuple[str, ...], str]:
        """The statistics that it names, in its order, and what else it says."""
        return ((self.statistic,), "") if self.statistic else statistics_in(self.text)

    @property
    def is_statistic(self) -> bool:
        """Whether it names statistics and nothing else."""
        names, rest = self.statistics
        return bool(names) and not rest


@dataclass(frozen=True, slots=True, kw_only=True)
class GridCell:
    """A text where a number is expected, at line `i` and column `j` of its grid."""

    text: str
    i: int
    j: int
    row: tuple[Label, ...]
    column: tuple[Label, ...]

    @property
    def row_name(self) -> str:
        """The labels of its line."""
        return " ".join(label.text for label in self.row if label.text) or f"line {self.i + 1}"

    @property
    def column_name(self) -> str:
        """The labels of its column."""
        return " ".join(label.text for label in self.column if label.text) or f"column {self.j + 1}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """The cells of a table, lone texts that stand below some, and the headings of their labels."""

    cells: tuple[GridCell, ...]
    footers: tuple[str, ...]
    corner: tuple[str, ...] = ()


def looks_numeric(text: str) -> bool:
    """Say whether a text is a number, two of them, or one of the usual stand-ins for one."""
    form = number_form(text)
    return isinstance(form, NumberForm) or form.known or _is_pair(text)


def _is_pair(text: str) -> bool:
    if split_pair(text) is not None:
        return True
    parts = plain(text).split("/")
    return 2 <= len(parts) <= 3 and all(_is_number(part.strip()) for part in parts)


def _is_number(text: str) -> bool:
    return isinstance(number_form(text.strip("()")), NumberForm)


def layout(grid: Grid) -> Layout:
    """Return the cells of a table with all that they stand under."""
    top = _heading_lines(grid.lines)
    order = _names_first(grid.lines, top)
    found = _layout([[line[j] for j in order] for line in grid.lines], top)
    cells = tuple(sorted((replace(c, j=order[c.j]) for c in found.cells), key=lambda c: (c.i, c.j)))
    return replace(found, cells=cells)


def _names_first(lines: Sequence[Sequence[str]], top: int) -> list[int]:
    """Return the columns, those of names before a column of ranks, say, that stands left of them.

    They are words below a heading of problems or algorithms.
    """
    columns = range(len(lines[0]))
    first = _first_value_column(lines, top)
    names = [
        j
        for j in columns[first + 1 :]
        if any(heads_algorithms(line[j]) or heads_problems(line[j]) for line in lines[:top])
        and all(is_word(line[j]) for line in lines[top:] if line[j])
    ]
    return [*columns[:first], *names, *(j for j in columns[first:] if j not in names)]


def _layout(lines: Sequence[Sequence[str]], top: int) -> Layout:
    """Return the cells of lines whose columns of names stand first."""
    first = _first_value_column(lines, top)
    heads = _heads(lines[:top], first, len(lines[0]))
    above: list[str] = [""] * first
    group = ""
    footers: list[str] = []
    cells: list[GridCell] = []
    waiting: list[Sequence[str]] = []  # heading lines that repeat among the numbers
    for i in range(top, len(lines)):
        line = lines[i]
        filled = [text for text in line if text]
        if not filled:
            continue
        numbers = sum(_is_number(text) or _is_pair(text) for text in line[first:])
        if not numbers and len(filled) == 1:
            later = any(any(map(_is_number, below[first:])) for below in lines[i + 1 :])
            if later and len(filled[0]) < _LONG:
                group = filled[0]
            else:
                footers.append(filled[0])
            continue
        if not numbers and not any(
            looks_numeric(text) or is_decision(text, line[0]) for text in line[first:] if text
        ):
            waiting.append(line)
            continue
        if waiting:
            heads, waiting, group = _heads(waiting, first, len(line)), [], ""
        if first:
            above = [text or old for text, old in zip(line[:first], above, strict=True)]
        cells.extend(_cells(i, line, (group, above, heads)))
    return Layout(
        cells=tuple(_of_columns_with_numbers(cells)),
        footers=tuple(footers),
        corner=tuple(text for texts in heads[:first] for text in texts),
    )


def _cells(
    i: int, line: Sequence[str], place: tuple[str, Sequence[str], Sequence[tuple[str, ...]]]
) -> Iterator[GridCell]:
    group, labels, heads = place
    first = len(labels)
    row = (
        *([Label(text=plain(group))] if group else []),
        *(
            Label(text=plain(text), heading=" ".join(heads[j]))
            for j, text in enumerate(labels)
            if text
        ),
    )
    for j in range(first, len(line)):
        if line[j]:
            column = tuple(Label(text=text) for text in heads[j] if text)
            yield GridCell(text=line[j], i=i, j=j, row=row, column=column)


def _of_columns_with_numbers(cells: Sequence[GridCell]) -> list[GridCell]:
    """Return the cells but for columns of words or of marks alone that decide nothing."""
    with_numbers = {cell.j for cell in cells if _was_a_number(cell.text)}
    words = {cell.j for cell in cells if not is_decision(cell.text, cell.column_name)}
    return [cell for cell in cells if cell.j in with_numbers or cell.j not in words]


def _was_a_number(text: str) -> bool:
    """Say whether a text is a number, or stands for one that is known in part."""
    return looks_numeric(text) and any(map(str.isdigit, text))


def _heading_lines(lines: Sequence[Sequence[str]]) -> int:
    """Return how many lines at the top are headings: those before the first line of numbers."""
    for i, line in enumerate(lines[: _MOST_HEADINGS + 1]):
        rest = [text for text in line[1:] if text]
        numbers = [text for text in rest if looks_numeric(text)]
        sure = [text for text in rest if _was_a_number(text)]
        heads = _is_heading_of_sizes(lines, i) or _are_statistics(rest)
        if sure and 2 * len(numbers) >= len(rest) and not heads:
            return i
    return min(1, len(lines))


def _is_heading_of_sizes(lines: Sequence[Sequence[str]], i: int) -> bool:
    """Say whether a line of whole numbers heads columns: the next one names statistics."""
    whole = all(text.isdigit() for text in lines[i][1:] if text)
    if not whole or any(is_statistic(text) for line in lines[:i] for text in line):
        return False
    below = lines[i + 1] if i + 1 < len(lines) else ()
    return sum(is_statistic(text) for text in below if text) >= 2 and not any(
        _is_number(text) for text in below[1:]
    )


def _are_statistics(texts: Sequence[str]) -> bool:
    """Say whether all texts are statistics, some of them as shares: mean, std, 0.25, 0.75."""
    words = quantile_words(texts)
    return bool(words) and all(text in words or is_statistic(text) for text in texts)


def _first_value_column(lines: Sequence[Sequence[str]], top: int) -> int:
    """Return how many columns at the left hold labels: all up to one of names of statistics."""
    width = len(lines[0])
    for j in range(width - 2, 0, -1):
        texts = [line[j] for line in lines[top:] if line[j]]
        if len(texts) > 1 and all(map(is_statistic, texts)):
            return j + 1
    for j in range(width - 1):
        heading = [line[j] for line in lines[:top] if line[j]]
        texts = [line[j] for line in lines[top:] if line[j]]
        counts = j == 0 and (_counts_lines(texts) or _is_varied(lines[:top], texts))
        if not _holds_labels(heading, texts, leftmost=j == 0, counts=counts):
            return j
    return width - 1


def _counts_lines(texts: Sequence[str]) -> bool:
    """Say whether numbers go up by one from line to line, as those of functions or runs do."""
    whole = all(text.isascii() and text.isdigit() and len(text) < 6 for text in texts)
    return whole and len(texts) > 2 and {int(b) - int(a) for a, b in pairwise(texts)} == {1}


def _is_varied(headings: Sequence[Sequence[str]], texts: Sequence[str]) -> bool:
    """Say whether numbers differ from line to line, with statistics alone beside them."""
    others = [text for line in headings for text in line[1:] if text]
    named = sum(bool(statistics_in(text)[0]) for text in others)
    return len(set(texts)) == len(texts) > 1 and 2 <= named == len(others)


def _holds_labels(
    heading: Sequence[str], texts: Sequence[str], *, leftmost: bool, counts: bool
) -> bool:
    if not texts:
        return True
    if any(is_statistic(text) for text in heading):
        return False
    if counts or _are_statistics([text for text in texts if not heads_runs(text)]):
        return True
    if 2 * sum(not looks_numeric(text) for text in texts) > len(texts):
        return True
    named = any(
        heads_problems(text) or heads_algorithms(text) or heads_statistics(text) for text in heading
    )
    whole = all(text.isascii() and text.isdigit() for text in texts)
    if named:
        return whole or any(not looks_numeric(text) for text in texts)
    counted = [int(text) for text in texts if len(text) < 6] if whole else []
    return leftmost and not heading and len(counted) > 1 and counted == sorted(counted)


def _heads(lines: Sequence[Sequence[str]], first: int, width: int) -> list[tuple[str, ...]]:
    """Return the headings of every column; an empty one belongs to the one at its left."""
    filled = []
    for k, line in enumerate(lines):
        texts = [plain(text) for text in line]
        is_upper = k < len(lines) - 1
        for j in range(first + 1, len(texts)):
            lower = any(below[j] for below in lines[k + 1 :])
            if not texts[j] and (lower if is_upper else not any(up[j] for up in lines[:k])):
                texts[j] = texts[j - 1]
        filled.append(texts)
    heads = [tuple(dict.fromkeys(t[j] for t in filled if t[j])) for j in range(width)]
    return _with_owners(heads, first)


def _with_owners(heads: list[tuple[str, ...]], first: int) -> list[tuple[str, ...]]:
    """Return the headings; a statistic that stands right of each of several names is theirs.

    As in: F, GWO, rank, PSO, rank.
    """
    values = range(first, len(heads))
    alone = {j for j in values if len(heads[j]) == 1 and is_statistic(heads[j][0])}
    left = [heads[j - 1] for j in alone if j > first and j - 1 not in alone]
    if not len({heads[j] for j in alone}) < len(alone) == len(left) == len(set(left)):
        return heads
    return [heads[j - 1] + heads[j] if j in alone else heads[j] for j in range(len(heads))]
