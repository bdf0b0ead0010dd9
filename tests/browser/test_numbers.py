"""The tables and claims of a page: filter, order, compact view and links."""

import re
from itertools import groupby

import pytest

from tests.browser.conftest import Open

PAGE = "doe2021.tables.html"
DOOR = "doe2021.html"
SHOWN = ".panel:visible"
CELL = "table-2-f1-mean-pso"


def test_the_filter_leaves_only_the_verdicts_that_are_ticked(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator("#tools summary").click()

    page.get_by_role("checkbox", name=re.compile(r"✖ contradicted \(\d+\)")).uncheck()

    left = page.locator("[data-verdict]:visible .printed:visible").count()
    assert left == page.locator('td.cell:not([data-verdict="contradicted"])').count() == 2
    said = page.locator("#shown-count").inner_text()
    assert said == "2 of 6 numbers shown: the filter hides 4, and 2 whole rows."


def test_the_filter_works_by_keyboard_and_show_all_takes_it_back(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator("#tools summary").click()
    box = page.get_by_role("checkbox", name=re.compile("≈ consistent"))
    box.focus()

    page.keyboard.press("Space")
    assert page.locator('[data-verdict="consistent"] .verdict:visible').count() == 0

    page.get_by_role("button", name="Show all").focus()
    page.keyboard.press("Enter")
    assert page.locator('[data-verdict="consistent"] .verdict:visible').count() == 2
    assert box.is_checked()


def test_only_what_no_runs_whatever_give_can_be_shown(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator("#tools summary").click()

    page.get_by_label("only with ⚑").check()

    assert page.locator("td.cell .printed:visible").count() == 2
    assert page.locator("td.cell a.mark:visible").all_inner_texts() == ["⚑ impossible"] * 2


def test_a_row_whose_every_number_is_filtered_away_goes_too(visit: Open) -> None:
    page = visit(DOOR).page

    page.locator("ul.counts a", has_text="contradicted").first.click()
    page.wait_for_url("**/doe2021.tables.html?only=contradicted#tables")

    assert page.locator("#table-2 + .wrap tbody tr:visible").count() == 2
    assert page.locator("#table-3 + .wrap tbody tr:visible").count() == 1


def test_a_link_to_a_number_that_is_filtered_away_shows_everything_again(visit: Open) -> None:
    page = visit(f"{PAGE}?only=consistent").page
    assert not page.locator(f"#{CELL} .printed").is_visible()

    page.evaluate(f"location.hash = '{CELL}'")

    page.locator(f"#{CELL} .panel").wait_for(state="visible")
    assert page.locator(f"#{CELL} .printed").is_visible()


def test_a_heading_sorts_up_then_down_then_as_printed(visit: Open) -> None:
    page = visit(PAGE).page
    column = page.locator("#table-2 + .wrap th", has_text="PSO")
    printed = page.locator("#table-2 + .wrap td:last-child .printed")

    orders = [printed.all_inner_texts()]
    for _ in range(3):
        column.get_by_role("button").click()
        orders.append([*printed.all_inner_texts(), str(column.get_attribute("aria-sort"))])

    best, mean = orders[0]
    assert orders[1] == [mean, best, "ascending"]
    assert orders[2] == [best, mean, "descending"]
    assert orders[3] == [best, mean, "None"]


def test_a_heading_sorts_by_keyboard(visit: Open) -> None:
    page = visit("smwoa2022.html").page
    claims = page.locator("#claims + .wrap")
    read = "rows => rows.map(row => row.dataset.verdict)"
    before = claims.locator("tbody tr").evaluate_all(read)
    claims.get_by_role("button", name="verdict").focus()

    page.keyboard.press("Enter")

    after = claims.locator("tbody tr").evaluate_all(read)
    assert before != after
    assert len([verdict for verdict, _ in groupby(after)]) == len(set(after)) > 1


def test_rows_can_be_put_in_the_order_of_contradictions(visit: Open) -> None:
    page = visit("liang2026.tables.html").page
    page.locator("#tools summary").click()

    page.get_by_label("Rows").select_option("contradicted")

    counts = page.locator("#table-ii + .wrap tbody tr").evaluate_all(
        "rows => rows.map(row => row.querySelectorAll('.cell.contradicted').length)"
    )
    assert counts == sorted(counts, reverse=True)
    assert len(set(counts)) > 1


def test_the_compact_view_shows_what_is_printed_with_marks_only(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator("#tools summary").click()
    before = page.locator("#table-2 + .wrap table").bounding_box()

    page.get_by_label("Compact, as on the page").check()

    cell = page.locator(f"#{CELL}")
    after = page.locator("#table-2 + .wrap table").bounding_box()
    assert cell.locator(".printed").is_visible()
    assert not cell.locator(".again").is_visible()
    assert cell.locator(".verdict").inner_text().startswith("✖")
    assert before is not None
    assert after is not None
    assert after["height"] < 0.6 * before["height"]


def test_the_compact_view_still_tells_a_screen_reader_the_verdict(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator("#tools summary").click()
    page.get_by_label("Compact, as on the page").check()

    tree = page.locator(f"#{CELL}").aria_snapshot()

    assert "contradicted" in tree
    assert "impossible" in tree


@pytest.mark.parametrize("page", ["hostile.html", "hostile.tables.html", "index.html"])
def test_hostile_names_claims_and_titles_stay_text(visit: Open, page: str) -> None:
    one = visit(page)
    if page == "index.html":
        one.page.get_by_role("searchbox").fill("onerror")
        one.page.locator("#search li").first.wait_for()
    else:
        one.page.locator("details.evidence summary").last.click()

    assert one.complaints == []
    assert len(one.requests) == 1
    assert one.page.locator("img").count() == 0
    assert one.page.title() not in {"1", "2"}
    assert '<img src=x onerror="document.title=1">' in one.page.locator("main").inner_text()


def test_arrow_keys_move_on_the_map_and_enter_opens_the_evidence(visit: Open) -> None:
    page = visit(DOOR).page
    squares = page.locator("table.heat").first.locator("a")
    first = squares.first

    start = first.get_attribute("href")
    first.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowDown")
    below = page.evaluate("document.activeElement.getAttribute('href')")
    page.keyboard.press("Enter")
    page.locator(".panel:visible").wait_for(state="visible")

    assert below not in (None, start)
    assert page.url.endswith(str(below))


def test_a_map_is_one_tab_stop(visit: Open) -> None:
    page = visit(DOOR).page

    for heat in page.locator("table.heat").all():
        stops = heat.locator("a").evaluate_all("all => all.filter(a => a.tabIndex === 0).length")
        assert stops == 1
