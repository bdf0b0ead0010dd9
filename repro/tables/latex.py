"""Grids of LaTeX: every tabular, whatever package draws it."""

import re
from collections.abc import Iterator

from repro.tables.grids import Grid, grid

_COMMENT = re.compile(r"(?<!\\)%.*")
_KINDS = (
    r"(?:tabular[*xy]?|longtable|tabu|longtabu|tblr|longtblr|array|NiceTabular|xltabular"
    r"|supertabular)"
)
_BEGIN = re.compile(rf"\\begin\s*\{{({_KINDS})\}}")
_END = re.compile(rf"\\end\s*\{{{_KINDS}\}}")
_CAPTION = re.compile(r"\\caption(?:of\{\w+\})?\*?\s*(?:\[[^\]]*\])?\s*(?=\{)")
_RULES = re.compile(
    r"\\(?:hline|toprule|midrule|bottomrule|endhead|endfirsthead|endfoot|endlastfoot|noalign"
    r"|hhline\{[^{}]*\}|Xhline\{?[^\s{}\\]*\}?|specialrule(?:\{[^{}]*\}){3}|addlinespace(?:\[[^\]]*\])?"
    r"|(?:cline|cmidrule)(?:\([^)]*\))?\{[^{}]*\}|rowcolor(?:\[[^\]]*\])?\{[^{}]*\}|thickhline"
    r"|arrayrulecolor\{[^{}]*\}|morecmidrules|rowfont(?:\[[^\]]*\])?\{[^{}]*\})(?![a-zA-Z])"
    r"(?:\[[^\]]*\])?"
)
_SPAN = re.compile(r"\s*\\multicolumn\s*\{\s*(\d{1,3})\s*\}")
_ROWS = re.compile(r"\\multirow(?:cell|thead)?\*?")
_BREAK = re.compile(r"\\(?:\\|tabularnewline|cr)(?![a-zA-Z])\*?(?:\s*\[[^\]\n]*\])?")
_FIELD = re.compile(r"(?<!\\)&")
MOST_COLUMNS = 200


def latex_grids(text: str) -> list[Grid]:
    """Return the grid of every tabular; a tabular in a cell of another is part of its text."""
    text = "\n".join(_COMMENT.sub("", line) for line in text.splitlines())
    found, end = [], 0
    while begin := _BEGIN.search(text, end):
        closing = _closing(text, begin.end())
        body = text[_after_arguments(text, begin.end()) : closing]
        after = _END.match(text, closing)
        found.append(grid(_caption(text, end, begin.start(), closing), _lines(body)))
        end = after.end() if after else len(text)
    if not found and _FIELD.search(text) and _BREAK.search(text):  # lines without their tabular
        found.append(grid("", _lines(text)))
    return found


def _closing(text: str, start: int) -> int:
    """Return where the tabular that begins before `start` ends; half a file ends with the text."""
    depth = 1
    for mark in re.finditer(rf"{_BEGIN.pattern}|{_END.pattern}", text[start:]):
        depth += -1 if mark[0].startswith("\\end") else 1
        if depth == 0:
            return start + mark.start()
    return len(text)


def _after_arguments(text: str, start: int) -> int:
    """Return where the body begins: behind the width and the columns."""
    place = start
    while opened := re.compile(r"\s*([\[{])").match(text, place):
        if opened[1] == "[":
            place = text.find("]", opened.end()) + 1 or len(text)
        else:
            place = _group_end(text, opened.end() - 1)
    return place


def _group_end(text: str, start: int) -> int:
    """Return the place behind the group that opens at `start`."""
    depth = 0
    for place in range(start, len(text)):
        if text[place - 1 : place] != "\\":
            depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return len(text)


def _caption(text: str, before: int, begin: int, closing: int) -> str:
    """Return the caption above the tabular, or else the one below it, before another begins."""
    above = list(_CAPTION.finditer(text, before, begin))
    table = text.rfind("\\begin{table", before, begin)
    if above and above[-1].start() > table:
        place = above[-1].end()
        return text[place + 1 : _group_end(text, place) - 1]
    following = _BEGIN.search(text, closing)
    inside = _CAPTION.search(text, closing, following.start() if following else len(text))
    here = _CAPTION.search(text, begin, closing)
    match = here or inside
    return text[match.end() + 1 : _group_end(text, match.end()) - 1] if match else ""


def _lines(body: str) -> Iterator[list[str]]:
    for line in _split(_CAPTION_GROUP.sub("", body), _BREAK):
        texts = [_RULES.sub("", text) for text in _split(line, _FIELD)]
        fields: list[str] = []
        for text in texts:
            fields.extend(_spanned(text))
        if any(field.strip() for field in fields):
            yield fields[:MOST_COLUMNS]


_CAPTION_GROUP = re.compile(r"\\(?:caption|label)\*?(?:\[[^\]]*\])?\{[^{}]*\}")


def _split(text: str, mark: re.Pattern[str]) -> Iterator[str]:
    """Yield the parts of a text between marks that stand in no group."""
    depth, start, inner = 0, 0, 0
    for found in re.finditer(rf"(?P<mark>{mark.pattern})|(?<!\\)[{{}}]|\\(?:begin|end)\b", text):
        if found["mark"]:
            if depth <= 0 and inner <= 0:
                yield text[start : found.start()]
                start = found.end()
        elif found[0] in "{}":
            depth += 1 if found[0] == "{" else -1
        else:
            inner += 1 if found[0] == "\\begin" else -1
    yield text[start:]


def _spanned(text: str) -> Iterator[str]:
    """Yield a text and an empty one for every further column that it spans."""
    span = _SPAN.match(text)
    if span:
        columns = _after_groups(text, span.end(), 1)
        yield from _spanned(_argument(text, columns))
        yield from [""] * (min(int(span[1]), MOST_COLUMNS) - 1)
    elif rows := _ROWS.search(text):
        yield text[: rows.start()] + _argument(text, _after_groups(text, rows.end(), 2))
    else:
        yield text


def _after_groups(text: str, place: int, groups: int) -> int:
    """Return the place behind so many arguments in braces, and any in brackets between them."""
    for _ in range(groups):
        while opened := re.compile(r"\s*\[[^\]]*\]").match(text, place):
            place = opened.end()
        opening = text.find("{", place)
        star = re.compile(r"\s*[*=]").match(text, place)
        place = star.end() if star else _group_end(text, opening) if opening >= 0 else len(text)
    while opened := re.compile(r"\s*\[[^\]]*\]").match(text, place):
        place = opened.end()
    return place


def _argument(text: str, place: int) -> str:
    """Return what the next braces hold, with what follows them."""
    opening = text.find("{", place)
    if opening < 0:
        return text[place:]
    closing = _group_end(text, opening)
    return text[opening + 1 : closing - 1] + text[closing:]
