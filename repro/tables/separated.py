"""Grids of CSV, TSV, Markdown and pasted text."""

import csv
import re
from collections import Counter
from collections.abc import Iterator, Sequence

from repro.tables.grids import Grid, grid
from repro.tables.markup import plain
from repro.tables.numbers import LONGEST_MARKED_UP, NumberForm, number_form, split_pair

_RULE = re.compile(r"[\s|:+=_─━═┼│—-]*")
_COMMA = re.compile(r"(?<![\d.,])(?:\d{1,3}(?:\.\d{3})+|\d+),\d+(?![\d.,])")
_GROUPED = re.compile(r"[1-9]\d{0,2}(?:,\d{3})+")
_POINT = re.compile(r"(?<![\d.,])\d*\.\d+(?![\d.,])")
_HEADING = re.compile(r"#{1,6}\s+|[*+-]\s+|\*\*|__|(?=tab(?:le|\.)\s)|:\s+", re.IGNORECASE)
_LONGEST_FIELD = 100_000
_SPACES = re.compile(r"\t+|\s{2,}")


def separated_grid(text: str, title: str = "") -> Grid:
    """Return the grid of CSV or TSV: the separator is the one that gives the most even lines."""
    lines = text.splitlines()
    rows = max((_rows(lines, mark) for mark in ",;\t|"), key=_evenness)
    return grid(title, rows)


def _rows(lines: Sequence[str], mark: str) -> list[list[str]]:
    csv.field_size_limit(_LONGEST_FIELD)
    try:
        return list(csv.reader(lines, delimiter=mark, skipinitialspace=True))
    except csv.Error:
        return []


def _evenness(rows: Sequence[Sequence[str]]) -> tuple[float, int]:
    """Return how many lines are of the usual length, if that is above 1, and that length."""
    lengths = Counter(len(row) for row in rows if any(row))
    longer = {length: times for length, times in lengths.items() if length > 1}
    if not longer:
        return 0.0, 0
    usual = max(longer, key=lambda length: (longer[length], length))
    return sum(longer.values()) / lengths.total() + longer[usual] / lengths.total(), usual


def with_points(whole: Grid) -> Grid:
    """Return the grid with decimal points, where its numbers have decimal commas."""
    texts = [text for line in whole.lines for text in line if len(text) <= LONGEST_MARKED_UP]
    commas = [text for text in texts if _COMMA.search(text) and _is_numeric(_pointed(text))]
    marks = [mark for text in commas for mark in _COMMA.findall(text)]
    if not marks or all(_GROUPED.fullmatch(mark) for mark in marks):
        return whole
    if any(_POINT.search(text) and "," not in text and _is_numeric(text) for text in texts):
        return whole
    known = set(commas)
    lines = [[_pointed(text) if text in known else text for text in line] for line in whole.lines]
    notes = (*whole.notes, f"decimal commas, as in {marks[0]}, are read as points")
    return Grid(title=whole.title, lines=tuple(map(tuple, lines)), notes=notes)


def _is_numeric(text: str) -> bool:
    return isinstance(number_form(text), NumberForm) or split_pair(text) is not None


def _pointed(text: str) -> str:
    """Return the text with points for decimal commas, without points that part groups."""
    return _COMMA.sub(lambda mark: mark[0].replace(".", "").replace(",", "."), text)


def piped_grids(text: str) -> list[Grid]:
    """Return the grids of Markdown: lines with pipes, titled by heading and line before them."""
    found: list[Grid] = []
    heading = title = ""
    lines: list[list[str]] = []
    for line in (*text.splitlines(), ""):
        if line.count("|") > (0 if lines else 1) or (line.count("|") == 1 and len(line) > 2):
            if not _RULE.fullmatch(line):
                lines.append(_fields(line))
            continue
        if lines:
            titles = dict.fromkeys(filter(None, (heading, title)))
            found.append(grid(" · ".join(titles), lines))
            heading = title = ""
            lines = []
        if line.strip():
            title = _HEADING.sub("", line.strip(), count=1).rstrip("*_ ")
            heading = title if line.startswith("#") else heading
    return found


def _fields(line: str) -> list[str]:
    inner = line.strip().removeprefix("|")
    inner = inner[:-1] if inner.endswith("|") and not inner.endswith("\\|") else inner
    return [field.replace("\\|", "|") for field in re.split(r"(?<!\\)\|", inner)]


def pasted_grid(text: str) -> Grid:
    """Return the grid of text whose columns stand apart by tabs or two spaces, or else by one."""
    lines = [line.strip("\n") for line in text.splitlines() if not _is_rule(line)]
    apart = [_apart(line) for line in lines]
    if _evenness(apart)[0] > 1:
        return grid("", _in_columns(lines, apart))
    return grid("", list(_by_single_spaces(lines)))


def _is_rule(line: str) -> bool:
    return bool(line.strip()) and _RULE.fullmatch(line) is not None


def _apart(line: str) -> list[str]:
    if "\t" in line:
        return line.split("\t")
    return _SPACES.split(line.strip()) if line.strip() else []


def _in_columns(lines: Sequence[str], apart: Sequence[list[str]]) -> Iterator[list[str]]:
    """Yield the fields of each line; an indented line that is short by some lacks the first."""
    usual = _evenness(apart)[1]
    for line, fields in zip(lines, apart, strict=True):
        short = usual - len(fields)
        indented = line[:1].isspace() and "\t" not in line
        yield (
            [""] * short + fields if 0 < short < usual and indented and len(fields) > 1 else fields
        )


def _by_single_spaces(lines: Sequence[str]) -> Iterator[list[str]]:
    """Yield words and numbers; where a line has more words than usual the first ones are one."""
    rows = [list(_tokens(line)) for line in lines]
    lengths = Counter(
        len(row) for row in rows if sum(isinstance(number_form(t), NumberForm) for t in row) > 1
    )
    usual = max(lengths, key=lambda length: (lengths[length], length), default=0)
    for row in rows:
        extra = len(row) - usual
        yield [" ".join(row[: extra + 1]), *row[extra + 1 :]] if 0 < extra < len(row) else row


def _tokens(line: str) -> Iterator[str]:
    """Yield what stands apart by spaces, but for a ± b, a (b) and a × 10^b, which are one."""
    joined = re.sub(r"\s*(±|\+/-|×|\\pm|\\times)\s*", r"\1", plain(line))
    joined = re.sub(r"(?<=\d) (?=\([-+.\d=≈]+\))", "", joined)
    yield from joined.split()
