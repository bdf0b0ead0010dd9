"""Hostile strings, and what must hold of the table parser, the store and the pages under them."""

import json
import math
import re
import shutil
import sqlite3
import tempfile
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

from repro.commands.written_pages import write_pages
from repro.errors import DeclarationError
from repro.model.assumptions import Alternative, Assumption
from repro.model.cells import every_cell
from repro.model.claims import Sentence
from repro.model.open_points import Erratum, Gap
from repro.model.paper import Paper, Source
from repro.model.tolerances import Between, Percent
from repro.runs.plan import plan
from repro.runs.run import execute
from repro.runs.store.store import Store
from repro.tables.published import NOTHING, Printed, PublishedTable
from tests.damages import tried
from tests.made_up import text_of
from tests.small_papers import EXPERIMENT, PAPER, Bowl, Guessing
from tests.small_stores import INTACT, filled

STRINGS = (
    "<script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "</title><svg onload=alert(1)>",
    "{{ 7 * 7 }}{% raw %}",
    "javascript:alert(1)",
    "[x](javascript:alert(1))",
    "a\\|b`c`*d*_e_",
    "\x1b[2J\x07",
    "\u202egnp.exe",
    "%s%n{0}",
    "'; drop table run; --",
    "A" * 3000,
    "\ud7ff\ufffe\U0001f980",
    "&lt;&amp;&#60;",
    "$\\frac{$_^",
)


def check_table(text: str) -> None:
    """Read a page: a table whose every number is finite, or a DeclarationError."""
    try:
        table = PublishedTable.read(text)
    except DeclarationError as error:
        if not str(error):
            message = "an error without a message"
            raise AssertionError(message) from None
        return
    for row, column in table.places():
        printed = table[row, column]
        assert abs(printed.value) < float("inf")
        assert printed.rounding >= 0.0
    assert NOTHING not in [name for names in table.rows for name in names]


COLUMNS = (
    *("run.key", "run.paper", "run.algorithm", "run.problem", "run.repeat", "run.run", "run.cost"),
    *("run.x", "run.evaluations", "run.seconds", "run.reason", "run.env", "run.sha"),
    *("curve.y", "curve.packed", "env.json"),
)


@cache
def _stored() -> bytes:
    folder = Path(tempfile.mkdtemp())
    try:
        return (filled(folder) / "runs.sqlite").read_bytes()
    finally:
        shutil.rmtree(folder)


def check_store(column: str, value: str | bytes | float | None, number: int) -> None:
    """Put a value into a row of a store: it is named fit for a terminal, and changes no record."""
    table, name = column.split(".")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "runs.sqlite"
        path.write_bytes(_stored())
        with closing(sqlite3.connect(path)) as database:
            try:
                database.execute(
                    f"update {table} set {name} = ? where id = ?",  # noqa: S608
                    (value, number),
                )
            except sqlite3.IntegrityError:
                return
            database.commit()
        trial = tried(Path(folder))
    assert trial.records == INTACT
    # a row under another key is another run's, which nobody asked for
    assert trial.shown in (None, INTACT) or name == "key"
    assert all(line.isprintable() for line in trial.said)


DRAWN = {"svg", "math"}  # what stands in these follows from the numbers of the runs
NEVER_DRAWN = {"script", "foreignobject", "iframe", "object", "embed", "a", "img", "animate", "set"}


