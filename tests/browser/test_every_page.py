"""What must hold of every page, whatever it shows."""

import io
import re
import unicodedata
from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from tests.browser.conftest import OWN, Open, of_extra

PICTURES = Path(__file__).parent / "pictures"
PAPERS = (*all_papers(), "doe2021")
HOW = "how-verdicts-are-made"
PAGES = ("index", HOW, *PAPERS)
SCHEMES = ("light", "dark")
# in the dark only colours can differ
AXE_RULES = {
    "light": ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice"],
    "dark": ["color-contrast", "link-in-text-block"],
}
PHONE = 360  # px
PHONE_TEXT = 8  # px, the smallest letters of a figure on a phone
A4 = 1032  # px at 96 to the inch: the long side of A4 less the margins of the print style

REPEATED = """() => {
  const names = [...document.querySelectorAll("[id]")].map(each => each.id);
  return names.filter((name, place) => names.indexOf(name) !== place);
}"""
DANGLING = """() => [...document.querySelectorAll('a[href*="#"]')]
  .filter(link => link.pathname === location.pathname && link.hash.length > 1)
  .filter(link => !document.getElementById(decodeURIComponent(link.hash.slice(1))))
  .map(link => link.hash)"""
WIDE = """() => [...document.querySelectorAll("body *")]
  .filter(each => each.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .filter(each => !each.closest(".wrap") && !each.closest("pre") && !each.closest("svg"))
  .map(each => each.outerHTML.slice(0, 80))"""
# WCAG 2: (lighter + 0.05) / (darker + 0.05) of the relative luminances
FAINT = """() => {
  const channels = colour => colour.match(/[\\d.]+/g).map(Number);
  const linear = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) =>
    0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
  const page = luminance(channels(getComputedStyle(document.body).backgroundColor));
  return [...document.querySelectorAll("svg text")].flatMap(text => {
    const ink = luminance(channels(getComputedStyle(text).fill));
    const contrast = (Math.max(ink, page) + 0.05) / (Math.min(ink, page) + 0.05);
    return contrast < 4.5 ? [`${text.textContent}: ${contrast.toFixed(2)}`] : [];
  });
}"""
LETTERS = """() => [...document.querySelectorAll("figure svg text")]
  .map(text => {
    const { a, b } = text.getScreenCTM();
    return Math.hypot(a, b) * parseFloat(getComputedStyle(text).fontSize);
  })"""


@pytest.mark.parametrize("page", PAGES)
def test_a_page_opens_without_complaint_and_asks_the_network_for_nothing(
    visit: Open, page: str
) -> None:
    one = visit(f"{page}.html")

    assert one.complaints == []
    assert [address for address in one.requests if not address.startswith(OWN)] == []
    assert len(one.requests) == 1


@pytest.mark.parametrize("page", PAGES)
def test_no_identifier_stands_twice_and_no_link_leads_nowhere(visit: Open, page: str) -> None:
    one = visit(f"{page}.html")

    assert one.page.evaluate(REPEATED) == []
    assert one.page.evaluate(DANGLING) == []


@pytest.mark.parametrize("page", PAGES)
def test_every_file_that_a_page_links_to_is_there(visit: Open, reports: Path, page: str) -> None:
    links = visit(f"{page}.html").page.eval_on_selector_all(
        "a[href]", "links => links.map(link => link.getAttribute('href'))"
    )

    names = {re.split(r"[?#]", link)[0] for link in links} - {""}
    assert [name for name in names if not (reports / name).is_file()] == []


@pytest.mark.parametrize(("scheme", "rules"), AXE_RULES.items())
@pytest.mark.parametrize("page", PAGES)
def test_axe_finds_nothing(visit: Open, page: str, scheme: str, rules: list[str]) -> None:
    one = visit(f"{page}.html", color_scheme=scheme)
    opened = one.page.locator("details.evidence summary")
    if opened.count():
        opened.first.click()
    axe = Path(of_extra("axe_playwright_python").__file__ or "").with_name("axe.min.js")
    one.page.evaluate(axe.read_text(encoding="utf-8"))

    found = one.page.evaluate(
        "rules => axe.run(document, {runOnly: rules, resultTypes: ['violations']})", rules
    )

    assert len(found["passes"]) >= 1
    assert [(rule["id"], rule["nodes"][0]["html"][:120]) for rule in found["violations"]] == []


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", [HOW, *PAPERS])
def test_letters_of_figures_stand_out_from_the_page(visit: Open, page: str, scheme: str) -> None:
    one = visit(f"{page}.html", color_scheme=scheme)

    assert one.page.locator("figure svg text").count() > 0 or not all_figures(page)
    assert one.page.evaluate(FAINT) == []


