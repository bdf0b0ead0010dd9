"""The index: what it counts and what its search box finds."""

import re

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


def test_searching_leads_to_the_cell(visit: Open) -> None:
    page = visit("index.html").page
    box = page.get_by_role("searchbox", name="Find a paper, table, cell or claim")

    box.press_sequentially("liang2026 f1 mean iwoa table")
    page.locator("#search li a", has_text="Table II, F1 Mean, IWOA: 0").click()

    page.wait_for_url("**/liang2026.tables.html#table-ii-f1-mean-iwoa")
    page.locator("#table-ii-f1-mean-iwoa .panel").wait_for(state="visible")


def test_searching_finds_papers_claims_and_verdicts(visit: Open) -> None:
    page = visit("index.html").page
    box = page.get_by_role("searchbox")
    status, first = page.locator("#search [role=status]"), page.locator("#search li").first

    box.fill("slime mould")
    assert "smwoa2022" in first.inner_text()
    box.fill("doe2021 simulator")
    assert "∅ not reproducible" in first.inner_text()
    box.fill("contradicted")
    assert re.fullmatch(r"\d{2,} found, the first 40 shown", status.inner_text())
    box.fill("no such thing anywhere")
    assert status.inner_text() == "0 found"
    box.fill("")
    assert status.inner_text() == ""
    assert page.locator("#search li").count() == 0


def test_the_search_works_by_keyboard_alone(visit: Open) -> None:
    page = visit("index.html").page

    page.keyboard.press("Tab")  # the skip link
    page.keyboard.press("Tab")
    page.keyboard.type("doe2021 f1 best pso")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")

    page.wait_for_url(re.compile("doe2021.tables.html#table-2-f1-best-pso$"))


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
