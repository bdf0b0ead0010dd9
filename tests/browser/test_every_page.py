"""What must hold of every page, whatever it shows."""

import io
import re
import unicodedata
from functools import cache
from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from tests.browser.conftest import OWN, Open, of_extra

PICTURES = Path(__file__).parent / "pictures"
PAPERS = (*all_papers(), "doe2021")
HOW = "how-verdicts-are-made"
PAGES = ("index", HOW, *PAPERS)
"""Each stands for all pages whose names begin with it: of a paper the door and its rooms."""
SCHEMES = ("light", "dark")
# in the dark only colours can differ
AXE_RULES = {
    "light": ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice"],
    "dark": ["color-contrast", "link-in-text-block"],
}
PHONE = 360  # px
PHONE_TEXT = 8  # px, the smallest letters of a figure on a phone
SHEETS = 15  # of A4, a page
MOST_STOPS = 12  # of the Tab key
HEAVIEST = 600_000  # bytes of a page
CLICKED = ("https://doi.org/", "https://arxiv.org/")  # what a reader may follow
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

# verdicts and explanations are never beyond the edge, not even in a frame that scrolls
BEYOND = """() => [...document.querySelectorAll(".verdict, .prose td, .cell td, dd, .reasons p")]
  .filter(each => each.offsetParent && !each.closest("table.heat"))
  .filter(each => each.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map(each => each.outerHTML.slice(0, 80))"""
# tab stops before the first number of a table, past a skip link where that is nearer
STOPS = """() => {
  const seen = each => each.checkVisibility({ visibilityProperty: true });
  const first = [...document.querySelectorAll("main td")]
    .find(cell => seen(cell) && /\\d|=|\\+|−/.test(cell.textContent));
  if (!first) return 0;
  const kinds = "a[href], button, input, select, summary, canvas, [tabindex]";
  const stops = [...document.querySelectorAll(kinds)]
    .filter(each => each.tabIndex >= 0 && seen(each) && !first.contains(each));
  const follows = (each, other) =>
    each.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING;
  const between = from => stops
    .filter(each => follows(each, first) && (!from || follows(from, each))).length;
  const skips = [...document.querySelectorAll("a.skip")]
    .map((skip, k) => [k + 1, document.querySelector(skip.hash)])
    .filter(([, place]) => follows(place, first));
  return Math.min(between(null), ...skips.map(([k, place]) => k + between(place)));
}"""
# WCAG 2.2, 1.4.11: whatever a line or mark says stands out by 3 to 1; grids and bands say nothing
FAINT_MARKS = """() => {
  const channels = colour => colour.match(/[\\d.]+/g).map(Number);
  const linear = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  const luminance = rgb => rgb.map(part => linear(part / 255))
    .reduce((sum, part, k) => sum + part * [0.2126, 0.7152, 0.0722][k], 0);
  const page = channels(getComputedStyle(document.body).backgroundColor).slice(0, 3);
  const faint = new Set();
  for (const mark of document.querySelectorAll("figure svg path, figure svg use")) {
    const { stroke, strokeOpacity, opacity, strokeWidth } = getComputedStyle(mark);
    const clear = Number(strokeOpacity) * Number(opacity);
    if (stroke === "none" || parseFloat(strokeWidth) === 0 || clear < 0.5) continue;
    const ink = channels(stroke).slice(0, 3).map((part, k) => part * clear + page[k] * (1 - clear));
    const [a, b] = [luminance(ink), luminance(page)];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 3) faint.add(`${stroke} at ${clear}: ${contrast.toFixed(2)}`);
  }
  return [...faint];
}"""


def names(reports: Path, page: str) -> list[str]:
    """Return the names of a paper's pages, or of the one page."""
    return [f"{page}.html", *sorted(path.name for path in reports.glob(f"{page}.*.html"))]


def test_a_paper_has_a_door_and_rooms(reports: Path) -> None:
    assert len(names(reports, "liang2026")) == 10
    assert len(names(reports, "syji")) >= 9
    assert names(reports, "index") == ["index.html"]


