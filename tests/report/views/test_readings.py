from dataclasses import replace

import pytest

from repro.judge.judgement import judge
from repro.judge.other_readings import FARTHEST
from repro.report.rendering import render
from repro.report.views.readings import ReadingsView, readings_view, ruled_out_by, settings_of
from repro.report.views.turned import turned_by
from tests.judge.test_other_readings import WIDER, evidence, open_paper


def view(**costs: float) -> ReadingsView:
    paper = open_paper(WIDER)
    return readings_view(judge(paper, evidence(paper, **costs)))


def shown_with(view: ReadingsView) -> dict[str, object]:
    """Return what the section names."""
    return {
        "paper": open_paper(WIDER),
        "readings": view,
        "matrix": turned_by(view.rows, (), {}),
        "reading_repeats": 1,
        "provenance": {"repeats": 20},
    }


def test_a_reading_says_on_how_much_it_bears_what_it_turns_and_how_deep_it_was_run() -> None:
    shown = view(guess=5.0, wider=0.05)

    (row,) = shown.rows
    assert (row.name, row.bears, row.turns, row.repeats, row.open) == ("wider", 2, 1, "2", False)


def test_numbers_are_split_by_what_the_readings_do_to_them() -> None:
    shown = view(guess=5.0, wider=0.05)

    assert (shown.judged, shown.touched, shown.depends) == (4, 2, 1)
    # the std of the column that the reading changes, and the one of the other column
    assert (shown.contradicted, shown.untouched) == (2, 1)


def test_a_value_of_an_open_setting_that_the_number_lies_between_turns_it() -> None:
    paper = open_paper(replace(WIDER, at=3.0))
    (width,) = paper.assumptions
    paper = replace(paper, assumptions=(replace(width, open=True, at=1.0),))

    shown = readings_view(judge(paper, evidence(paper, guess=5.0, wider=0.0005)))

    assert settings_of(paper) == {"width": ("wider",)}
    assert [(row.open, row.turns) for row in shown.rows] == [(True, 1)]


@pytest.mark.parametrize("page", ["md", "html"])
def test_no_page_says_that_no_reading_was_chosen_because_it_fits(page: str) -> None:
    shown = view(guess=5.0, wider=0.05)
    text = render(f"sections/readings.{page}", shown_with(shown))

    assert "because it fits" not in text
    assert "was settled by what meets the print" in text


def test_fingerprint_names_its_column_and_the_nearest_reading() -> None:
    shown = view(guess=5.0, wider=0.05)

    assert [row[:2] for row in shown.prints] == [("Table 1", "guess")]
    assert shown.prints[0][5] == "wider"


def test_paper_whose_readings_were_not_run_shows_none() -> None:
    assert view(guess=5.0).rows == ()


@pytest.mark.parametrize("page", ["md", "html"])
def test_both_pages_say_what_a_zero_counts_in_a_distance(page: str) -> None:
    shown = view(guess=5.0, wider=0.05)
    text = render(f"sections/readings.{page}", shown_with(shown))

    assert f"a zero against another number counts as {FARTHEST:g}." in text


def test_a_reading_that_the_text_rules_out_is_shown_and_said_to_be_so() -> None:
    paper = open_paper(replace(WIDER, ruled_out=True))

    shown = readings_view(judge(paper, evidence(paper, guess=5.0, wider=0.05)))

    assert ruled_out_by(paper) == {"wider"}
    assert [(row.name, row.ruled_out, row.turns) for row in shown.rows] == [("wider", True, 0)]


def test_two_forms_of_a_controls_search_stand_side_by_side() -> None:
    paper = replace(open_paper(replace(WIDER, full_depth=True)), control=True)
    costs = evidence(paper, guess=5.0, wider=0.05)

    (form,) = readings_view(judge(paper, costs)).beside

    assert form.reading == "wider"
    assert form.counts[0] == {"contradicted": 2}
    assert form.counts[1] == {"reproduced": 1, "contradicted": 1}
    assert form.rows[0] == (
        *("Table 1, bowl mean, guess", "0.05", "5", "✖ contradicted (re-run higher)"),
        *("0.05000", "✔ reproduced"),
    )
    for page in ("md", "html"):
        context = shown_with(readings_view(judge(paper, costs)))
        assert "beside" in render(f"sections/readings.{page}", context)


def test_other_papers_readings_are_not_set_side_by_side() -> None:
    paper = open_paper(replace(WIDER, full_depth=True))

    assert readings_view(judge(paper, evidence(paper, guess=5.0, wider=0.05))).beside == ()
