"""The words that each cell of a table stands under, as statistics, problems and algorithms."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from repro.tables.headings import (
    heads_algorithms,
    heads_problems,
    is_problem_name,
    names_quantity,
    statistics_in,
)
from repro.tables.layout import GridCell, Label
from repro.tables.shares import quantile_words, tally_words
from repro.tables.statistic_words import RANGE, quantile_share

OF_RUNS = frozenset(("best", "mean", "median", "worst", "std", "variance", "sem", "q1", "q3"))
OF_RUNS |= {RANGE}
OF_RUNS |= {"lowest", "highest"}
BESIDE = frozenset(("rank", "wins", "ties", "losses", "p-value", "z", "h", "r", "time"))
BESIDE |= {"average rank", "total rank", "success rate"}


@dataclass(frozen=True, slots=True, kw_only=True)
class NamedCell:
    """A cell with its statistics and the labels that name none."""

    cell: GridCell
    statistics: tuple[str, ...]
    problem: str
    algorithm: str
    quantity: str


def is_of_runs(statistic: str) -> bool:
    """Say whether a statistic is one of the runs of a block, not of what stands beside them."""
    return statistic in OF_RUNS or quantile_share(statistic) is not None


def named_cells(cells: Sequence[GridCell], words: dict[str, str]) -> list[NamedCell]:
    """Return the cells with what their labels name; `words` gets what stands for a statistic."""
    cells = _with_words(cells)
    by_column: bool | None = _statistics_stand_in_columns(cells)
    if _are_names(cell.column if by_column else cell.row for cell in cells):
        by_column = None
    return [_named(cell, words, by_column=by_column) for cell in cells]


def _with_words(cells: Sequence[GridCell]) -> list[GridCell]:
    """Return the cells with labels that name statistics together, such as shares, named so."""
    rows = _together(cell.row for cell in cells)
    columns = _together(cell.column for cell in cells)
    if not rows and not columns:
        return list(cells)
    return [
        replace(cell, row=_renamed(cell.row, rows), column=_renamed(cell.column, columns))
        for cell in cells
    ]


def _together(places: Iterable[tuple[Label, ...]]) -> dict[str, str]:
    """Return which labels that stand alone, or next to names, are quantiles or tallies."""
    distinct = list(dict.fromkeys(places))
    texts = [label.text for labels in distinct for label in labels]
    tallies = tally_words(texts)
    words = quantile_words(texts)
    mixed = any(
        label.text in words and any(statistics_in(other.text)[0] for other in labels)
        for labels in distinct
        for label in labels
    )
    return tallies if mixed else words | tallies


def _renamed(labels: tuple[Label, ...], words: Mapping[str, str]) -> tuple[Label, ...]:
    return tuple(replace(label, statistic=words.get(label.text, "")) for label in labels)


def _statistics_stand_in_columns(cells: Sequence[GridCell]) -> bool:
    """Say whether the headings of columns name more statistics than those of lines."""
    return _weight(cell.column for cell in cells) >= _weight(cell.row for cell in cells)


def _are_names(places: Iterator[tuple[Label, ...]]) -> bool:
    """Say whether one statistic's word stands in a few of the labels: "Best-first search"."""
    found_labels = {label.text: label for labels in places for label in labels}.values()
    found = [names for label in found_labels if (names := label.statistics[0])]
    sure = any(label.is_statistic for label in found_labels)
    return len(set(found)) == 1 and 2 * len(found) < len(found_labels) and not sure


def _weight(places: Iterator[tuple[Label, ...]]) -> tuple[int, int]:
    """Return how many statistics of runs are named, then over how many cells one beside them is."""
    times = Counter(label for labels in places for label in labels)
    sure = {name for label in times if label.is_statistic for name in label.statistics[0]}
    some = {name for label in times for name in label.statistics[0]}
    beside = sum(
        count for label, count in times.items() if not BESIDE.isdisjoint(label.statistics[0])
    )
    return 10 * sum(map(is_of_runs, sure)) + sum(map(is_of_runs, some)), beside


def _named(cell: GridCell, words: dict[str, str], *, by_column: bool | None) -> NamedCell:
    """Return the cell with what its labels name; `by_column` is None where none are statistics."""
    axis, other = (cell.column, cell.row) if by_column else (cell.row, cell.column)
    if by_column is None:
        axis, other = (), (*cell.row, *cell.column)
    statistics: tuple[str, ...] = ()
    quantity = ""
    rest: list[Label] = []
    told = _telling(axis)
    for label in axis:
        names, left = label.statistics
        if label is told:
            statistics = names
            words.setdefault(label.text, ", ".join(names))
            quantity = left if names_quantity(left) else ""
            rest.extend([Label(text=left, heading=label.heading)] if left and not quantity else [])
        else:
            rest.append(label)
    for label in other:  # a line of ranks among statistics, say
        names, left = label.statistics
        if names and not left and BESIDE.issuperset(names):
            statistics = names
            words.setdefault(label.text, ", ".join(names))
        else:
            rest.append(label)
    in_column = {label.text for label in cell.column}
    problem, algorithm = _roles([(label, label.text in in_column) for label in rest])
    return NamedCell(
        cell=cell,
        statistics=statistics,
        problem=problem,
        algorithm=algorithm,
        quantity=quantity,
    )


def _telling(labels: Sequence[Label]) -> Label | None:
    """Return the label that names the statistic: one of runs before what stands beside them."""
    sure = any(label.is_statistic for label in labels)
    found = [(label, *label.statistics) for label in labels]
    able = [(label, names) for label, names, left in found if names and (not left or not sure)]
    of_runs = [label for label, names in able if any(map(is_of_runs, names))]
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
