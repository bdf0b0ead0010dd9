"""What must hold of every page that is printed."""

import io
import re
import unicodedata

import pytest

from tests.browser.conftest import PAPERS, Rooms, of_extra

SHEETS = 15  # of A4, a page
A4 = 1032  # px at 96 to the inch: the long side of A4 less the margins of the print style


@pytest.mark.parametrize("dark", PAPERS, indirect=True, ids="dark {}".format)
def test_a_page_prints_on_few_sheets_with_all_its_tables(dark: Rooms) -> None:
    for name, one in dark.items():
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


def test_nothing_is_cut_off_on_paper(dark: Rooms) -> None:
    for name, one in dark.items():
        screen = one.page.viewport_size
        one.page.set_viewport_size({"width": A4, "height": 900})
        one.page.emulate_media(media="print")
        width = one.page.evaluate("document.documentElement.scrollWidth")
        one.page.emulate_media(media="screen")  # for the tests that look at it after this one
        one.page.set_viewport_size(screen)

        assert width <= A4, name
