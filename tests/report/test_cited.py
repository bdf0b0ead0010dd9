from dataclasses import replace

import pytest

from repro.model.paper import Source
from repro.report.cited import LONGEST, cited

SOURCE = Source(authors="S. Mirjalili, A. Lewis", title="The Whale", year=2016)


@pytest.mark.parametrize(
    ("authors", "called"),
    [
        ("S. Mirjalili, A. Lewis", "Mirjalili and Lewis (2016)"),
        ("S. Mirjalili and A. Lewis", "Mirjalili and Lewis (2016)"),
        ("S. Mirjalili, S. M. Mirjalili, A. Lewis", "Mirjalili et al. (2016)"),
        ("S. Mirjalili et al.", "Mirjalili et al. (2016)"),
        ("S. Mirjalili", "Mirjalili (2016)"),
        ("authors not on the copy", "The Whale (2016)"),
        ("", "The Whale (2016)"),
    ],
)
def test_a_paper_is_called_by_who_wrote_it_and_when(authors: str, called: str) -> None:
    assert cited("whale2016", replace(SOURCE, authors=authors)) == called


def test_a_year_that_the_copy_lacks_is_that_of_the_key() -> None:
    source = replace(SOURCE, year=None)

    assert cited("whale2016", source) == "Mirjalili and Lewis (2016)"
    assert cited("whale", source) == "Mirjalili and Lewis"


def test_a_long_title_is_cut_where_a_word_ends() -> None:
    source = replace(SOURCE, authors="", title="word " * 30, year=None)

    assert len(cited("whale", source)) <= LONGEST
    assert cited("whale", source).endswith("word …")
