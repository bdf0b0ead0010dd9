from dataclasses import replace

import pytest

from repro.judge.beside_baselines import experiment_standings, paper_standings
from repro.model.evidence import Cell, Runs
from repro.report.rendering import render
from repro.report.views.baselines import standings_view
from tests.judge.test_beside_baselines import EQUAL, EXPERIMENT, every_run, runs
from tests.small_papers import PAPER


def test_view_has_a_row_per_problem_and_a_column_per_algorithm() -> None:
    found = every_run()
    view = standings_view(experiment_standings(EXPERIMENT, found, ()))

    assert view.headings[2:] == ("WOA", "DE", "DE, equal evaluations", "random search")
    assert view.rows[1][2] == "4 (median 3); rank 1"  # 4 away from 0
    assert view.rows[0][2].endswith("3.60 away; rank 1")
    assert view.summary[1] == ("DE", "printed protocol", "3", "210", "–")
    assert view.budgets[1] == ("DE", "210", "1.00", "200", "2.00")


def test_seconds_are_shown_where_they_are_asked_for_and_not_on_published_pages() -> None:
    found = experiment_standings(EXPERIMENT, every_run(), ())
    published, private = standings_view(found), standings_view(found, seconds=True)

    assert private.summary[1] == ("DE", "printed protocol", "3", "210", "0.25 s", "–")
    assert set(private.summary_headings) - set(published.summary_headings) == {"time of a run"}
    assert len(published.summary[1]) == len(published.summary_headings)


@pytest.mark.parametrize(("found", "shown"), [({}, 0), (every_run(), 1)], ids=["none", "all"])
def test_pages_show_experiments_beside_which_more_was_run(
    found: dict[Cell, Runs], shown: int
) -> None:
    paper = replace(PAPER, experiments=(EXPERIMENT,), results=(), claims=())

    assert len(paper_standings(paper, found, ())) == shown


def test_problem_without_runs_has_no_cell_in_the_view() -> None:
    found = every_run()
    del found["search", "hump", "WOA"]

    view = standings_view(experiment_standings(EXPERIMENT, found, ()))

    assert view.rows[0][view.headings.index("WOA")] == "–"


def test_markdown_raises_powers_of_ten_and_keeps_bars_in_their_cells() -> None:
    found = every_run()
    view = standings_view(experiment_standings(EXPERIMENT, found, ()))

    shown = replace(view, headings=("a|b",), rows=(("2.000×10^-9",), ("<b>|",)))
    text = render("sections/baselines.md", {"standings": (shown,)})

    assert "| a\\|b |" in text
    assert "| 2.000×10<sup>−9</sup> |" in text
    assert "| &lt;b>\\| |" in text


def test_page_calls_the_equal_budget_what_a_run_may_spend() -> None:
    found = every_run()
    found[EQUAL, "hump", "DE"] = runs([5.0, 5.0, 5.0], 190)  # whole iterations of 20 fit no more
    view = standings_view(experiment_standings(EXPERIMENT, found, ()))

    page = render("sections/baselines.md", {"standings": [view]})

    assert "among all that may spend 200 evaluations" in page
    assert "| DE | equal evaluations | 3 | 190 |" in page
