import csv
import io
import re

import pandas as pd
from hypothesis import example, given
from hypothesis import strategies as st
from jinja2 import Environment, Template

from repro.report.escapes import csv_value, markdown_text
from repro.report.formulas import powers_of_ten
from repro.report.frames import csv_text
from repro.report.words import markdown_cell
from tests.hostile import STRINGS, cells_of, pages

HOSTILE = st.text() | st.sampled_from(STRINGS)
FORMULAS = ("=1+1", "+cmd|' /C calc'!A0", "-2+3+cmd", "@SUM(A1)", "\t=1", "\r=1", "=HYPERLINK(1)")


@given(text=HOSTILE | st.sampled_from(FORMULAS))
@example(text="+")
@example(text="\0=1")
def test_no_text_is_a_formula_in_a_table(text: str) -> None:
    value = csv_value(text)

    assert isinstance(value, str)
    if value.startswith(("=", "+", "-", "@", "\t", "\r", "\n", "\0")):
        assert value in {"+", "-"} or float(value) is not None
    assert value.removeprefix("'") == text.replace("\r", "\n").removeprefix("'")


@given(number=st.floats() | st.integers())
def test_a_number_in_a_table_stays_one_as_text_too(number: float) -> None:
    assert csv_value(number) is number
    assert csv_value(str(number)) == str(number)


def test_formulas_are_quoted_wherever_a_table_is_written() -> None:
    frame = pd.DataFrame({"=1": FORMULAS, "b": -1.5, "c": "-1.5e-3"})

    heading, *found = csv.reader(io.StringIO(csv_text(frame), newline=""))

    assert heading == ["'=1", "b", "c"]
    assert found == [[f"'{text}".replace("\r", "\n"), "-1.5", "-1.5e-3"] for text in FORMULAS]


@given(text=HOSTILE)
@example(text="[x]: javascript:alert(1)")
@example(text="![x](http://a.b/c.png)")
def test_no_text_makes_a_tag_or_a_link_in_markdown(text: str) -> None:
    found = markdown_text(text)

    assert not re.search(r"<|\]\(|\]:", found)


@given(text=HOSTILE | st.text(st.sampled_from("a|\\\r\n]([:<")))
@example(text="a\\|b")
@example(text="a\rb")
def test_a_text_is_one_cell_of_a_markdown_table(text: str) -> None:
    found = markdown_cell(text)

    assert cells_of(f"| {found} |") == 1
    assert not re.search(r"[\r\n]|<|\]\(|\]:", found)
    for filtered in ("cell | raised", "raised"):
        line = template(filtered).render(text=text)
        assert not re.search(r"<(?!/?sup>)|\]\(|\]:", line)


def template(filters: str) -> Template:
    """Return what shows a text on a Markdown page."""
    environment = Environment(autoescape=False)  # noqa: S701 (as Markdown pages are made)
    environment.filters |= {"cell": markdown_cell, "raised": powers_of_ten}
    return environment.from_string(f"{{{{ text | {filters} }}}}")


def test_no_link_of_a_papers_text_stands_on_a_markdown_page() -> None:
    found = pages("[x](javascript:alert(1))")

    for name in ("index.md", "verdicts.md", "small2020.md"):
        assert not re.search(r"\]\(javascript:", found[name]), name
