"""What a table from anywhere prints beside the statistics of runs, as facts to be checked."""

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from repro.tables.audit_options import AuditOptions
from repro.tables.blocks import Block
from repro.tables.facts import Decision, Fact, RankedRows, Success, Ties, WinsAndLosses
from repro.tables.gathered import OF_RUNS, VALUE, Entry, Gathered
from repro.tables.headings import statistics_in
from repro.tables.numbers import NumberForm, number_form
from repro.tables.relations import Cell, RankTest
from repro.tables.true_numbers import exact

TALLY = ("wins", "ties", "losses")
_WHOLE_TABLE = 5  # lines
_TIES: Mapping[str, Ties] = {
    "average": "mean", "min": "least", "max": "greatest", "dense": "dense", "ordinal": "order",
}  # fmt: skip
_TESTS: Mapping[str, RankTest] = {"ranksum": "rank-sum", "signedrank": "signed-rank"}
_PROBLEMS = re.compile(
    r"\b([0-9]{1,3})\s+(?:\w+\s+){0,2}?(?:functions|problems|instances|data\s?sets)\b",
    re.IGNORECASE,
)
_THRESHOLD = re.compile(
    r"(?:threshold|accuracy|tolerance|target|below|less than|<|≤)\D{0,12}?"
    r"([0-9][0-9.]*(?:\s?[eE]\s?[-+−]?[0-9]+|\s?[×x·]\s?10\s?\^?\s?[-+−]?[0-9]+|\^[-−]?[0-9]+)?)",
    re.IGNORECASE,
)
Blocks = Mapping[tuple[str, str], Block]  # by problem and algorithm


def facts_of(
    table: Gathered, blocks: Blocks, options: AuditOptions, runs: int | None, *, maximised: bool
) -> tuple[Fact, ...]:
    """Return the tallies, rankings, tests and success rates that a table prints."""
    by_statistic: dict[str, list[Entry]] = defaultdict(list)
    for entry in table.entries:
        by_statistic[entry.statistic].append(entry)
    return (
        *_tallies(table, by_statistic),
        *_rankings(by_statistic, options, maximised=maximised),
        *_tests(by_statistic, options, runs),
        *_successes(table, by_statistic["success rate"], blocks, runs),
    )


def places_of(fact: Fact) -> Iterator[Cell]:
    """Yield the numbers that a fact is about."""
    if isinstance(fact, WinsAndLosses):
        yield from fact.cells
    elif isinstance(fact, Success):
        yield fact.rate
    elif isinstance(fact, Decision):
        yield from (cell for cell in (fact.p, fact.z, fact.r) if cell is not None)
    else:
        for cells in (*fact.ranks, fact.sums or {}, fact.means or {}):
            yield from cells.values()


def _tallies(table: Gathered, found: Mapping[str, Sequence[Entry]]) -> Iterator[WinsAndLosses]:
    """Yield each count of wins, ties and losses, with the number of problems that are counted."""
    parts: dict[tuple[int, int], dict[str, Cell]] = defaultdict(dict)
    for name in TALLY:
        for entry in found[name]:
            parts[entry.i, entry.j][name] = entry.number
    sums = [sum(int(cell.printed.value) for cell in cells.values()) for cells in parts.values()]
    for cells in parts.values():
        yield WinsAndLosses(
            wins=cells.get("wins"),
            ties=cells.get("ties"),
            losses=cells.get("losses"),
            problems=_problems(table, sums),
        )


def _problems(table: Gathered, sums: Sequence[int]) -> int | None:
    """Return the number of problems that a caption tells, or else that the table has lines of.

    A table of a few lines may be a part of one: then some tally must agree with them.
    """
    told = {int(count) for count in _PROBLEMS.findall(table.text)}
    if told:
        return told.pop() if len(told) == 1 else None
    named = {e.problem for e in table.entries if e.statistic in {*OF_RUNS, VALUE} and e.problem}
    return len(named) if len(named) >= _WHOLE_TABLE or len(named) in sums else None


def _rankings(
    found: Mapping[str, Sequence[Entry]], options: AuditOptions, *, maximised: bool
) -> Iterator[RankedRows]:
    """Yield the ranks row by row with their sums and means, one ranking per quantity."""
    ranks: dict[str, dict[str, dict[str, Cell]]] = defaultdict(lambda: defaultdict(dict))
    for entry in found["rank"]:
        if entry.algorithm:
            ranks[entry.quantity][entry.problem][entry.algorithm] = entry.number
    for quantity, by_problem in ranks.items():
        rows = [row for row in by_problem.values() if len(row) > 1]
        names = set(rows[0]) if rows else set()
        if not rows or any(set(row) != names for row in rows):
            continue
        yield RankedRows(
            ranks=tuple(rows),
            means=_of_all(found["average rank"], quantity, names),
            sums=_of_all(found["total rank"], quantity, names),
            ties=_TIES.get(options.ties or "", "any"),
            greatest_first=maximised,
        )


def _of_all(entries: Sequence[Entry], quantity: str, names: set[str]) -> Mapping[str, Cell] | None:
    """Return one number for each algorithm; None where one lacks it."""
    cells: dict[str, Cell] = {}
    for entry in entries:
        # in a line of sums alone, nothing tells that its columns are algorithms
        name = entry.algorithm or entry.problem
        if entry.quantity == quantity:
            cells[name if name in names else statistics_in(name)[1]] = entry.number
    return cells if names and names == set(cells) else None


def _tests(
    found: Mapping[str, Sequence[Entry]], options: AuditOptions, runs: int | None
) -> Iterator[Decision]:
    beside = {name: {(e.problem, e.algorithm): e for e in found[name]} for name in ("z", "h")}
    for entry in found["p-value"]:
        key = entry.problem, entry.algorithm
        z, h = beside["z"].get(key), beside["h"].get(key)
        said = h.number.printed.value if h else None
        yield Decision(
            p=entry.number,
            z=z.number if z else None,
            rejects=bool(said) if said in {0.0, 1.0} else None,
            alpha=Fraction(str(options.alpha)) if options.alpha else Fraction(1, 20),
            sides=options.sided,
            test=_TESTS.get(options.test or ""),
            n=runs,
        )


def _successes(
    table: Gathered, entries: Sequence[Entry], blocks: Blocks, runs: int | None
) -> Iterator[Success]:
    """Yield the success rates whose unit is sure: % is printed, or one is above 1."""
    printed = [entry.number.printed for entry in entries]
    percent = any(each.unit == "%" or "%" in each.text or each.value > 1 for each in printed)
    headed = any("%" in entry.number.column for entry in entries)
    if runs is None or not (percent or headed):
        return
    for entry in entries:
        yield Success(
            rate=entry.number,
            runs=runs,
            threshold=_threshold(f"{entry.number.row} {entry.number.column} {table.text}"),
            block=blocks.get((entry.problem, entry.algorithm)),
        )


def _threshold(text: str) -> Fraction | None:
    told = set()
    for match in _THRESHOLD.findall(text):
        form = number_form(match.strip().rstrip("."))
        if isinstance(form, NumberForm):
            told.add(exact(form.value))
    return told.pop() if len(told) == 1 else None
