"""The numbers of a table by problem, algorithm and statistic."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from repro.errors import DeclarationError
from repro.tables.grids import Grid
from repro.tables.headings import (
    heads_algorithms,
    heads_problems,
    is_problem_name,
    is_statistic,
    names_quantity,
    statistics_in,
)
from repro.tables.layout import GridCell, Label, Layout, layout
from repro.tables.markup import plain
from repro.tables.numbers import NoNumber, number_form, split_pair
from repro.tables.published import Printed
from repro.tables.relations import PlacedNumber

OF_RUNS = frozenset(("best", "mean", "median", "worst", "std", "variance", "sem", "q1", "q3"))
OF_RUNS |= {"lowest", "highest"}
BESIDE = frozenset(("rank", "wins", "ties", "losses", "p-value", "z", "h", "r", "time"))
BESIDE |= {"average rank", "total rank", "success rate"}
VALUE = "value"  # the statistic of a number that no heading names one for
_MOST_RANKS = 40
_TALLY = re.compile(r"\(?\s*([0-9]{1,4})\s*[/|]\s*([0-9]{1,4})\s*[/|]\s*([0-9]{1,4})\s*\)?")


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """A number of a table: what it is of, and where in the grid it stands."""

    problem: str
    algorithm: str
    statistic: str
    quantity: str
    number: PlacedNumber
    i: int
    j: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Skipped:
    """A text that is not read as a number, where it stands, and why."""

    text: str
    where: str
    because: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Gathered:
    """What is read of a table; `words` says which heading is read as which statistic."""

    label: str
    entries: tuple[Entry, ...]
    skipped: tuple[Skipped, ...]
    words: dict[str, str]
    pairs: tuple[str, str]  # what the two numbers of one cell are, "" where there is none
    notes: tuple[str, ...]
    text: str  # of title and footers


@dataclass(frozen=True, slots=True, kw_only=True)
class _Named:
    """A cell with its statistics and the labels that name none."""

    cell: GridCell
    statistics: tuple[str, ...]
    problem: str
    algorithm: str
    quantity: str


def gathered(grid: Grid, label: str) -> Gathered:
    """Return the numbers of a grid with what they are of, and every text that is none."""
    return gathered_cells(layout(grid), label, title=grid.title, notes=grid.notes)


def gathered_cells(
    found: Layout, label: str, *, title: str, notes: tuple[str, ...] = ()
) -> Gathered:
    """Return the same of cells whose headings are known."""
    words: dict[str, str] = {}
    by_column: bool | None = _statistics_stand_in_columns(found.cells)
    if _are_names(cell.column if by_column else cell.row for cell in found.cells):
        by_column = None
    named = [_named(cell, words, by_column=by_column) for cell in found.cells]
    second = _second_statistic(named)
    entries: list[Entry] = []
    skipped: list[Skipped] = []
    for each in named:
        for read in _read(each, label, second):
            (entries if isinstance(read, Entry) else skipped).append(read)  # type: ignore[arg-type]
    has_pairs = any(split_pair(each.cell.text) for each in named)
    return Gathered(
        label=label,
        entries=tuple(entries),
        skipped=tuple(skipped),
        words=words,
        pairs=("mean", second) if has_pairs else ("", ""),
        notes=notes,
        text=" ".join(plain(text) for text in (title, *found.footers)),
    )


def _statistics_stand_in_columns(cells: Sequence[GridCell]) -> bool:
    """Say whether the headings of columns name more statistics than those of lines."""
    return _weight(cell.column for cell in cells) >= _weight(cell.row for cell in cells)


def _are_names(places: Iterator[tuple[Label, ...]]) -> bool:
    """Say whether one statistic's word stands in a few of the labels: "Best-first search"."""
    texts = {label.text for labels in places for label in labels}
    found = [names for text in texts if (names := statistics_in(text)[0])]
    return (
        len(set(found)) == 1 and 2 * len(found) < len(texts) and not any(map(is_statistic, texts))
    )


def _weight(places: Iterator[tuple[Label, ...]]) -> tuple[int, int]:
    """Return how many statistics of runs are named, then over how many cells one beside them is."""
    texts = Counter(label.text for labels in places for label in labels)
    sure = {name for text in texts if is_statistic(text) for name in statistics_in(text)[0]}
    some = {name for text in texts for name in statistics_in(text)[0]}
    beside = sum(
        times for text, times in texts.items() if not BESIDE.isdisjoint(statistics_in(text)[0])
    )
    return 10 * len(sure & OF_RUNS) + len(some & OF_RUNS), beside


def _named(cell: GridCell, words: dict[str, str], *, by_column: bool | None) -> _Named:
    """Return the cell with what its labels name; `by_column` is None where none are statistics."""
    axis, other = (cell.column, cell.row) if by_column else (cell.row, cell.column)
    if by_column is None:
        axis, other = (), (*cell.row, *cell.column)
    statistics: tuple[str, ...] = ()
    quantity = ""
    rest: list[Label] = []
    told = _telling(axis)
    for label in axis:
        names, left = statistics_in(label.text)
        if label is told:
            statistics = names
            words.setdefault(label.text, ", ".join(names))
            quantity = left if names_quantity(left) else ""
            rest.extend([Label(text=left, heading=label.heading)] if left and not quantity else [])
        else:
            rest.append(label)
    for label in other:  # a line of ranks among statistics, say
        names, left = statistics_in(label.text)
        if names and not left and BESIDE.issuperset(names):
            statistics = names
            words.setdefault(label.text, ", ".join(names))
        else:
            rest.append(label)
    in_column = {label.text for label in cell.column}
    problem, algorithm = _roles([(label, label.text in in_column) for label in rest])
    return _Named(
        cell=cell,
        statistics=statistics,
        problem=problem,
        algorithm=algorithm,
        quantity=quantity,
    )


