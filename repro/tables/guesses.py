"""What is not told of a table: the number of runs, the sense, what the spread is."""

import re
from collections.abc import Container, Iterator, Sequence

from repro.tables.audit_options import SPREADS, AuditOptions, Guess
from repro.tables.gathered import VALUE, Entry, Gathered
from repro.tables.headings import heads_runs, runs_in, sizes_in
from repro.tables.named_cells import is_of_runs
from repro.tables.read_blocks import ReadBlock
from repro.tables.statistic_words import is_width

LEAST_RUNS = 2
_NAMED = 6  # problems of which a line says the sense
_ERROR = re.compile(r"(?<!standard )(?<!std )(?<!std\. )\berrors?\b", re.IGNORECASE)


def guessed_runs(
    table: Gathered, context: str, options: AuditOptions
) -> tuple[int | None, Guess | None]:
    """Return the number of runs with where it is from; None where nothing or too much tells it."""
    if options.runs is not None:
        return options.runs, Guess(says=f"n = {options.runs} as told", option="runs", told=True)
    for found, place in (
        (runs_in(table.text), "the caption"),
        (_counted(table), "a column"),
        (sizes_in(table.text), "the caption"),
        (runs_in(context), "the text of the file"),
    ):
        told = {n: words for n, words in found if n >= LEAST_RUNS}
        if len(told) == 1:
            n, words = next(iter(told.items()))
            return n, Guess(says=f'n = {n} from {place} ("{words}")', option="runs", value=str(n))
        if told:
            says = f"n is left open: {place} tells {', '.join(map(str, sorted(told)))}"
            return None, Guess(says=says, option="runs")
    return None, Guess(says="n is not told", option="runs")


def _counted(table: Gathered) -> Iterator[tuple[int, str]]:
    """Yield what a column, or a line, of numbers of runs says."""
    for entry in table.entries:
        heading, value = _heading_of_runs(entry), entry.number.printed.value
        if heading and value.is_integer():
            yield int(value), heading


def _heading_of_runs(entry: Entry) -> str:
    number = entry.number
    return next((name for name in (number.column, number.row) if heads_runs(name)), "")


def guess_lines(table: Gathered, options: AuditOptions, checked: Container[int]) -> Iterator[Guess]:
    """Yield what is taken for granted of what the numbers are; `checked` are ids of cells."""
    for note in table.notes:
        yield Guess(says=note)
    renamed = [f'"{word}" is {name}' for word, name in table.words.items()]
    if renamed:
        yield Guess(says=f"headings: {', '.join(renamed[:12])}{', …' * (len(renamed) > 12)}")
    if table.pairs[0]:
        first = "" if table.pairs[0] == "mean" else f"first is the {table.pairs[0]}, the "
        yield Guess(says=f"of two numbers in one cell the {first}second is the {table.pairs[1]}")
    unnamed = [entry for entry in table.entries if entry.statistic == VALUE]
    values = sum(id(e.number) not in checked and not _heading_of_runs(e) for e in unnamed)
    if values:
        yield Guess(says=f"no heading names a statistic for {values} numbers: they are not checked")
    if options.significant is not None:
        yield Guess(says=_rounded(table, options.significant), option="significant", told=True)


def spread_lines(table: Gathered, options: AuditOptions) -> Iterator[Guess]:
    """Yield what a spread is taken for, where there is one and nothing is told."""
    if any(entry.statistic == "std" for entry in table.entries) and options.spread is None:
        yield Guess(
            says="the spread is a standard deviation", option="spread", value="std", choices=SPREADS
        )


def errors_guess(table: Gathered, options: AuditOptions) -> Guess | None:
    """Return the guess that no value is below 0, where a caption or heading calls them errors."""
    if options.errors or options.maximise or options.minimum or options.functions:
        return None
    names = {entry.statistic for entry in table.entries if is_of_runs(entry.statistic)}
    values = {name for name in names if not is_width(name) and name != "sem"}
    if any(e.number.printed.value < 0 for e in table.entries if e.statistic in values):
        return None
    headings = " ".join(table.words)
    for text, place in ((table.text, "the caption"), (headings, "a heading")):
        if _ERROR.search(text):
            says = f"values ≥ 0 from 'error' in {place}"
            return Guess(says=says, option="errors", value="no", choices=("yes", "no"))
    return None


def _rounded(table: Gathered, digits: int) -> str:
    """Return what the digits that are told mean, and how many numbers have more of them."""
    printed = [entry.number.printed for entry in table.entries]
    longer = sum(len(each.mantissa.strip("+-0.").replace(".", "")) > digits for each in printed)
    beyond = f"; {longer} numbers have more digits" if longer else ""
    return f"whole numbers may be rounded to {digits} digits, as told{beyond}"


def sense_lines(found: Sequence[ReadBlock], options: AuditOptions) -> Iterator[Guess]:
    """Yield which end of the runs is taken for the best one, and of which problems."""
    if options.maximise is not None:
        sense = "maximisation" if options.maximise else "minimisation"
        yield Guess(says=f"{sense} as told", option="maximise", told=True)
        return
    greatest = [each.block for each in found if each.block.maximise]
    says = "minimisation"
    if greatest:
        says = "maximisation? wherever a best stands it is the greater value; --minimise says no"
    if 0 < len(greatest) < len(found):
        others = {each.block.problem_name for each in found if not each.block.maximise}
        names = dict.fromkeys(
            f"{block.algorithm} of {block.problem_name}"
            if block.problem_name in others
            else block.problem_name
            for block in greatest
        )
        of = f"{', '.join(list(names)[:_NAMED])}{', …' * (len(names) > _NAMED)}"
        says = f"maximisation of {of}? there the best is the greater value; minimisation elsewhere"
    elif any(each.other for each in found):
        says = "minimisation, though no best is surely the lower value"
    value = "yes" if len(greatest) == len(found) > 0 else "no"
    yield Guess(says=says, option="maximise", value=value, choices=("yes", "no"))
