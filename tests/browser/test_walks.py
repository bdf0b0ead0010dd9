"""Four questions that a reader who knows no code answers from the pages, by clicks."""

import re
import shlex

import pytest

from repro.__main__ import main
from tests.browser.conftest import Open
from tests.doe2021 import PAPER
from tests.small_papers import let_be_known

IMPOSSIBLE = "table-3-pso-mean"


def test_which_printed_numbers_of_this_paper_hold(visit: Open) -> None:
    page = visit("index.html").page

    page.get_by_role("link", name="Doe and Roe (2021)", exact=True).click()
    held = page.locator("#summary + dl dd").nth(1)
    assert "✔ reproduced: 1 of 9 results: 1 of 3 claims of the text" in held.inner_text()
    assert "≈ consistent: 3 of 9 results: 1 of 4 in Table 2, 1 of 2 in Table 3" in held.inner_text()
    page.get_by_role("link", name=re.compile("3 ≈ consistent")).click()

    numbers = page.locator("td.cell .printed:visible").all_inner_texts()
    assert numbers == ["1.000", "2.357"]
    assert "the filter hides 4" in page.locator("#shown-count").inner_text()


def test_why_this_cell_is_called_impossible(visit: Open) -> None:
    page = visit("doe2021.tables.html").page
    cell = page.locator(f"#{IMPOSSIBLE}")

    cell.get_by_role("link", name="audit: impossible").click()

    arithmetic = page.locator("dt:target + dd").inner_text()
    assert (
        page.locator("#audit-conditional").inner_text() == "1 row: cannot be if a condition holds"
    )
    assert "printed is 2.1 s" in arithmetic
    assert "the least time under the printed limits is 2.3562" in arithmetic
    holds = page.get_by_role("paragraph").filter(has_text="Holds if every joint is at rest at each")
    assert holds.is_visible()
    page.go_back()
    cell.locator("summary").click()
    cell.locator(".panel").wait_for(state="visible")
    assert arithmetic in cell.locator(".panel").inner_text()


def test_how_far_from_the_optimum_the_printed_time_is(visit: Open) -> None:
    page = visit("doe2021.tables.html").page

    page.get_by_role("link", name="Certified optimum").first.click()

    place = page.locator("#optimum")
    assert place.evaluate("heading => heading.getBoundingClientRect().top") < 200
    row = page.locator("tr", has_text="printed: Table 3, WOA")
    time, ratio = row.locator("td").all_inner_texts()[1:]
    assert float(time) == 2.357
    assert float(ratio) == pytest.approx(2.357 / 2.3562, abs=1e-4)
    assert "2.3562 s" in page.locator("main").inner_text()


def test_what_i_must_type_to_see_this_number_again(
    visit: Open, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    page = visit("doe2021.tables.html").page
    cell = page.locator("#table-2-f1-mean-woa")
    cell.locator("summary").click()
    typed = cell.locator(".panel code").inner_text()
    shown = cell.locator(".again").inner_text()

    nox, _, session, _, *arguments = shlex.split(typed)
    let_be_known(monkeypatch, PAPER)
    code = main([session, *arguments])

    assert (nox, session, code) == ("nox", "again", 0)
    assert f"re-run    {shown} " in capsys.readouterr().out
