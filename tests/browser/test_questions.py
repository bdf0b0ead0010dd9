"""Seven questions of a reader who opens the index and knows nothing: clicks, screens, answers."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.browser.conftest import Open
from tests.browser.made_pages import make_asked_pages
from tests.made_once import made_once

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

CLICKS = 2
SCREENS = 2
WIDE, PHONE = 1280, 360
LIANG, SMWOA = "Shipbuilding Welding Manipulator", "Slime Mould Whale"


@dataclass
class Reader:
    """Who clicks what a page shows, and how often so far."""

    page: "Page"
    clicks: int = 0

    @property
    def wide(self) -> bool:
        """Whether the screen is no phone's."""
        return self._screen()["width"] > PHONE

    def follow(self, words: str, *, within: str = "body") -> None:
        """Click the first link with these words, which is no more than two screens away."""
        link = self.page.locator(within).get_by_role("link", name=re.compile(words)).first
        self.sees(link)
        link.click()
        self.page.wait_for_load_state()
        self.clicks += 1

    def sees(self, answer: "Locator") -> str:
        """Return the text of what is on the screen or, on a wide one, at most two screens down.

        None of it is beyond the right edge.
        """
        answer.wait_for(state="visible")
        box, screen = answer.bounding_box(), self._screen()
        assert box is not None
        assert box["x"] >= -1
        assert box["x"] + box["width"] <= screen["width"] + 1, answer.inner_text()
        if self.wide:
            assert -1 <= box["y"] <= SCREENS * screen["height"], (box["y"], answer.inner_text())
        return " ".join(answer.inner_text().split())

    def _screen(self) -> dict[str, int]:
        size = self.page.viewport_size
        assert size is not None
        return {"width": size["width"], "height": size["height"]}


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of pages that are asked, which no test changes."""
    return made_once(tmp_path_factory, "asked", make_asked_pages) / "reports"


@pytest.fixture(params=[WIDE, PHONE])
def reader(request: pytest.FixtureRequest, visit: Open) -> Iterator[Reader]:
    """Yield a reader of the index, who in the end has clicked no more than twice."""
    one = Reader(visit("index.html", width=request.param).page)
    yield one
    assert one.clicks <= CLICKS


def test_does_the_printed_time_hold_and_what_is_the_best(reader: Reader) -> None:
    reader.follow(LIANG)

    said = reader.sees(reader.page.locator(".concluded p").first)
    assert said == "4.69 s can be had, and 4.478 s is proved to be the least."
    assert "printed 4.69 s" in reader.page.locator("#times ~ figure desc").first.inner_html()


def test_which_numbers_are_impossible_and_why(reader: Reader) -> None:
    reader.follow(SMWOA)
    reader.follow("Which numbers cannot be")

    assert "cannot be, whatever was run" in reader.sees(reader.page.locator("#audit-proof"))
    reason = reader.page.locator("#audit-proof ~ h4").first
    assert "cannot spread so much" in reader.sees(reason)
    first = reader.page.locator(".places a").first
    assert reader.sees(first) == "F2 Std, SMWOA"
    first.click()  # the arithmetic of one of them, for who wants to check it
    assert "128 times the bound" in reader.sees(reader.page.locator("dt:target + dd"))


def test_is_it_better_than_its_rival_or_is_it_centre_bias(reader: Reader) -> None:
    reader.follow(LIANG)

    rival = reader.sees(reader.page.locator(".concluded p").nth(1))
    assert "IWOA" in rival
    assert "18.3 %" in rival
    bias = reader.sees(reader.page.locator("#questions li", has_text="Is it centre bias?"))
    assert "differential evolution ×" in bias
    assert re.search(r"[Ee]qual evaluations", bias)


def test_how_to_run_one_number_again(reader: Reader) -> None:
    reader.follow(LIANG)
    reader.follow("^IWOA, Total Time t: printed 4.69", within="#at-a-glance ~ .maps")

    command = reader.page.locator("code", has_text="table-vi-iwoa-total-time-t").first
    assert "again" in reader.sees(command)


def test_which_assumptions_would_change_the_verdict(reader: Reader) -> None:
    reader.follow(LIANG)
    reader.follow("Readings and assumptions", within="#contents")

    changed = reader.page.locator(".depending").first
    assert re.search(r"\d+ numbers? of Table \w+ would change", reader.sees(changed))
    changed.locator("summary").click()
    assert reader.sees(changed.locator("li").first)


def test_where_the_raw_runs_are(reader: Reader) -> None:
    reader.follow(LIANG)
    reader.follow("Run it again, and data", within="#contents")

    assert reader.sees(reader.page.get_by_role("link", name=re.compile("liang2026.csv.gz")).first)


def test_how_good_ordinary_optimisers_are_on_the_same(reader: Reader) -> None:
    reader.follow(LIANG)
    card = reader.page.locator("#questions li", has_text="How do ordinary optimisers do?")
    assert "evaluations each" in reader.sees(card)
    reader.follow("How do ordinary optimisers do")

    assert reader.sees(reader.page.locator("#baselines"))
    cmaes = reader.page.locator("#baselines ~ .wrap td", has_text="CMA-ES").first
    assert reader.sees(cmaes).startswith("CMA-ES")
