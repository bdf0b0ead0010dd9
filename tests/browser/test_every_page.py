"""What must hold of every page, whatever it shows.

A page and its rooms are opened once in each view, and every test of that view looks at them.
"""

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.browser import asked_of_pages as ask
from tests.browser.conftest import (
    DRAWN,
    OWN,
    PAGES,
    PAPERS,
    PHONE,
    Open,
    Rooms,
    names,
    of_extra,
)

if TYPE_CHECKING:
    from playwright.sync_api import Page

PICTURES = Path(__file__).parent / "pictures"
AXE_RULES = ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice"]
AXE_COLOURS = ["color-contrast", "link-in-text-block"]  # in the dark only colours can differ
PHONE_TEXT = 8  # px, the smallest letters of a figure on a phone
MOST_STOPS = 12  # of the Tab key
HEAVIEST = 600_000  # bytes of a page
CLICKED = ("https://doi.org/", "https://arxiv.org/")  # what a reader may follow

of_papers = pytest.mark.parametrize("light", PAPERS, indirect=True, ids="light {}".format)


def test_a_paper_has_a_door_and_rooms(reports: Path) -> None:
    assert len(names(reports, "liang2026")) == 10
    assert len(names(reports, "syji")) >= 9
    assert names(reports, "index") == ["index.html"]


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_light(reports: Path, page: str) -> None:
    for name in names(reports, page):
        assert (reports / name).stat().st_size < HEAVIEST, name


@pytest.mark.parametrize("page", DRAWN)
def test_a_paper_has_figures(reports: Path, page: str) -> None:
    assert any("<svg" in text_of(reports / name) for name in names(reports, page))


def test_a_page_opens_without_complaint_and_asks_the_network_for_nothing(light: Rooms) -> None:
    for name, one in light.items():
        assert one.complaints == [], name
        assert [address for address in one.requests if not address.startswith(OWN)] == []
        assert len(one.requests) == 1


def test_no_identifier_stands_twice_and_every_link_leads_somewhere(
    light: Rooms, reports: Path
) -> None:
    for name, one in light.items():
        assert one.page.evaluate(ask.REPEATED) == [], name
        assert one.page.evaluate(ask.DANGLING) == [], name
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


def test_axe_finds_nothing(light: Rooms) -> None:
    for name, one in light.items():
        assert violations(one.page, AXE_RULES) == [], name


def test_axe_finds_nothing_in_the_dark(dark: Rooms) -> None:
    for name, one in dark.items():
        assert violations(one.page, AXE_COLOURS) == [], name


def violations(page: "Page", rules: list[str]) -> list[tuple[str, str]]:
    """Return what axe finds in a page whose first panel is open, which is shut afterwards."""
    opened = page.locator("details.evidence summary")
    if opened.count():
        opened.first.click()
    page.evaluate(axe())
    page.evaluate(ask.PARSED_ONCE)
    found = page.evaluate(
        "rules => axe.run(document, {runOnly: rules, resultTypes: ['violations']})", rules
    )
    if opened.count():
        opened.first.click()
    assert len(found["passes"]) >= 1
    return [(rule["id"], rule["nodes"][0]["html"][:120]) for rule in found["violations"]]


@cache
def axe() -> str:
    whole = Path(of_extra("axe_playwright_python").__file__ or "")
    return whole.with_name("axe.min.js").read_text(encoding="utf-8")


def test_letters_and_marks_of_figures_stand_out_from_the_page(light: Rooms) -> None:
    for name, one in light.items():
        assert one.page.evaluate(ask.FAINT) == [], name
        assert one.page.evaluate(ask.FAINT_MARKS) == [], name


def test_letters_and_marks_of_figures_stand_out_in_the_dark(dark: Rooms) -> None:
    for name, one in dark.items():
        assert one.page.evaluate(ask.FAINT) == [], name
        assert one.page.evaluate(ask.FAINT_MARKS) == [], name


def test_on_a_phone_nothing_with_a_verdict_needs_a_search_sideways(phone: Rooms) -> None:
    for name, one in phone.items():
        assert one.page.evaluate("document.documentElement.scrollWidth") <= PHONE, name
        assert one.page.evaluate(ask.WIDE) == [], name
        assert one.page.evaluate(ask.BEYOND) == [], name


def test_on_a_phone_a_cell_stands_beside_its_name_and_a_claim_above_all_that_is_said_of_it(
    phone: Rooms,
) -> None:
    for name, one in phone.items():
        assert one.page.evaluate(ask.UNDER_NAMES) == [], name
        assert all(claim.is_visible() for claim in one.page.locator("td.claim").all()), name


def test_headings_of_what_has_a_unit_name_it(light: Rooms) -> None:
    for name, one in light.items():
        assert one.page.evaluate(ask.UNITLESS) == [], name


def test_letters_of_figures_are_legible_on_a_phone(phone: Rooms) -> None:
    for name, one in phone.items():
        assert min(one.page.evaluate(ask.LETTERS), default=PHONE_TEXT) >= PHONE_TEXT, name


@of_papers
def test_every_figure_says_in_words_what_it_shows_and_links_its_data(light: Rooms) -> None:
    for one in light.values():
        for figure in one.page.locator("figure").all():
            assert figure.locator("svg desc, canvas[aria-label], [role=img]").count()
            assert len(figure.locator("figcaption").inner_text()) > 60
            assert figure.locator('figcaption a[href$=".csv"]').count() == 1


def test_without_script_a_page_says_all_that_it_says_with_it(light: Rooms, visit: Open) -> None:
    text = "main => main.textContent.replace(/\\s+/g, ' ').trim()"
    for name, one in light.items():
        scripted = one.page
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


def test_few_tab_stops_lie_before_the_first_number_of_a_table(light: Rooms) -> None:
    for name, one in light.items():
        assert one.page.evaluate(ask.STOPS) <= MOST_STOPS, name


def test_a_picture_of_each_page_is_kept(light: Rooms) -> None:
    keep_pictures(light, "light-1280")


def test_a_picture_of_each_page_is_kept_in_the_dark(dark: Rooms) -> None:
    keep_pictures(dark, "dark-1280")


def test_a_picture_of_each_page_is_kept_on_a_phone_by_day_and_night(phone: Rooms) -> None:
    keep_pictures(phone, f"light-{PHONE}")
    for one in phone.values():
        one.page.emulate_media(color_scheme="dark")
    keep_pictures(phone, f"dark-{PHONE}")


def keep_pictures(rooms: Rooms, view: str) -> None:
    for name, one in rooms.items():
        picture = PICTURES / f"{name.removesuffix('.html')}-{view}.png"
        one.page.screenshot(path=picture)
        assert picture.stat().st_size > 5_000


@of_papers
def test_contents_stay_in_sight_and_say_where_one_is(light: Rooms) -> None:
    for name, one in light.items():
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
