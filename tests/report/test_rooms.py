import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from repro.errors import InputError
from repro.report.rooms import ROOMS, address, check_apart, check_names, page_of, pages_of_paper
from tests.doe2021 import PAPER
from tests.made_up import pages_of


@pytest.mark.parametrize(
    ("keys", "page"),
    [
        (("doe2021", "doe2021.tables"), "doe2021.tables.html"),
        (("doe2021.data", "doe2021"), "doe2021.data.html"),
        (("doe2021", "DOE2021"), "DOE2021.html"),
        (("index",), "index.html"),
        (("Glossary",), "Glossary.html"),
        (("how-verdicts-are-made",), "how-verdicts-are-made.html"),
        (("verdicts",), "verdicts.html"),
    ],
)
def test_two_pages_that_would_be_one_file_are_refused(keys: tuple[str, ...], page: str) -> None:
    with pytest.raises(InputError, match=f"written to {page}: give it another key"):
        check_names(keys)


def test_keys_with_dots_that_are_no_rooms_stand_side_by_side() -> None:
    check_names(("doe2021", "doe2021.b", "doe2021.tables.b", "doe2021.b"))


def test_tables_of_two_papers_that_would_be_one_file_are_refused() -> None:
    with pytest.raises(InputError, match=r"a-b and another paper .* tables/a-b-C\.csv"):
        check_apart(["tables/a-b-c.csv"], ["tables/a-b-C.csv"], "a-b")


def test_a_thing_is_found_in_the_room_of_its_section() -> None:
    assert address("doe2021", "audit", "audit-3") == "doe2021.audit.html#audit-3"
    assert address("doe2021", "claims") == "doe2021.html#claims"
    assert address("a", "tables", only="not run") == "a.tables.html?only=not-run#tables"


def test_every_section_of_every_room_has_a_heading_that_links_lead_to(tmp_path: Path) -> None:
    pages = pages_of(tmp_path)
    for room in ROOMS:
        page = pages.get(page_of("doe2021", room), "")
        for section in room.sections:
            assert f'id="{section.anchor}"' in page or not page
    assert {page_of("doe2021", room) for room in ROOMS} - set(pages) == {
        *("doe2021.arm.html", "doe2021.equations.html")
    }


def test_a_room_that_a_paper_no_longer_fills_goes_and_nothing_of_others(tmp_path: Path) -> None:
    pages_of(tmp_path, repeats=1)
    reports = tmp_path / "reports"
    ours, theirs = reports / "doe2021.figures.html", reports / "doe2021.equations.html"
    assert ours.exists()
    theirs.write_text("theirs")

    pages_of(tmp_path, replace(PAPER, figures=()), repeats=1)

    assert not ours.exists()
    assert theirs.read_text() == "theirs"
    assert set(pages_of_paper("doe2021")) > {path.name for path in reports.glob("doe2021.*")} - {
        theirs.name
    }


def test_the_markdown_page_has_contents_that_lead_to_its_parts_and_figures_beside_it(
    tmp_path: Path,
) -> None:
    pages = pages_of(tmp_path)
    text = pages["doe2021.md"]

    parts = re.findall(r"\]\(#([\w-]+)\)", text)
    pictures = re.findall(r"!\[.*?\]\((.*?)\)", text)

    assert {"claims", "tables", "audit", "figures", "provenance"} <= set(parts)
    assert all(text.count(f'<a id="{part}"></a>') == 1 for part in parts)
    assert len(pictures) == 6
    for name in pictures:
        drawn = ET.fromstring(pages[name])  # noqa: S314 (our own drawing)
        assert drawn.tag.endswith("svg")
        assert float(drawn.attrib["width"]) > 100
        assert pages[name.replace("figures/", "tables/").replace(".svg", ".csv")]


def test_captions_are_a_title_and_one_sentence_and_their_numbers_are_folded(
    tmp_path: Path,
) -> None:
    page = pages_of(tmp_path)["doe2021.figures.html"]
    captions = re.findall(r"<figcaption>(.*?)</figcaption>", page, re.DOTALL)
    assert len(captions) == 2
    for caption, number in zip(captions, ("after 12 iterations", "3 = 3 s"), strict=True):
        shown, _, folded = caption.partition("<details>")
        assert "CSV" in shown
        assert number in folded
        assert number not in shown
