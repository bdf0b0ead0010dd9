"""What a table from anywhere prints beside the statistics of runs, as facts to be checked."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from repro.tables.arithmetic import joined
from repro.tables.audit_options import AuditOptions
from repro.tables.facts import Decision, Fact, Success, WinsAndLosses
from repro.tables.gathered import VALUE, Entry, Gathered
from repro.tables.levels import Level
from repro.tables.named_cells import is_of_runs
from repro.tables.numbers import NumberForm, number_form
from repro.tables.read_blocks import ReadBlock
from repro.tables.read_ranks import rankings_of
from repro.tables.read_tests import decisions_of
from repro.tables.relations import Cell
from repro.tables.senses import LEAST_IS_BEST
from repro.tables.true_numbers import exact

TALLY = ("wins", "ties", "losses")
_WHOLE_TABLE = 5  # lines
# as many runs as a rate of 100 or 0 leaves no other outcome for, however it was rounded
_NO_OTHER = 100
_ERRORS = re.compile(r"\berrors?\b", re.IGNORECASE)
_PROBLEMS = re.compile(
    r"\b([0-9]{1,3})\s+(?:\w+\s+){0,2}?(?:functions|problems|instances|data\s?sets)\b",
    re.IGNORECASE,
)
_THRESHOLD = re.compile(
    r"(?:threshold|accuracy|tolerance|target|below|less than|<|≤)(?:\s?\([^()0-9]{0,40}\))?"
    r"\D{0,12}?"
    r"([0-9][0-9.]*(?:\s?[eE]\s?[-+−]?[0-9]+|\s?[×x·]\s?10\s?\^?\s?[-+−]?[0-9]+|\^[-−]?[0-9]+)?)",
    re.IGNORECASE,
)
Blocks = Mapping[tuple[str, str], ReadBlock]  # by problem and algorithm


def facts_of(
    table: Gathered,
    blocks: Blocks,
    options: AuditOptions,
    *,
    runs: int | None,
    level: Level,
) -> tuple[Fact, ...]:
    """Return the tallies, rankings, tests and success rates that a table prints."""
    by_statistic: dict[str, list[Entry]] = defaultdict(list)
    for entry in table.entries:
        by_statistic[entry.statistic].append(entry)
    return (
        *_tallies(table, by_statistic),
        *rankings_of(table, options),
        *decisions_of(by_statistic, options, level, runs),
        *_successes(table, by_statistic["success rate"], blocks, runs, errors=options.errors),
    )


def places_of(fact: Fact) -> Iterator[Cell]:
    """Yield the numbers that a fact is about."""
    if isinstance(fact, WinsAndLosses):
        yield from fact.cells
    elif isinstance(fact, Success):
        yield fact.rate
    elif isinstance(fact, Decision):
        yield from (cell for cell in (fact.p, fact.z, fact.r, fact.decided) if cell is not None)
    else:
        rows = (fact.sums, fact.means, fact.places)
        for cells in (*fact.values, *fact.ranks, *filter(None, rows)):
            yield from cells.values()


def _tallies(table: Gathered, found: Mapping[str, Sequence[Entry]]) -> Iterator[WinsAndLosses]:
    """Yield each count of wins, ties and losses, with the number of problems that are counted."""
    parts: dict[tuple[object, ...], dict[str, Cell]] = defaultdict(dict)
    in_one_cell = Counter((entry.i, entry.j) for name in TALLY for entry in found[name])
    for name in TALLY:
        for entry in found[name]:
            place = entry.i, entry.j
            key = place if in_one_cell[place] > 1 else (entry.problem, entry.algorithm)
            parts[key][name] = entry.number
    parts = {key: cells for key, cells in parts.items() if {"wins", "losses"} <= cells.keys()}
    sums = [sum(int(cell.printed.value) for cell in cells.values()) for cells in parts.values()]
    problems, is_told = _problems(table, sums)
    for cells in parts.values():
        yield WinsAndLosses(
            wins=cells.get("wins"),
            ties=cells.get("ties"),
            losses=cells.get("losses"),
            problems=problems,
            is_told=is_told,
        )


def _problems(table: Gathered, sums: Sequence[int]) -> tuple[int | None, bool]:
    """Return the number of problems that a caption tells, or else that the table has lines of.

    A table of a few lines may be a part of one: then some tally must agree with them, which tells
    their number as a caption does.
    """
    told = {int(count) for count in _PROBLEMS.findall(table.text)}
    if told:
        return (told.pop() if len(told) == 1 else None), True
    named = {
        e.problem
        for e in table.entries
        if (is_of_runs(e.statistic) or e.statistic == VALUE) and e.problem
    }
    agrees = len(named) in sums
    return (len(named) if len(named) >= _WHOLE_TABLE or agrees else None), agrees


def _successes(
    table: Gathered,
    entries: Sequence[Entry],
    blocks: Blocks,
    runs: int | None,
    *,
    errors: bool | None,
) -> Iterator[Success]:
    """Yield the success rates whose unit is sure: % is printed, or one is above 1.

    Without the number of runs these are the rates of 100 and 0, which say the same of any number.
    """
    printed = [entry.number.printed for entry in entries]
    percent = any(each.unit == "%" or "%" in each.text or each.value > 1 for each in printed)
    headed = any("%" in entry.number.column for entry in entries)
    if not (percent or headed):
        return
    for entry in entries:
        if runs is None and entry.number.printed.value not in {0, 100}:
            continue
        text = f"{entry.number.row} {entry.number.column} {table.text}"
        threshold = _threshold(text)
        needs = [f"the number of runs is at most {_NO_OTHER}"] if runs is None else []
        if not errors and not _ERRORS.search(text) and threshold is not None:
            needs.append("success is told by the values that are printed")
        own = blocks.get((entry.problem or entry.algorithm, entry.algorithm))
        if own and own.other and threshold is not None:
            needs.append(LEAST_IS_BEST)
        yield Success(
            rate=entry.number,
            runs=runs or _NO_OTHER,
            threshold=threshold,
            block=own.block if own else None,
            is_told=runs is not None,
            condition=joined(needs),
        )


def _threshold(text: str) -> Fraction | None:
    told = set()
    for match in _THRESHOLD.findall(text):
        form = number_form(match.strip().rstrip("."))
        if isinstance(form, NumberForm):
            told.add(exact(form.value))
    return told.pop() if len(told) == 1 else None
