"""The index: what it counts and what its search box finds."""

import re

import pytest

from repro.commands.catalogue import all_papers
from tests.browser.conftest import Open


def test_the_index_counts_every_paper_by_verdict(visit: Open) -> None:
    page = visit("index.html").page
    tables = page.locator("table.stacked")

    headings = [
        re.sub(r"[^a-z ]", "", text).strip()
        for text in tables.first.locator("thead th").all_inner_texts()
    ]
    assert headings == [
        "paper", "results", "reproduced", "consistent", "undecided", "depends", "contradicted",
        "not reproducible", "impossible", "repeats",
    ]  # fmt: skip
    for row in tables.locator("tbody tr").all():
        total, *parts = map(int, row.locator("td").all_inner_texts())
        assert sum(parts[:6]) == total
    assert tables.locator("tbody tr").count() >= len(all_papers())


def test_on_a_phone_every_count_of_the_index_stands_beside_its_name(visit: Open) -> None:
    page = visit("index.html", width=360).page
    row = page.locator("table.stacked tbody tr").first

    for cell in row.locator("td").all():
        box = cell.bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 360
    name = "cell => getComputedStyle(cell, '::before').content"
    assert [cell.evaluate(name) for cell in row.locator("td").all()][:2] == [
        '"results"',
        '"✔ reproduced"',
    ]


LABEL = "Find a number, an algorithm, a part of a page, a word"
FOCUSED = "element => element === document.activeElement"


def test_searching_leads_to_the_cell(visit: Open) -> None:
    page = visit("index.html").page
    box = page.get_by_role("searchbox", name=LABEL)

    box.press_sequentially("liang f1 mean iwoa table")
    page.get_by_role("link", name="Table II, F1 Mean, IWOA", exact=True).click()

    page.wait_for_url("**/liang2026.tables.html#table-ii-f1-mean-iwoa")
    page.locator("#table-ii-f1-mean-iwoa .panel").wait_for(state="visible")


@pytest.mark.parametrize(
    ("asked", "heading", "found", "address"),
    [
        ("4.69", "Numbers", "Table VI, IWOA, Total Time t", "liang2026.tables.html#table-vi-iwoa-"),
        ("4.478", "Proved optima", "certified optimum of motion/FANUC", "liang2026.optimum.html#"),
        ("optimum liang", "Parts of a paper's pages", "certified optimum", "liang2026.optimum."),
        ("centre bias liang", "Parts of a paper's pages", "centre bias", "liang2026.statistics."),
        ("raw runs liang", "Parts of a paper's pages", "provenance", "liang2026.data.html#"),
        ("data liang", "Parts of a paper's pages", "provenance", "liang2026.data.html#provenance"),
        ("modified d-h", "Readings", "modified D-H", "liang2026.readings.html#"),
        ("slime mould", "Papers", "Joints Trajectory Planning", "smwoa2022.html"),
        ("prediction interval", "Words", "prediction interval", "glossary.html#prediction-"),
        ("impossible mean doe", "Audit", "Table 2", "doe2021.audit.html#audit-"),
        ("simulator doe", "Claims of the text", "the simulator shows 3 s", "doe2021.html#claim-"),
    ],
)
def test_whatever_the_pages_hold_is_found_under_its_heading(
    visit: Open, asked: str, heading: str, found: str, address: str
) -> None:
    page = visit("index.html").page
    page.get_by_role("searchbox").fill(asked)

    part = page.locator("#search-results section", has=page.locator("h2", has_text=heading))
    link = part.locator("a", has_text=found).first

    assert str(link.get_attribute("href")).startswith(address)


def test_a_number_is_not_found_within_another(visit: Open) -> None:
    page = visit("index.html").page

    page.get_by_role("searchbox").fill("4.69")

    for row in page.locator("#search-results li").all_inner_texts():
        assert re.search(r"(?<![\d.])4\.69", row), row


def test_what_is_found_is_counted_and_all_of_a_kind_can_be_shown(visit: Open) -> None:
    page = visit("index.html").page
    page.get_by_role("searchbox").fill("contradicted")
    status = page.locator("#search [role=status]").inner_text()
    many = page.locator("section", has=page.locator("h2", has_text="Numbers"))

    assert re.fullmatch(r"\d{2,} found: .*\d+ numbers.*", status)
    assert many.locator("li").count() == 6

    more = many.get_by_role("button", name=re.compile("all "))
    count = int(more.inner_text().split()[1])
    more.click()
    assert many.locator("li").count() == count
    assert many.locator("a").nth(6).evaluate(FOCUSED)


def test_where_nothing_is_found_it_says_what_can_be(visit: Open) -> None:
    page = visit("index.html").page
    box, status = page.get_by_role("searchbox"), page.locator("#search [role=status]")

    box.fill("no such thing anywhere")
    assert status.inner_text().startswith("Nothing found. What can be found: numbers as printed")
    box.fill("")
    assert status.inner_text() == ""
    assert page.locator("#search li").count() == 0


def test_the_search_works_by_keyboard_alone(visit: Open) -> None:
    page = visit("index.html").page
    box = page.get_by_role("searchbox")
    box.focus()

    page.keyboard.type("doe f1 best pso 9.99")
    page.keyboard.press("ArrowDown")
    assert page.locator("#search-results a").first.evaluate(FOCUSED)
    page.keyboard.press("Escape")
    assert box.evaluate(FOCUSED)
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")

    page.wait_for_url(re.compile("doe2021.tables.html#table-2-f1-best-pso$"))


def test_a_search_can_be_linked_to(visit: Open) -> None:
    page = visit("index.html?q=CMA-ES").page

    assert page.get_by_role("searchbox").input_value() == "CMA-ES"
    assert re.match(r"\d+ found|Nothing found", page.locator("#search [role=status]").inner_text())


def test_the_counts_of_a_paper_lead_to_its_numbers_of_that_verdict(visit: Open) -> None:
    page = visit("index.html").page

    counts = page.locator("#doe2021 ~ ul.counts").first
    counts.get_by_role("link", name=re.compile("consistent")).click()
    page.wait_for_load_state()

    assert page.locator("[data-verdict] .verdict:visible").count() == 2
    assert page.locator('[data-verdict="consistent"] .verdict').first.is_visible()
    page.go_back()
    counts.get_by_role("link", name=re.compile("reproduced")).click()
    page.wait_for_url("**/doe2021.html#claims")  # no number of a table is, a claim of the text
