import pytest

from repro.judge.judgement import judge
from repro.judge.other_readings import FARTHEST
from repro.report.pages import render
from repro.report.views.readings import ReadingsView, readings_view
from tests.judge.test_other_readings import WIDER, evidence, open_paper


def view(**costs: float) -> ReadingsView:
    paper = open_paper(WIDER)
    return readings_view(judge(paper, evidence(paper, **costs)))


def test_contradicted_numbers_are_split_by_whether_a_reading_reaches_them() -> None:
    shown = view(guess=5.0, wider=0.05)

    assert shown.contradicted == shown.within_reach + shown.out_of_reach + shown.untouched
    assert (shown.within_reach, shown.untouched) == (1, 1)  # the column wide has a wrong std
    assert [(row.name, row.tried, row.reached) for row in shown.rows] == [("wider", 2, 1)]


def test_fingerprint_names_its_column_and_the_nearest_reading() -> None:
    shown = view(guess=5.0, wider=0.05)

    assert [row[:2] for row in shown.prints] == [("Table 1", "guess")]
    assert shown.prints[0][4] == "wider"


def test_paper_whose_readings_were_not_run_shows_none() -> None:
    assert view(guess=5.0).rows == ()


@pytest.mark.parametrize("page", ["md", "html"])
def test_both_pages_say_what_a_zero_counts_in_a_distance(page: str) -> None:
    shown = view(guess=5.0, wider=0.05)
    context = {"readings": shown, "reading_repeats": 1, "provenance": {"repeats": 20}}

    text = render(f"sections/readings.{page}", context)

    assert f"a zero against another number counts as {FARTHEST:g}." in text
