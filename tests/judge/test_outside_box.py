from dataclasses import replace

import numpy as np

from repro.judge.outside_box import inside_box, outside_boxes
from repro.model.evidence import Evidence
from tests.small_papers import PAPER, evidence

CELL = ("search", "bowl", "wide")


def found_at(*points: tuple[float, float]) -> Evidence:
    """Return evidence of a search that may leave the box, with runs that end at these points."""
    made = evidence(wide=[[0.1] * len(points)])
    runs = {CELL: replace(made.runs[CELL], points=np.array([points]))}
    return replace(made, runs=runs)


def test_runs_that_end_outside_the_box_are_counted_for_searches_that_may() -> None:
    (found,) = outside_boxes(PAPER, found_at((0.0, 1.0), (0.0, -1.5), (np.nan, 0.0)))

    assert (found.algorithm, found.outside, found.runs) == ("wide", 2, 3)
    assert found.says == (
        "search: the source of wide lets points leave the box; 2 of 3 runs end with a point "
        "outside it, on bowl"
    )


def test_edge_of_the_box_is_inside() -> None:
    assert inside_box(found_at((-1.0, 1.0)), CELL).tolist() == [[True]]


def test_search_that_is_held_or_was_not_run_is_not_told_of() -> None:
    assert outside_boxes(PAPER, evidence(guess=[[0.1, 0.2]])) == ()
