"""The numbers of a table by problem, algorithm and statistic."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from repro.errors import DeclarationError
from repro.tables.decision_words import MEANS, NOT_TOLD, deciding, is_decision, rejection
from repro.tables.grids import Grid
from repro.tables.headings import statistics_in
from repro.tables.layout import GridCell, Layout, layout
from repro.tables.markup import plain
from repro.tables.named_cells import NamedCell, is_of_runs, named_cells
from repro.tables.numbers import NoNumber, number_form, split_pair
from repro.tables.published import Printed
from repro.tables.relations import PlacedNumber
from repro.tables.statistic_words import RANGE

_WIDTHS = {"std", "sem", "variance", RANGE}
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


def gathered(grid: Grid, label: str) -> Gathered:
    """Return the numbers of a grid with what they are of, and every text that is none."""
    return gathered_cells(layout(grid), label, title=grid.title, notes=grid.notes)


def gathered_cells(
    found: Layout, label: str, *, title: str, notes: tuple[str, ...] = ()
) -> Gathered:
    """Return the same of cells whose headings are known."""
    words: dict[str, str] = {}
    named = named_cells(found.cells, words)
    pairs = _pair_of(named, title)
    entries: list[Entry] = []
    skipped: list[Skipped] = []
    for each in named:
        for read in _read(each, label, pairs, words):
            (entries if isinstance(read, Entry) else skipped).append(read)  # type: ignore[arg-type]
    has_pairs = any(split_pair(each.cell.text) for each in named)
    return Gathered(
        label=label,
        entries=tuple(entries),
        skipped=tuple(skipped),
        words=words,
        pairs=pairs if has_pairs else ("", ""),
        notes=notes,
        text=" ".join(plain(text) for text in (title, *found.corner, *found.footers)),
    )


def _pair_of(named: Sequence[NamedCell], title: str) -> tuple[str, str]:
    """Return what the two numbers of a cell are where its headings do not say it.

    The second is a rank where all are small whole numbers.
    """
    pairs = [pair for each in named if (pair := split_pair(each.cell.text))]
    told = Counter(
        each.statistics[1]
        for each in named
        if len(each.statistics) > 1 and split_pair(each.cell.text)
    )
    if told:
        return "mean", told.most_common(1)[0][0]
    ranks = [
        text
        for _, text, sign in pairs
        if sign != "±" and text.isdigit() and int(text) <= _MOST_RANKS
    ]
    if pairs and len(ranks) == len(pairs):
        return "mean", "rank"
    names = set(statistics_in(title)[0])
    middles, widths = names & {"mean", "median"}, names & _WIDTHS
    return (
        middles.pop() if len(middles) == 1 else "mean",
        widths.pop() if len(widths) == 1 else "std",
    )


def _read(
    each: NamedCell, label: str, pairs: tuple[str, str], words: dict[str, str]
) -> Iterator[Entry | Skipped]:
    """Yield the numbers of a cell, or why there is none."""
    cell = each.cell
    first = each.statistics[0] if each.statistics else ""
    then = each.statistics[1] if len(each.statistics) > 1 else pairs[1]
    text, heading = plain(cell.text), f"{cell.row_name} {cell.column_name}"
    inner = text[1:-1] if text[:1] + text[-1:] == "()" else ""
    if pair := _pair(each):
        yield _entry(each, label, pair[0], first or pairs[0])
        yield _entry(each, label, pair[1], then)
    elif is_decision(cell.text, heading):
        rejects = rejection(cell.text, heading)
        if rejects is None:
            yield _skipped(cell, NOT_TOLD, label)
        else:
            words.setdefault(deciding(cell.row_name, cell.column_name), MEANS)
            yield _entry(each, label, str(int(rejects)), "h")
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


def _tally_order(each: NamedCell) -> tuple[str, str, str]:
    """Return which count stands where, by the heading: ties last, or between."""
    names = [label.text for label in (*each.cell.row, *each.cell.column)]
    last = any(re.search(r"/\s*(?:[=≈~]|[td]\w*)\s*\)?$", name, re.IGNORECASE) for name in names)
    return ("wins", "losses", "ties") if last else ("wins", "ties", "losses")


def _pair(each: NamedCell) -> tuple[str, str] | None:
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


def _entry(each: NamedCell, label: str, text: str, statistic: str) -> Entry:
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
        if is_of_runs(entry.statistic):
            place = (entry.problem, entry.algorithm, entry.quantity, entry.statistic)
            yield (*place[:3], times[place]), entry
            times[place] += 1
