"""Grids of HTML: every table of a page. Nothing that the page names is fetched."""

from html.parser import HTMLParser

from repro.tables.grids import Grid, grid

_MOST_SPANNED = 200


def page_grids(text: str) -> list[Grid]:
    """Return the grid of every table; one inside a cell of another comes before that one."""
    reader = _TableReader()
    reader.feed(text)
    reader.close()
    return reader.finished()


class _OpenTable:
    """A table that is being read: its lines, the cell that is open, and cells that reach down."""

    def __init__(self, title: str) -> None:
        self.title = title
        self.lines: list[list[str]] = []
        self.reaching: dict[int, int] = {}  # column: how many further lines are taken
        self.cell: list[str] | None = None
        self.span = (1, 1)

    def start_line(self) -> None:
        self.end_cell()
        self.lines.append([])

    def start_cell(self, columns: int, rows: int) -> None:
        self.end_cell()
        if not self.lines:
            self.lines.append([])
        self._fill()
        self.cell, self.span = [], (columns, rows)

    def _fill(self) -> None:
        line = self.lines[-1]
        while self.reaching.get(len(line), 0) > 0:
            self.reaching[len(line)] -= 1
            line.append("")

    def end_cell(self) -> None:
        if self.cell is None:
            return
        line, (columns, rows) = self.lines[-1], self.span
        text = "".join(self.cell)
        for k in range(columns):
            if rows > 1:
                self.reaching[len(line)] = rows - 1
            line.append("" if k else text)
        self.cell = None


class _TableReader(HTMLParser):
    """Gathers the tables of a page; the text of scripts and styles is no text of a cell."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self._open: list[_OpenTable] = []
        self._done: list[_OpenTable] = []
        self._heading: list[str] | None = None
        self._title = ""
        self._hidden = 0

    def finished(self) -> list[Grid]:
        """Return the grids, of tables that the page does not close too."""
        while self._open:
            self.handle_endtag("table")
        return [grid(table.title, table.lines) for table in self._done]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in {"script", "style"}:
            self._hidden += 1
        elif tag == "table":
            self._open.append(_OpenTable(self._title))
            self._title = ""
        elif tag in {"caption", "h1", "h2", "h3", "h4", "h5", "h6", "p"}:
            self._heading = []
        elif self._open:
            self._start_inside(tag, dict(attrs))

    def _start_inside(self, tag: str, named: dict[str, str | None]) -> None:
        table = self._open[-1]
        if tag == "tr":
            table.start_line()
        elif tag in {"td", "th"}:
            table.start_cell(_count(named.get("colspan")), _count(named.get("rowspan")))
        elif table.cell is not None and tag == "sup":
            table.cell.append("^")
        elif table.cell is not None and tag == "br":
            table.cell.append(" ")

    def handle_endtag(self, tag: str) -> None:
        if tag in {"script", "style"}:
            self._hidden = max(0, self._hidden - 1)
        elif tag == "table" and self._open:
            self._open[-1].end_cell()
            self._done.append(self._open.pop())
        elif tag in {"td", "th", "tr"} and self._open:
            self._open[-1].end_cell()
        elif self._heading is not None and tag in {"caption", "p", "h1", "h2", "h3", "h4", "h5"}:
            words = " ".join("".join(self._heading).split())[:300]
            self._heading = None
            if tag == "caption" and self._open:
                self._open[-1].title = words
            elif not self._open:
                self._title = words

    def handle_data(self, data: str) -> None:
        if self._hidden:
            return
        if self._open and self._open[-1].cell is not None:
            self._open[-1].cell.append(data)
        elif self._heading is not None:
            self._heading.append(data)


def _count(text: str | None) -> int:
    """Return how many lines or columns a cell spans; 1 for what is no number."""
    return (
        min(max(int(text), 1), _MOST_SPANNED) if text and text.isascii() and text.isdigit() else 1
    )
