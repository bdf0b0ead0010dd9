import re
from pathlib import Path

import pytest

from repro.errors import InputError
from repro.report.glossary import glossary, term_link
from repro.report.rendering import render
from repro.report.rooms import ROOMS

ROOT = Path(__file__).parents[2]


def test_every_word_is_written_somewhere_or_explains_another() -> None:
    seen = {other for term in glossary().terms for other in term.see}

    assert [t.name for t in glossary().terms if not t.written and t.name not in seen] == []


def test_no_written_form_stands_for_two_words() -> None:
    forms = [form.lower() for term in glossary().terms for form in term.written]

    assert len(forms) == len(set(forms))


def test_what_an_entry_refers_to_is_an_entry_and_no_word_stands_twice() -> None:
    names = [term.name for term in glossary().terms]

    assert len(names) == len(set(names))
    assert {other for term in glossary().terms for other in term.see} <= set(names)


def test_a_word_that_there_is_not_is_refused() -> None:
    with pytest.raises(InputError, match="'raeding' is not in glossary"):
        term_link("raeding", markdown=False)


def test_a_link_leads_to_the_word_on_either_kind_of_page() -> None:
    assert term_link("reading", "readings", markdown=True) == "[readings](glossary.md#reading)"
    page = render("glossary.html", {"terms": glossary().terms})
    for term in glossary().terms:
        link = str(term_link(term.name, markdown=False))
        place = link.partition("#")[2].partition('"')[0]
        assert f'<dt id="{place}">' in page


def test_every_part_of_a_paper_says_what_else_it_is_called() -> None:
    parts = {section.name for room in ROOMS for section in room.sections}

    assert set(glossary().rooms) <= parts


def test_the_manual_has_the_words_of_the_pages() -> None:
    written = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")

    assert written == render("manual-glossary.md", {"terms": glossary().terms})


def test_a_heading_of_the_markdown_page_has_the_anchor_that_links_name() -> None:
    for term in glossary().terms:
        of_heading = re.sub(r"[^a-z0-9 -]", "", term.name.lower()).replace(" ", "-")
        assert of_heading == term.anchor
