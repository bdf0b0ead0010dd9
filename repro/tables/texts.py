"""The tables of a text, whatever form they are in."""

import re
from collections.abc import Callable
from typing import Literal

from repro.errors import InputError
from repro.tables.grids import MOST_CELLS, MOST_COLUMNS, Grid, parted
from repro.tables.latex import latex_grids
from repro.tables.pages import page_grids
from repro.tables.separated import pasted_grid, piped_grids, separated_grid, with_points

Form = Literal["separated", "markdown", "latex", "html", "pasted"]
_LATEX = re.compile(r"\\begin\s*\{(?:tabular|longtable|tabu|array|NiceTabular|tblr)|&[^\n]*\\\\")
_LATEX_BEGIN = re.compile(r"\\begin\s*\{(?:tabular|longtable)")
_HTML = re.compile(r"<(?:table|tr|td)\b", re.IGNORECASE)
_SEPARATORS = ",;\t"


def tables_in(text: str, form: Form | None = None) -> list[Grid]:
    """Return the tables of a text; without a form it is told by the marks in it.

    InputError where there are more cells than any printed table has.
    """
    if cells := _too_many(text):
        message = f"it holds {cells} cells or lines; at most {MOST_CELLS} are read"
        raise InputError(message)
    whole = [with_points(grid) for grid in _READERS[form or form_of(text)](text)]
    cells = sum(len(grid.lines) * len(grid.lines[0]) for grid in whole if grid.lines)
    if cells > MOST_CELLS:
        message = f"it holds {cells} cells; at most {MOST_CELLS} are read"
        raise InputError(message)
    widest = max((len(grid.lines[0]) for grid in whole if grid.lines), default=0)
    if widest > MOST_COLUMNS:
        message = f"a table in it has {widest} columns; at most {MOST_COLUMNS} are read"
        raise InputError(message)
    return [table for grid in whole for table in parted(grid)]


def _too_many(text: str) -> int:
    """Return how many cells or lines a text has, where they are too many to be parsed at all."""
    lowered = text.lower()
    cells = max(lowered.count("<td") + lowered.count("<th"), text.count("\n"))
    return cells if cells > MOST_CELLS else 0


def form_of(text: str) -> Form:
    """Return the form that a text is in, by its marks."""
    if _LATEX.search(text):
        return "latex"
    if _HTML.search(text):
        return "html"
    lines = [line for line in text.splitlines() if line.strip()]
    if sum(line.count("|") > 1 for line in lines) > 1:
        return "markdown"
    even = sum(any(mark in line for mark in _SEPARATORS) for line in lines)
    return (
        "separated"
        if 2 * even > len(lines) and not any("\t" in line for line in lines)
        else "pasted"
    )


def _marked_down(text: str) -> list[Grid]:
    """Return the tables of Markdown, those in HTML or LaTeX last."""
    found = piped_grids(text)
    if _HTML.search(text):
        found += page_grids(text)
    return found + (latex_grids(text) if _LATEX_BEGIN.search(text) else [])


_READERS: dict[Form, Callable[[str], list[Grid]]] = {
    "separated": lambda text: [separated_grid(text)],
    "markdown": _marked_down,
    "latex": latex_grids,
    "html": page_grids,
    "pasted": lambda text: [pasted_grid(text)],
}