class Tags(HTMLParser):
    """The elements of a page with the names of their attributes, in order.

    Elements of drawings and of formulas are left out, unless they are such as none of ours has.
    """

    def __init__(self) -> None:
        """Start without any."""
        super().__init__()
        self.found: list[tuple[str, ...]] = []
        self._drawn = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element."""
        names = tuple(name for name, _ in attrs)
        odd = tag in NEVER_DRAWN or any(name.startswith("on") for name in names)
        if odd or (not self._drawn and tag != "math"):
            self.found.append((tag, *names))
        if not self._drawn and tag in DRAWN:
            self._drawn = tag

    def handle_endtag(self, tag: str) -> None:
        """Note the end of a drawing or of a formula."""
        if tag == self._drawn:
            self._drawn = ""


def hostile_paper(text: str) -> Paper:
    """Return a small paper that says a text wherever it says anything.

    One search leaves the box however its runs are seeded, so that every page says so of its name.
    """
    name = "".join(c for c in text if c.isprintable() and c not in "|/[]").strip()[:80]
    first, second, problem = f"a{name}a", f"b{name}b", f"p{name}p"
    table = PublishedTable.read(
        f"Table {name}x, p. 3\nproblem | statistic || {first} | {second}\n"
        f"{problem} | mean || 0.05 | 0.5"
    )
    experiment = replace(
        EXPERIMENT, where=f"w{text}", problems={problem: Bowl()}, proposed=first,
        algorithms={first: Guessing(), second: Guessing(width=4000.0)},
    )  # fmt: skip
    cells = every_cell(
        table,
        of=experiment,
        rows=("problem", "statistic"),
        columns="algorithm",
        within=Between(-math.inf, math.inf),  # every text draws other numbers, no other verdict
    )
    gap = Gap(what=f"g{text}", where=f"w{text}", because=f"b{text}")
    sentence = Sentence(
        claim=f"c{text}", where=f"w{text}", printed=Printed("1", "%"), measure=None,
        accepted=Percent(1), gap=gap,
    )  # fmt: skip
    return replace(
        PAPER,
        source=Source(
            authors=f"a{text}", title=f"t{text}", journal=f"j{text}", doi=f"10.1/{text}",
            note=f"n{text}",
        ),
        summary=f"s{text}", experiments=(experiment,), results=(table,),
        claims=(*cells, sentence), gaps=(gap,),
        assumptions=(
            Assumption(
                what=f"w{text}", chosen=f"c{text}",
                alternatives=(Alternative(says=f"a{text}", untried=f"u{text}"),),
                because=f"b{text}", where=f"w{text}",
            ),
        ),
        errata=(
            Erratum(where=f"w{text}", printed=f"p{text}", used=f"u{text}", because=f"b{text}"),
        ),
    )  # fmt: skip


def pages(text: str) -> dict[str, str]:
    """Return the pages of the paper that says a text."""
    paper = hostile_paper(text)
    tasks = plan([paper], 1)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with Store(folder / "store") as store:
            store.begin(
                {"date": f"d{text}", "processor": f"p{text}", "packages": {"x": f"v{text}"}}
            )
            store.add(map(execute, tasks))
            write_pages(store, [paper], tasks, folder / "reports", [paper.key])
        outside = {path.name for path in folder.iterdir()}
        assert outside == {"store", "reports"}
        return {
            str(path.relative_to(folder / "reports")): text_of(path)
            for path in (folder / "reports").rglob("*.*")
        }


@cache
def harmless_tags() -> dict[str, list[tuple[str, ...]]]:
    """Return the elements of the pages of a harmless text."""
    return {name: tags(page) for name, page in pages("x").items() if name.endswith(".html")}


def tags(page: str) -> list[tuple[str, ...]]:
    """Return the elements of a page."""
    parser = Tags()
    parser.feed(page)
    return parser.found


def cells_of(line: str) -> int:
    """Return how many cells a row of a Markdown table has: bars between them are not escaped."""
    return len(re.findall(r"(?<!\\)(?:\\\\)*\|", line)) - 1


def ragged(page: str) -> list[str]:
    """Return the tables of a Markdown page whose rows have not all as many cells."""
    tables: list[str] = re.findall(r"(?:^\|.*\n)+", page, re.MULTILINE)
    return [each for each in tables if len({*map(cells_of, each.splitlines())}) > 1]


def check_pages(text: str) -> None:
    """Write the pages of a paper that says a text: no element or attribute comes of it."""
    found = pages(text)
    for name, expected in harmless_tags().items():
        assert tags(found[name]) == expected, name
    for name in ("index.md", "small2020.md"):
        assert "<script" not in found[name].lower(), name
        assert "<img" not in found[name].lower(), name
        assert "](javascript:" not in found[name], name
        assert ragged(found[name]) == [], name
    title = json.loads(found["results.json"])["papers"][0]["title"]
    assert title == f"t{text}"


TARGETS: dict[str, Callable[[str], None]] = {
    "table": check_table,
    "store": lambda text: check_store(COLUMNS[len(text) % len(COLUMNS)], text, 2),
    "page": check_pages,
}
