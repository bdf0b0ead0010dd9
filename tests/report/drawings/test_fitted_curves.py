from functools import partial

import numpy as np
import pytest

from papers.mousa2023 import FIT, PAPER, QUINTIC
from repro.model.evidence import Runs
from repro.model.figures import JointCurves
from repro.report.drawings import draw as drawn_figures
from repro.report.drawings.draw import Drawing
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

FIGURE = JointCurves(
    label="Fig. 4", caption="Joints", paths=QUINTIC, experiment=FIT.name, algorithms=("WOA", "GA")
)
COSTS = [[3.0, 9.0, 5.0]]  # the third run is in the middle

draw = partial(drawn_figures.draw, assumptions=PAPER.assumptions)


def runs(name: str) -> Runs:
    """Return three runs, of which the last found the desired path moved by 0.01 rad."""
    fit = FIT.problems[name]
    points = np.zeros((1, 3, 6))
    points[0, 2] = fit.coefficients + np.array([0.01, 0, 0, 0, 0, 0])
    return Runs(costs=np.array(COSTS), points=points, histories=np.zeros((1, 3, 2)), evaluations=60)


@pytest.fixture(scope="module")
def drawing() -> Drawing:
    cells = {(FIT.name, name, "WOA"): runs(name) for name in FIT.problems}
    return draw(FIGURE, evidence_of(PAPER, cells), "fig")


def test_columns_are_the_algorithms_that_have_run_and_the_desired_path(drawing: Drawing) -> None:
    assert {row[0] for row in rows_of(drawing.frame)[1:]} == {"WOA", "desired path"}
    assert "No runs yet of GA." in drawing.description


def test_an_algorithm_is_drawn_by_its_median_run(drawing: Drawing) -> None:
    assert "root mean square errors of the joints " + ", ".join(["0.01000"] * 6) in (
        drawing.description
    )


def test_data_are_angle_velocity_and_acceleration_of_every_joint(drawing: Drawing) -> None:
    desired = [row for row in rows_of(drawing.frame) if row[0] == "desired path"]
    first, last = (np.array(row[1:], dtype=float) for row in (desired[0], desired[-1]))

    assert len(rows_of(drawing.frame)[0]) == 2 + 3 * 6
    assert first[1:7] == pytest.approx([fit.start for fit in QUINTIC])
    assert last[1:7] == pytest.approx([fit.end for fit in QUINTIC])
    assert (first[0], last[0]) == (0.0, 2.0)
    assert np.abs(first[7:]).max() < 1e-9


def test_peaks_of_the_desired_path_are_those_of_the_quintic(drawing: Drawing) -> None:
    # joint 6 moves 2 rad in 2 s: 15/8 rad/s and 10/√3 · 2/4 rad/s²
    assert "desired path: at most 1.875 rad/s and 2.887 rad/s²" in drawing.description


@pytest.mark.parametrize("figure", PAPER.figures, ids=lambda figure: figure.label)
def test_every_figure_of_the_paper_is_drawn_without_any_run(figure: JointCurves) -> None:
    drawn = draw(figure, evidence_of(PAPER, {}), "fig")

    assert drawn.svg.startswith("<svg")
    assert drawn.title == f"{figure.label}: {figure.caption}"
