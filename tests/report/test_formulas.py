import pkgutil
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.commands.written_pages import write_pages
from repro.errors import DeclarationError
from repro.model.paper import Formula, Paper
from repro.report.formulas import dollars, equation_links, mathml, powers
from repro.runs.plan import plan
from repro.runs.store.store import Store
from tests.doe2021 import PAPER
from tests.house import PAPERS as HOUSE

DRAWN = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mstyle", "mtable", "mtr", "mtd"),
    *("msup", "msub", "msubsup", "mover", "munder", "munderover", "mfrac", "msqrt", "mroot"),
}
HOSTILE = (
    r"\text{<script>alert(1)</script>}",
    r"\text{&#60;script&#62;alert(1)&#60;/script&#62;}",
    r"\text{</mtext></math><img src=x onerror=alert(1)>}",
    "<script>alert(1)</script>",
    "x<y & z",
    r"\text{]]><!--}",
)
MORE_THAN_A_DRAWING = (
    r"\href{javascript:alert(1)}{x}",
    r"\style{background:url(https://example.org)}{x}",
    r"\class{verdict}{x}",
    r'\color{" onmouseover="alert(1)}x',
)
SQUARE = Formula(
    label="Eq. (1)",
    where="p. 2",
    latex=r"x^2 < \text{<script>alert(1)</script>}",
    says="A <b>square</b>.",
    code="repro.functions",
    departs="not at all",
)
PAPERS = tuple(HOUSE.values())
FORMULAS = [(paper.key, formula) for paper in PAPERS for formula in paper.formulas]
each_formula = pytest.mark.parametrize(
    "formula", [f for _, f in FORMULAS], ids=[f"{key} {f.label}" for key, f in FORMULAS]
)


def parsed(latex: str) -> ET.Element:
    return ET.fromstring(mathml(latex))  # noqa: S314 (what is tested is that it can be parsed)


def pages_of(folder: Path, paper: Paper) -> dict[str, str]:
    with Store(folder / "store") as store:
        write_pages(store, [paper], plan([paper], 1), folder, [paper.key])
    return {path.name: path.read_text(encoding="utf-8") for path in folder.glob("doe2021.*")}


def test_a_fraction_becomes_a_fraction() -> None:
    (fraction,) = parsed(r"\frac{1}{x_i}").iter("mfrac")
    over, under = fraction
    assert "".join(over.itertext()) == "1"
    assert [part.text for part in under.iter() if part.text] == ["x", "i"]


def test_aligned_lines_become_rows_of_a_table() -> None:
    rows = list(parsed(r"\begin{aligned} a &= b \\ c &= d \end{aligned}").iter("mtr"))
    assert ["".join(row.itertext()) for row in rows] == ["a=b", "c=d"]


@pytest.mark.parametrize("latex", HOSTILE)
def test_hostile_text_stays_text(latex: str) -> None:
    tree = parsed(latex)
    assert {element.tag for element in tree.iter()} <= DRAWN
    assert "<script" not in mathml(latex)
    assert "<img" not in mathml(latex)


@pytest.mark.parametrize("latex", MORE_THAN_A_DRAWING)
def test_what_would_do_more_than_draw_is_refused(latex: str) -> None:
    with pytest.raises(DeclarationError, match="would set"):
        mathml(latex)


@pytest.mark.parametrize("latex", [r"\frac{1}", r"\left( x", r"x_1_2", r"\nonsense{x}"])
def test_what_is_no_latex_is_refused_by_name(latex: str) -> None:
    with pytest.raises(DeclarationError, match=re.escape(repr(latex))):
        mathml(latex)


@given(st.text(alphabet=st.sampled_from("<>&\"'/\\{}$abx ^_;#\n"), max_size=30))
def test_no_text_becomes_anything_but_mathml(text: str) -> None:
    try:
        tree = parsed(rf"\text{{{text}}} + {text}")
    except DeclarationError:
        return
    assert {element.tag for element in tree.iter()} <= DRAWN
    assert not [n for e in tree.iter() for n in e.attrib if n.startswith("on") or n == "href"]


@given(st.text(alphabet=st.sampled_from("<>[]()`*\\{}|abx ^_;#\n"), max_size=30))
def test_between_dollars_nothing_opens_a_tag_a_link_or_a_second_line(text: str) -> None:
    assert not re.search(r"[<>\[\]*`\n]", dollars(text).replace(r"\text{'}", ""))


