"""Tables as grids of texts, before anything is known of what they say."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

_OF_TITLES = re.compile(
    r"\b(?:tab(?:le|\.|elle|la)|results?|runs?|trials?|comparisons?|values?|dimensions?|functions?)\b",
    re.IGNORECASE,
)
MOST_CELLS = 500_000  # of one file
MOST_COLUMNS = 5_000


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """The texts of a table, line by line, all lines of one length.

    `title` is what stands above or below it. A text that spans several columns or lines stands in
    the first of them, the others are empty.
    """

    title: str
    lines: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()  # what was taken for granted while it was read


def grid(title: str, lines: Iterable[Sequence[str]], notes: tuple[str, ...] = ()) -> Grid:
    """Return the grid of lines that may differ in length."""
    texts = [[text.strip() for text in line] for line in lines]
    width = max(map(len, texts), default=0)
    padded = tuple((*line, *[""] * (width - len(line))) for line in texts)
    return Grid(title=" ".join(title.split()), lines=padded, notes=notes)


def parted(whole: Grid) -> list[Grid]:
    """Return the tables of a grid: parted by empty lines, each with the lone texts above it.

    A lone text between lines of numbers stays: it heads the lines below it.
    """
    found: list[Grid] = []
    titles = [whole.title] if whole.title else []
    lines: list[Sequence[str]] = []

    def close() -> None:
        if lines:
            kept = _without_empty_columns(lines)
            found.append(grid(" · ".join(titles), kept, whole.notes))

    for line in (*whole.lines, ()):
        filled = [text for text in line if text]
        if not filled:
            close()
            if lines:
                titles, lines = [whole.title] if whole.title else [], []
        elif not lines and _is_title(line, filled):
            titles.append(", ".join(filled))
        else:
            lines.append(line)
    return [each for each in found if len(each.lines) > 1 and len(each.lines[0]) > 1]


def _is_title(line: Sequence[str], filled: Sequence[str]) -> bool:
    """Say whether a line above all others is a title: one text, or one that commas have parted."""
    if len(filled) == 1:
        return not (line[0] == "" and len(line) == 2)
    is_short = len(filled) < len(line) and list(line[: len(filled)]) == list(filled)
    text = " ".join(filled)
    return is_short and len(text.split()) > len(filled) and _OF_TITLES.search(text) is not None


def _without_empty_columns(lines: Sequence[Sequence[str]]) -> list[list[str]]:
    used = [j for j in range(len(lines[0])) if any(line[j] for line in lines)]
    return [[line[j] for j in used] for line in lines]
