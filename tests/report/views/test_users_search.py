from dataclasses import replace

import numpy as np

from repro.judge.users_search import printed_means, users_search
from repro.model.evidence import Runs
from repro.model.paper import Paper
from repro.report.rendering import render
from repro.report.views.users_search import users_search_view
from tests.small_papers import EXPERIMENT, PAPER


def runs(*costs: float) -> Runs:
    repeats = np.array([costs])
    return Runs(
        costs=repeats,
        points=np.zeros((*repeats.shape, 2)),
        histories=repeats[..., None],
        evaluations=20,
    )


def compared(paper: Paper = PAPER) -> tuple[tuple[str, ...], tuple[str, ...]]:
    own, other = runs(0.1, 0.2, 0.3), runs(0.4, 0.5, 0.3)
    found = {("search", "bowl", "mine"): own, ("search", "bowl", "guess"): other}
    view = users_search_view(users_search(paper, EXPERIMENT, found, (), name="mine"))
    return view.printed[0], view.tests[0]


def test_place_among_the_printed_means_counts_those_that_are_lower() -> None:
    printed, _ = compared()

    assert printed == ("bowl", "guess 0.05; wide 0.5", "0.2000", "2 of 3")


def test_test_against_another_search_is_the_rank_sum() -> None:
    _, test = compared()

    assert test[:5] == ("bowl", "guess", "printed protocol", "0.2000", "0.4000")
    assert test[7] == f"{8.5 / 9:.2f}"  # of nine pairs, eight are won and one is a tie


def test_paper_that_prints_no_mean_has_no_place_to_take() -> None:
    bare = replace(PAPER, results=(), claims=())

    assert printed_means(bare, "search", "bowl") == {}
    assert compared(bare)[0] == ("bowl", "none", "0.2000", "–")


def test_markdown_page_raises_powers_of_ten() -> None:
    found = {("search", "bowl", name): runs(2e-65, 2e-65, 2e-65) for name in ("mine", "guess")}
    view = users_search_view(users_search(PAPER, EXPERIMENT, found, (), name="mine"))
    shown = {"name": "mine", "place": "mine:f", "repeats": 1, "failed": []}

    page = render("compare.md", shown | {"papers": [(PAPER, [view])]})

    assert page.count("2.000×10<sup>−65</sup>") >= 5  # in standings, printed means and tests
    assert "&lt;" not in page