def _telling(labels: Sequence[Label]) -> Label | None:
    """Return the label that names the statistic: one of runs before what stands beside them."""
    sure = any(is_statistic(label.text) for label in labels)
    found = [(label, *statistics_in(label.text)) for label in labels]
    able = [(label, names) for label, names, left in found if names and (not left or not sure)]
    of_runs = [label for label, names in able if not OF_RUNS.isdisjoint(names)]
    return next(iter((*of_runs, *(label for label, _ in able))), None)


def _roles(labels: Sequence[tuple[Label, bool]]) -> tuple[str, str]:
    """Return what of the labels names the problem, and what the algorithm."""
    problems, algorithms, open_ones = [], [], []
    for label, in_column in labels:
        if heads_algorithms(label.heading):
            algorithms.append(label.text)
        elif heads_problems(label.heading) or is_problem_name(label.text):
            problems.append(label.text)
        else:
            open_ones.append((label.text, in_column))
    for text, in_column in open_ones:
        is_algorithm = in_column if not algorithms else False
        if problems and not algorithms:
            is_algorithm = True
        (algorithms if is_algorithm else problems).append(text)
    return " ".join(problems), " ".join(algorithms)


def _second_statistic(named: Sequence[_Named]) -> str:
    """Return what the second number of a cell is: a rank where all are small whole numbers."""
    pairs = [pair for each in named if (pair := split_pair(each.cell.text))]
    told = Counter(
        each.statistics[1]
        for each in named
        if len(each.statistics) > 1 and split_pair(each.cell.text)
    )
    if told:
        return told.most_common(1)[0][0]
    ranks = [
        text
        for _, text, sign in pairs
        if sign != "±" and text.isdigit() and int(text) <= _MOST_RANKS
    ]
    return "rank" if pairs and len(ranks) == len(pairs) else "std"


def _read(each: _Named, label: str, second: str) -> Iterator[Entry | Skipped]:
    """Yield the numbers of a cell, or why there is none."""
    cell = each.cell
    first = each.statistics[0] if each.statistics else ""
    then = each.statistics[1] if len(each.statistics) > 1 else second
    text = plain(cell.text)
    inner = text[1:-1] if text[:1] + text[-1:] == "()" else ""
    if pair := _pair(each):
        yield _entry(each, label, pair[0], first or "mean")
        yield _entry(each, label, pair[1], then)
    elif first == "wins" and (counts := _TALLY.fullmatch(text)):
        for name, count in zip(_tally_order(each), counts.groups(), strict=True):
            yield _entry(each, label, count, name)
    elif first == "wins" and _refused(cell.text):
        yield _skipped(cell, "it is no count of wins, ties and losses", label)
    elif inner and first in {"", "mean", "median", "best"} and not _refused(inner):
        yield _entry(each, label, inner, then)
    elif reason := _refused(cell.text):
        yield _skipped(cell, reason, label)
    else:
        yield _entry(each, label, cell.text, first or VALUE)


def _tally_order(each: _Named) -> tuple[str, str, str]:
    """Return which count stands where, by the heading: ties last, or between."""
    names = [label.text for label in (*each.cell.row, *each.cell.column)]
    last = any(re.search(r"/\s*(?:[=≈~]|[td]\w*)\s*\)?$", name, re.IGNORECASE) for name in names)
    return ("wins", "losses", "ties") if last else ("wins", "ties", "losses")


def _pair(each: _Named) -> tuple[str, str] | None:
    if found := split_pair(each.cell.text):
        return found[:2]
    parts = plain(each.cell.text).split("/")
    if len(each.statistics) == len(parts) == 2 and not any(map(_refused, parts)):
        return parts[0].strip(), parts[1].strip()
    return None


def _refused(text: str) -> str:
    """Return why a text is no number that a double holds; nothing where it is one."""
    form = number_form(text)
    if isinstance(form, NoNumber):
        return form.because or "it is not a number"
    try:
        Printed(text)
    except DeclarationError as error:
        return str(error)
    return ""


def _entry(each: _Named, label: str, text: str, statistic: str) -> Entry:
    cell = each.cell
    number = PlacedNumber(
        printed=Printed(text), label=label, row=cell.row_name, column=cell.column_name
    )
    return Entry(
        problem=each.problem,
        algorithm=each.algorithm,
        statistic=statistic,
        quantity=each.quantity,
        number=number,
        i=cell.i,
        j=cell.j,
    )


def _skipped(cell: GridCell, because: str, label: str) -> Skipped:
    return Skipped(
        text=cell.text[:60], where=f"{label}, {cell.row_name}, {cell.column_name}", because=because
    )


def numbered(entries: Sequence[Entry]) -> Iterator[tuple[tuple[str, str, str, int], Entry]]:
    """Yield each statistic with its problem, algorithm, quantity and how often these stood before.

    What one block prints twice under one name belongs to two blocks.
    """
    times: defaultdict[tuple[str, ...], int] = defaultdict(int)
    for entry in entries:
        if entry.statistic in OF_RUNS:
            place = (entry.problem, entry.algorithm, entry.quantity, entry.statistic)
            yield (*place[:3], times[place]), entry
            times[place] += 1