def all_figures(page: str) -> tuple[object, ...]:
    paper = all_papers().get(page)
    return paper.figures if paper else ()


@pytest.mark.parametrize("page", PAGES)
def test_on_a_phone_only_tables_in_their_frames_scroll_sideways(visit: Open, page: str) -> None:
    one = visit(f"{page}.html", width=PHONE)

    assert one.page.evaluate("document.documentElement.scrollWidth") <= PHONE
    assert one.page.evaluate(WIDE) == []


@pytest.mark.parametrize("page", [HOW, *PAPERS])
def test_letters_of_figures_are_legible_on_a_phone(visit: Open, page: str) -> None:
    assert min(visit(f"{page}.html", width=PHONE).page.evaluate(LETTERS)) >= PHONE_TEXT


@pytest.mark.parametrize("page", PAPERS)
def test_every_figure_says_in_words_what_it_shows_and_links_its_data(
    visit: Open, page: str
) -> None:
    figures = visit(f"{page}.html").page.locator("figure").all()

    for figure in figures:
        assert figure.locator("svg desc, canvas[aria-label], [role=img]").count()
        assert len(figure.locator("figcaption").inner_text()) > 60
        assert figure.locator('figcaption a[href$=".csv"]').count() == 1


@pytest.mark.parametrize("page", PAGES)
def test_without_script_a_page_says_all_that_it_says_with_it(visit: Open, page: str) -> None:
    text = "main => main.textContent.replace(/\\s+/g, ' ').trim()"
    scripted = visit(f"{page}.html").page
    plain = visit(f"{page}.html", java_script_enabled=False).page

    for place in ("h1", ".facts >> nth=-1", *(["table >> nth=0"] if page != HOW else [])):
        assert plain.locator(place).evaluate(text) == scripted.locator(place).evaluate(text)
    assert plain.locator("table").count() == scripted.locator("table").count()
    assert not plain.locator("#tools, #search").first.is_visible()


@pytest.mark.parametrize("page", PAPERS)
def test_without_script_evidence_unfolds_in_its_cell(visit: Open, page: str) -> None:
    plain = visit(f"{page}.html", java_script_enabled=False, width=PHONE).page
    evidence = plain.locator("details.evidence").first

    assert not evidence.locator(".panel").is_visible()
    evidence.locator("summary").click()

    assert evidence.locator(".panel").is_visible()
    assert plain.evaluate("document.documentElement.scrollWidth") <= PHONE


@pytest.mark.parametrize("page", PAPERS)
def test_a_page_prints_with_all_its_tables(visit: Open, page: str) -> None:
    one = visit(f"{page}.html", color_scheme="dark")
    labels = one.page.locator("h2, h3").all_inner_texts()
    printed = one.page.locator(".printed").all_inner_texts()

    sheets = of_extra("pypdf").PdfReader(io.BytesIO(one.page.pdf(prefer_css_page_size=True))).pages

    text = squeezed("".join(sheet.extract_text() for sheet in sheets))
    assert len(sheets) >= 3
    assert [label for label in labels if squeezed(label) not in text] == []
    assert [number for number in set(printed) if squeezed(number) not in text] == []


def squeezed(text: str) -> str:
    """Return text less its spaces, and with ligatures taken apart as a PDF's reader may not."""
    return re.sub(r"[\s↕]", "", unicodedata.normalize("NFKC", text))


@pytest.mark.parametrize("page", PAGES)
def test_nothing_is_cut_off_on_paper(visit: Open, page: str) -> None:
    one = visit(f"{page}.html", width=A4)
    one.page.emulate_media(media="print")

    assert one.page.evaluate("document.documentElement.scrollWidth") <= A4


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_light(reports: Path, page: str) -> None:
    most = 300_000 if page == "index" else 3_000_000

    assert (reports / f"{page}.html").stat().st_size < most


@pytest.mark.parametrize("width", [1280, PHONE])
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", PAGES)
def test_a_picture_of_each_page_is_kept(visit: Open, page: str, scheme: str, width: int) -> None:
    picture = PICTURES / f"{page}-{scheme}-{width}.png"

    visit(f"{page}.html", color_scheme=scheme, width=width).page.screenshot(
        path=picture, full_page=True
    )

    assert picture.stat().st_size > 20_000
