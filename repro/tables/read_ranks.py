"""The ranks that a table from anywhere prints, with what they are ranks of, sums and places."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

from repro.tables.audit_options import AuditOptions
from repro.tables.facts import RankedRows, Ties
from repro.tables.gathered import VALUE, Entry, Gathered
from repro.tables.headings import statistics_in
from repro.tables.rankings import ranking_rows
from repro.tables.relations import Cell

_TIES: Mapping[str, Ties] = {
    "average": "mean", "min": "least", "max": "greatest", "dense": "dense", "ordinal": "order",
}  # fmt: skip
_RANKED = ("mean", "median", "best", VALUE)  # what rows are ranked by
_SUM = re.compile(r"sum|total|σ|∑|sum\sof\sranks", re.IGNORECASE)
_MEAN = re.compile(r"mean|average|avg\.?|ave\.?", re.IGNORECASE)
_TITLE = re.compile(r"\brank(?:s|ing|ings)?\b", re.IGNORECASE)
Row = Mapping[str, Cell]  # by algorithm


@dataclass(frozen=True, slots=True, kw_only=True)
class _Printed:
    """The ranks of one quantity by problem, and the lines over all problems by their heading."""

    ranks: Mapping[str, Row]
    totals: Sequence[tuple[str, Row]]


def with_ranks(table: Gathered, name: str = "") -> Gathered:
    """Return the table; whole numbers under a title of ranks, with no other heading, are ranks.

    So are those of a file of that name, and those above a line of their sums or means.
    """
    statistics = {entry.statistic for entry in table.entries}
    totals = statistics & {"total rank", "average rank"}
    titled = _TITLE.search(f"{table.text} {name.replace('_', ' ')}")
    if statistics - {VALUE, "mean", *totals} or not (titled or totals):
        return table
    count = len({entry.algorithm for entry in table.entries})
    entries = tuple(_as_rank(entry) for entry in table.entries)
    ranks = [
        entry.number.printed.value
        for entry in entries
        if entry.statistic == "rank" and not _over_all(entry.problem)
    ]
    if not ranks or any(not 1 <= rank <= count or (2 * rank) % 1 for rank in ranks):
        return table
    under = "under a title" if titled else "above a line"
    notes = (*table.notes, f"numbers {under} of ranks are taken for ranks")
    return replace(table, entries=entries, notes=notes)


def _as_rank(entry: Entry) -> Entry:
    names = {VALUE: "rank", "mean": "average rank"}
    return replace(entry, statistic=names.get(entry.statistic, entry.statistic))


def rankings_of(table: Gathered, options: AuditOptions) -> Iterator[RankedRows]:
    """Yield the ranks of each quantity in the reading that contradicts least.

    What rows are ranked by, in which sense, and whether a line over all of them holds sums, means
    or places is often not told: what is wrong is wrong in every such reading.
    """
    entries = table.entries
    ranked = [e for e in entries if e.statistic in {"rank", "average rank"}]
    for quantity in dict.fromkeys(entry.quantity for entry in ranked):
        own = [entry for entry in entries if entry.quantity == quantity]
        printed = _printed(own)
        if not printed.ranks:
            yield from (
                RankedRows(means=row) for word, row in printed.totals if word == "average rank"
            )
            continue
        names = set(next(iter(printed.ranks.values()), {}))
        if len(names) < 2 or any(set(row) != names for row in printed.ranks.values()):
            continue
        senses = (False, True) if options.maximise is None else (options.maximise,)
        readings = [
            RankedRows(
                values=values,
                ranks=tuple(printed.ranks.values()),
                sums=totals.get("sums"),
                means=totals.get("means"),
                places=totals.get("places"),
                ties=_TIES.get(options.ties or "", "any"),
                greatest_first=greatest,
            )
            for values, greatest, totals in product(
                _values(own, printed.ranks), senses, _roles(printed.totals, names)
            )
        ]
        yield min(readings, key=lambda reading: len(list(ranking_rows("", reading))))


def _printed(entries: Sequence[Entry]) -> _Printed:
    ranks: dict[str, dict[str, Cell]] = defaultdict(dict)
    totals: dict[tuple[str, int], dict[str, Cell]] = defaultdict(dict)
    times: Counter[tuple[str, str]] = Counter()  # an average rank and an overall rank, say
    again: set[str] = set()
    several = len({entry.problem for entry in entries if entry.problem}) > 1
    for entry in entries:
        # in a line of sums alone, nothing tells that its columns are algorithms
        name = entry.algorithm or entry.problem
        word = _over_all(entry.problem) if entry.statistic == "rank" else entry.statistic
        if entry.statistic == "rank" and several and not entry.problem:
            word = "average rank"  # below lines of several problems
        if word in {"average rank", "total rank"}:
            totals[word, times[word, name]][name] = entry.number
            times[word, name] += 1
        elif entry.statistic == "rank" and entry.algorithm:
            again = again | {entry.problem} if entry.algorithm in ranks[entry.problem] else again
            ranks[entry.problem][entry.algorithm] = entry.number
    # what stands twice under one name cannot be told apart
    ranks = {problem: row for problem, row in ranks.items() if problem not in again}
    return _Printed(ranks=ranks, totals=[(word, row) for (word, _), row in totals.items()])


def _over_all(problem: str) -> str:
    """Return which line over all problems a label heads; nothing where it names one problem."""
    if _SUM.fullmatch(problem):
        return "total rank"
    return "average rank" if _MEAN.fullmatch(problem) else ""


def _values(entries: Sequence[Entry], ranks: Mapping[str, Row]) -> list[tuple[Row, ...]]:
    """Return, for each statistic that all ranked rows print, the row behind each row of ranks."""
    found: list[tuple[Row, ...]] = []
    count = len(next(iter(ranks.values())))
    if any(cell.printed.value > count for row in ranks.values() for cell in row.values()):
        return [()]  # ranks among more than are printed
    for statistic in _RANKED:
        rows: dict[str, dict[str, Cell]] = defaultdict(dict)
        for entry in entries:
            if entry.statistic == statistic:
                rows[entry.problem][entry.algorithm] = entry.number
        if all(rows[problem].keys() == row.keys() for problem, row in ranks.items()):
            found.append(tuple(rows[problem] for problem in ranks))
    return found or [()]


def _roles(totals: Sequence[tuple[str, Row]], names: set[str]) -> list[dict[str, Row]]:
    """Return every reading of the lines over all problems: as sums, as means, as places."""
    choices: list[list[tuple[str, Row]]] = []
    for word, row in totals:
        own = {name if name in names else statistics_in(name)[1]: row[name] for name in row}
        if set(own) == names:
            role = "sums" if word == "total rank" else "means"
            choices.append([(role, own), *([("places", own)] if _can_be_places(own) else [])])
    readings = [dict(reading) for reading in product(*choices)]
    return [reading for reading in readings if len(reading) == len(choices)] or [{}]


def _can_be_places(row: Row) -> bool:
    """Say whether a line ranks as many as it has; ties may share the mean or the last place."""
    values = [cell.printed.value for cell in row.values()]
    halves = all((2 * value).is_integer() for value in values)
    return halves and min(values) >= 1 and max(values) <= len(row)