@pytest.mark.parametrize("page", PAGES)
def test_a_page_opens_without_complaint_and_asks_the_network_for_nothing(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        one = visit(name)

        assert one.complaints == []
        assert [address for address in one.requests if not address.startswith(OWN)] == []
        assert len(one.requests) == 1


@pytest.mark.parametrize("page", PAGES)
def test_no_identifier_stands_twice_and_every_link_leads_somewhere(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        one = visit(name)

        assert one.page.evaluate(REPEATED) == [], name
        assert one.page.evaluate(DANGLING) == [], name
        links = one.page.eval_on_selector_all(
            "a[href]", "links => links.map(link => link.getAttribute('href'))"
        )
        near = {link for link in links if not link.startswith(CLICKED)}
        assert [link for link in near if not leads(reports, name, link)] == [], name


def leads(reports: Path, page: str, link: str) -> bool:
    """Whether the file of a link is there, and in a page the part that it names."""
    path, _, part = link.partition("#")
    place = reports / (path.partition("?")[0] or page)
    return place.is_file() and (not part or f'id="{part}"' in text_of(place))


@cache
def text_of(place: Path) -> str:
    return place.read_text(encoding="utf-8")


@pytest.mark.parametrize(("scheme", "rules"), AXE_RULES.items())
@pytest.mark.parametrize("page", PAGES)
def test_axe_finds_nothing(
    visit: Open, reports: Path, page: str, scheme: str, rules: list[str]
) -> None:
    axe = Path(of_extra("axe_playwright_python").__file__ or "").with_name("axe.min.js")
    for name in names(reports, page):
        one = visit(name, color_scheme=scheme)
        opened = one.page.locator("details.evidence summary")
        if opened.count():
            opened.first.click()
        one.page.evaluate(axe.read_text(encoding="utf-8"))

        found = one.page.evaluate(
            "rules => axe.run(document, {runOnly: rules, resultTypes: ['violations']})", rules
        )

        assert len(found["passes"]) >= 1
        wrong = [(rule["id"], rule["nodes"][0]["html"][:120]) for rule in found["violations"]]
        assert wrong == [], name


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", [HOW, *PAPERS])
def test_letters_and_marks_of_figures_stand_out_from_the_page(
    visit: Open, reports: Path, page: str, scheme: str
) -> None:
    drawn = [name for name in names(reports, page) if "<svg" in text_of(reports / name)]
    assert drawn
    for name in drawn:
        one = visit(name, color_scheme=scheme)

        assert one.page.evaluate(FAINT) == [], name
        assert one.page.evaluate(FAINT_MARKS) == [], name


@pytest.mark.parametrize("page", PAGES)
def test_on_a_phone_nothing_with_a_verdict_needs_a_search_sideways(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        one = visit(name, width=PHONE)

        assert one.page.evaluate("document.documentElement.scrollWidth") <= PHONE, name
        assert one.page.evaluate(WIDE) == [], name
        assert one.page.evaluate(BEYOND) == [], name


@pytest.mark.parametrize("page", [HOW, *PAPERS])
def test_letters_of_figures_are_legible_on_a_phone(visit: Open, reports: Path, page: str) -> None:
    for name in names(reports, page):
        if "<svg" in text_of(reports / name):
            letters = visit(name, width=PHONE).page.evaluate(LETTERS)
            assert min(letters, default=PHONE_TEXT) >= PHONE_TEXT, name


@pytest.mark.parametrize("page", PAPERS)
def test_every_figure_says_in_words_what_it_shows_and_links_its_data(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        for figure in visit(name).page.locator("figure").all():
            assert figure.locator("svg desc, canvas[aria-label], [role=img]").count()
            assert len(figure.locator("figcaption").inner_text()) > 60
            assert figure.locator('figcaption a[href$=".csv"]').count() == 1


@pytest.mark.parametrize("page", PAGES)
def test_without_script_a_page_says_all_that_it_says_with_it(
    visit: Open, reports: Path, page: str
) -> None:
    text = "main => main.textContent.replace(/\\s+/g, ' ').trim()"
    for name in names(reports, page):
        scripted = visit(name).page
        plain = visit(name, java_script_enabled=False).page

        assert plain.locator("h1").evaluate(text) == scripted.locator("h1").evaluate(text)
        assert plain.locator("table").count() >= scripted.locator("main table:not(.arm *)").count()
        assert not plain.locator("#tools, #search").first.is_visible()


@pytest.mark.parametrize("page", PAPERS)
def test_without_script_evidence_unfolds_in_its_cell(visit: Open, page: str) -> None:
    plain = visit(f"{page}.tables.html", java_script_enabled=False, width=PHONE).page
    if not plain.locator("details.evidence").count():
        plain = visit(f"{page}.html", java_script_enabled=False, width=PHONE).page
    evidence = plain.locator("details.evidence").first

    assert not evidence.locator(".panel").is_visible()
    evidence.locator("summary").click()

    assert evidence.locator(".panel").is_visible()
    assert plain.evaluate("document.documentElement.scrollWidth") <= PHONE


@pytest.mark.parametrize("page", PAPERS)
def test_a_page_prints_on_few_sheets_with_all_its_tables(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        one = visit(name, color_scheme="dark")
        labels = one.page.locator("main h2, main h3").all_inner_texts()
        printed = one.page.locator(".printed").all_inner_texts()

        pdf = io.BytesIO(one.page.pdf(prefer_css_page_size=True))
        sheets = of_extra("pypdf").PdfReader(pdf).pages

        text = squeezed("".join(sheet.extract_text() for sheet in sheets))
        assert len(sheets) <= SHEETS, name
        assert [label for label in labels if squeezed(label) not in text] == []
        assert [number for number in set(printed) if squeezed(number) not in text] == []


def squeezed(text: str) -> str:
    """Return text less its spaces, and with ligatures taken apart as a PDF's reader may not."""
    return re.sub(r"[\s↕]", "", unicodedata.normalize("NFKC", text))


@pytest.mark.parametrize("page", PAGES)
def test_nothing_is_cut_off_on_paper(visit: Open, reports: Path, page: str) -> None:
    for name in names(reports, page):
        one = visit(name, width=A4)
        one.page.emulate_media(media="print")

        assert one.page.evaluate("document.documentElement.scrollWidth") <= A4, name


@pytest.mark.parametrize("page", PAGES)
def test_few_tab_stops_lie_before_the_first_number_of_a_table(
    visit: Open, reports: Path, page: str
) -> None:
    for name in names(reports, page):
        assert visit(name).page.evaluate(STOPS) <= MOST_STOPS, name


@pytest.mark.parametrize("page", PAPERS)
def test_contents_stay_in_sight_and_say_where_one_is(visit: Open, reports: Path, page: str) -> None:
    for name in names(reports, page):
        one = visit(name)
        here = one.page.locator("#contents [aria-current=page]")
        assert here.count() == 1
        assert here.get_attribute("href") == name
        one.page.evaluate("scrollTo(0, document.body.scrollHeight)")
        for part in ("header.top a[rel]", "#contents a"):
            box = one.page.locator(part).first.bounding_box()
            assert box is not None
            assert 0 <= box["y"] < 900, (name, part)


def test_the_skip_link_leads_past_the_bar(visit: Open) -> None:
    page = visit("doe2021.tables.html").page

    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")

    assert page.evaluate("Boolean(document.activeElement.closest('main'))")


def test_headings_and_first_columns_of_a_wide_table_stay_in_sight(visit: Open) -> None:
    page = visit("liang2026.tables.html", width=900).page
    frame = page.locator("#table-ii + .wrap")

    frame.evaluate("frame => frame.scrollTo(200, 600)")

    outer = frame.bounding_box()
    heading = frame.locator("thead th").nth(1).bounding_box()
    assert outer is not None
    assert heading is not None
    assert abs(heading["y"] - outer["y"]) < 60
    for k in (1, 2):
        boxes = [row.bounding_box() for row in frame.locator(f"tbody tr > :nth-child({k})").all()]
        assert all(box is not None and 0 <= box["x"] - outer["x"] < 200 for box in boxes)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_light(reports: Path, page: str) -> None:
    for name in names(reports, page):
        assert (reports / name).stat().st_size < HEAVIEST, name


@pytest.mark.parametrize("width", [1280, PHONE])
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", PAGES)
def test_a_picture_of_each_page_is_kept(
    visit: Open, reports: Path, page: str, scheme: str, width: int
) -> None:
    for name in names(reports, page):
        picture = PICTURES / f"{name.removesuffix('.html')}-{scheme}-{width}.png"

        visit(name, color_scheme=scheme, width=width).page.screenshot(path=picture)

        assert picture.stat().st_size > 5_000
