"""The panel of a number: what it says, how it opens and closes, and where it stands."""

from tests.browser.conftest import Open

PAGE = "doe2021.tables.html"
CELL = "table-2-f1-mean-pso"
SHOWN = ".panel:visible"
FOCUSED = "element => element === document.activeElement"


def test_a_click_opens_the_evidence_of_a_number_as_a_dialog(visit: Open) -> None:
    page = visit(PAGE).page
    cell = page.locator(f"#{CELL}")

    cell.locator("summary").click()
    panel = page.get_by_role("dialog", name="Table 2 · F1 Mean · PSO")
    panel.wait_for(state="visible")

    for said in (
        "✖ contradicted: the re-run is higher: ",
        ", printed 1.2×10",
        "accepted",
        "2 repeats; the first 689.8, +1.8 decades",
        "readings",
        "⚑ impossible",
        "no number of runs allows that",
        f"#{CELL}, CSV line 5 of doe2021-table-2.csv",
        f"nox -s again -- doe2021 {CELL} in a clone of this repository",
    ):
        assert said in panel.inner_text()


def test_the_line_plot_has_band_interval_printed_number_and_proved_least(visit: Open) -> None:
    page = visit("doe2021.html#claim-woa-needs-2-36-s-at-most").page
    plot = page.locator("#claim-woa-needs-2-36-s-at-most .line-plot")

    assert plot.locator("text").all_text_contents() == ["printed", "proved least"]
    band, own = (plot.locator(kind).bounding_box() for kind in (".band", ".own"))
    assert band is not None
    assert own is not None
    assert band["x"] <= own["x"]  # the interval lies within what is accepted
    assert own["x"] + own["width"] <= band["x"] + band["width"]


def test_neither_the_pointer_nor_the_tab_key_alone_opens_anything(visit: Open) -> None:
    page = visit(PAGE).page
    summary = page.locator(f"#{CELL} summary")

    summary.hover()
    summary.focus()
    page.wait_for_timeout(300)

    assert page.locator(SHOWN).count() == 0


def test_enter_opens_the_evidence_and_escape_gives_the_focus_back(visit: Open) -> None:
    page = visit(PAGE).page
    summary = page.locator(f"#{CELL} summary")
    summary.focus()

    page.keyboard.press("Enter")
    assert page.get_by_role("button", name="Close").evaluate(FOCUSED)
    page.keyboard.press("Tab")  # to the first link in the panel
    assert page.locator(f"#{CELL} .panel a").first.evaluate(FOCUSED)
    page.keyboard.press("Escape")

    assert page.locator(SHOWN).count() == 0
    assert summary.evaluate(FOCUSED)


def test_the_button_closes_the_panel_and_gives_the_focus_back(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator(f"#{CELL} summary").click()

    page.get_by_role("button", name="Close").click()

    assert page.locator(SHOWN).count() == 0
    assert page.locator(f"#{CELL} summary").evaluate(FOCUSED)


def test_a_click_elsewhere_closes_the_panel_and_gives_the_focus_back(visit: Open) -> None:
    page = visit(PAGE).page
    page.locator(f"#{CELL} summary").click()

    page.mouse.click(640, 895)  # below the tables

    assert page.locator(SHOWN).count() == 0
    assert page.locator(f"#{CELL} summary").evaluate(FOCUSED)


def test_a_click_on_another_number_opens_that_one_and_on_the_same_closes_it(visit: Open) -> None:
    page = visit(PAGE).page
    first, other = (page.locator(f"#table-3-{name}-mean") for name in ("woa", "pso"))

    first.locator("summary").click()
    other.locator("summary").click()
    assert page.locator(SHOWN).count() == 1
    assert other.locator(".panel").is_visible()

    other.locator("summary").click()
    assert page.locator(SHOWN).count() == 0


def test_leaving_the_panel_with_the_tab_key_closes_it_at_the_next_number(visit: Open) -> None:
    page = visit(PAGE).page
    cells = page.locator("td.cell")
    cells.first.locator("summary").press("Enter")
    links = cells.first.locator(".panel a").count()

    for _ in range(links + 1):
        page.keyboard.press("Tab")

    assert page.locator(SHOWN).count() == 0


def test_on_a_phone_the_panel_is_a_sheet_at_the_bottom_that_leaves_its_number_to_be_seen(
    visit: Open,
) -> None:
    page = visit(PAGE, width=360).page
    cell = page.locator("td.cell").first
    cell.evaluate("cell => cell.scrollIntoView({ block: 'start' })")

    cell.locator("summary").click()
    box, own = cell.locator(".panel").bounding_box(), cell.locator("summary").bounding_box()

    assert box is not None
    assert own is not None
    assert box["x"] == 0
    assert box["width"] == 360
    assert round(box["y"] + box["height"]) == 900
    assert own["y"] + own["height"] <= box["y"]


def test_the_panel_stays_inside_the_window(visit: Open) -> None:
    for width in (360, 1280):
        page = visit("liang2026.tables.html", width=width).page
        page.locator("td.cell summary").last.click()
        box = page.locator("td.cell .panel").last.bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        assert box["y"] >= 0
        assert box["y"] + box["height"] <= 900


def test_a_claim_has_its_evidence_and_its_link_as_a_cell_has(visit: Open) -> None:
    page = visit("doe2021.html#claim-woa-is-best-on-f1").page
    claim = page.locator("#claim-woa-is-best-on-f1")

    assert claim.locator(".panel").is_visible()
    assert "nox -s again -- doe2021 claim-woa-is-best-on-f1" in claim.locator(".panel").inner_text()
    assert claim.evaluate("row => getComputedStyle(row).outlineStyle") == "solid"


def test_a_link_to_a_cell_shows_it_marked_and_with_its_evidence(visit: Open) -> None:
    page = visit(f"{PAGE}#{CELL}").page
    cell = page.locator(f"#{CELL}")

    assert cell.locator(".panel").is_visible()
    assert cell.evaluate("cell => getComputedStyle(cell).outlineStyle") == "solid"
    assert cell.evaluate("cell => Math.abs(cell.getBoundingClientRect().top)") < 900