def test_a_dollar_in_a_formula_is_refused() -> None:
    with pytest.raises(DeclarationError, match="dollar"):
        dollars("a$b")


def test_lines_are_broken_by_a_word_that_markdown_leaves_alone() -> None:
    assert dollars("a \\\\\n b \\{c\\}") == r"$a \cr b \lbrace c\rbrace$"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("1.5×10^-7", "<mn>1.5</mn><mo>×</mo><msup><mn>10</mn><mn>−7</mn></msup>"),
        ("10^3", "<msup><mn>10</mn><mn>3</mn></msup>"),
        (
            "-2×10^0",
            '-<math class="power"><mn>2</mn><mo>×</mo><msup><mn>10</mn><mn>0</mn></msup></math>',
        ),
    ],
)
def test_powers_of_ten_are_mathml(text: str, shown: str) -> None:
    assert shown in powers(text)


def test_text_around_a_power_is_escaped() -> None:
    assert powers("<b> 4").endswith("&lt;b&gt; 4")


def test_the_place_of_an_open_point_leads_to_its_equation() -> None:
    several = replace(SQUARE, label="Eqs. (3) to (5), (8) and (9)")
    formulas = (SQUARE, several)
    several_id = "equation-eqs-3-to-5-8-and-9"
    assert equation_links("Eq. (1)", formulas) == 'Eq. <a href="#equation-eq-1">(1)</a>'
    assert equation_links("Eqs. (4)-(8)", formulas).count(f'<a href="#{several_id}">') == 2
    assert equation_links("Eqs. (2), (6) and (10)", formulas) == "Eqs. (2), (6) and (10)"
    assert equation_links("step (1)", formulas) == "step (1)"
    assert equation_links("<b> Eq. (1)", formulas).startswith("&lt;b&gt; Eq. ")
    assert equation_links("<b>", formulas) == "&lt;b&gt;"


@each_formula
def test_every_formula_of_a_paper_can_be_drawn_and_nothing_is_lost(formula: Formula) -> None:
    text = "".join(parsed(formula.latex).itertext())
    assert "\\" not in text
    assert "&" not in text


@each_formula
def test_markdown_finds_no_escape_of_its_own_in_a_formula(formula: Formula) -> None:
    # a backslash before a mark is eaten by Markdown where it is not known that this is a formula
    assert not re.search(r"\\[^a-zA-Z]", dollars(formula.latex))


@each_formula
def test_the_code_that_a_formula_names_is_there(formula: Formula) -> None:
    assert pkgutil.resolve_name(formula.code) is not None


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_a_paper_has_some_formulas_under_labels_of_their_own(paper: Paper) -> None:
    labels = [formula.label for formula in paper.formulas]
    assert 3 <= len(set(labels)) == len(labels) <= 8


def test_pages_show_a_formula_with_its_place_its_code_and_its_meaning(tmp_path: Path) -> None:
    pages = pages_of(tmp_path, replace(PAPER, formulas=(SQUARE,)))
    html, markdown = pages["doe2021.equations.html"], pages["doe2021.md"]
    assert '<li id="equation-eq-1">' in html
    assert str(mathml(SQUARE.latex)) in html
    assert dollars(SQUARE.latex) in markdown
    for page in (html, markdown):
        assert "Equations that the re-run follows" in page
        assert "p. 2" in page
        assert "repro.functions" in page
        assert "not at all" in page
        assert "<b>square" not in page
        assert "<script>alert" not in page


def test_a_paper_without_formulas_has_no_such_section(tmp_path: Path) -> None:
    for page in pages_of(tmp_path, PAPER).values():
        assert "Equations that" not in page


def test_powers_of_ten_are_mathml_in_html_and_raised_in_markdown(tmp_path: Path) -> None:
    pages = pages_of(tmp_path, PAPER)
    html = [page for name, page in pages.items() if name.endswith(".html")]
    assert any("<msup><mn>10</mn><mn>9</mn></msup>" in page for page in html)
    assert not any("<sup>" in page for page in html)
    assert "10<sup>9</sup>" in pages["doe2021.md"]
    assert "<math" not in pages["doe2021.md"]
