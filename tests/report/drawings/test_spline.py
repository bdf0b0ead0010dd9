import numpy as np
import pytest

from papers.smwoa2022 import PAPER, UR5
from repro.model.evidence import Runs
from repro.model.figures import SplineMotion
from repro.report.drawings.draw import Drawing, draw
from repro.robotics.proofs.spline_minimum import prove
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

LONG, SHORT = np.full(5, 6.0), np.full(5, 4.0)
ANGLE, ALL, *_ = PAPER.figures
CELL = ("trajectory", "UR5", "SMWOA")


def drawing(figure: object) -> Drawing:
    """Draw a figure where SMWOA found a long motion, and then a shorter one."""
    assert isinstance(figure, SplineMotion)
    points = np.array([[LONG, SHORT]])
    runs = Runs(
        costs=points.sum(axis=2), points=points, histories=np.zeros((1, 2, 1)), evaluations=10
    )
    return draw(figure, evidence_of(PAPER, {CELL: runs}), "fig")


@pytest.fixture(scope="module")
def every_joint() -> Drawing:
    return drawing(ALL)


def test_motions_are_the_printed_the_shortest_found_and_the_proved_one(
    every_joint: Drawing,
) -> None:
    ends = {row[0]: float(row[1]) for row in rows_of(every_joint.frame)[1:]}

    assert ends == pytest.approx(
        {
            "printed durations": 24.635,
            "SMWOA, re-run": 20.0,
            "certified optimum": float(prove(UR5).attained),
        },
        abs=1e-3,
    )


def test_data_are_four_derivatives_of_six_joints_from_node_to_node(every_joint: Drawing) -> None:
    found = [row[2:] for row in rows_of(every_joint.frame) if row[0] == "SMWOA, re-run"]

    assert len(rows_of(every_joint.frame)[0]) == 2 + 4 * 6
    assert np.array(found[0][:6], dtype=float) == pytest.approx(UR5.nodes[0], rel=1e-5)
    assert np.array(found[-1][:6], dtype=float) == pytest.approx(UR5.nodes[-1], rel=1e-5)


def test_description_tells_shares_of_the_limits_and_speeds_at_the_ends(
    every_joint: Drawing,
) -> None:
    assert "with at most 67.3 % of a velocity limit and 8.67 % of an acceleration limit" in (
        every_joint.description
    )
    assert "starting at 1.116 and ending at" in every_joint.description
    assert "No runs yet" not in every_joint.description


def test_a_single_joint_is_drawn_in_one_panel_with_the_motions_in_the_legend() -> None:
    found = drawing(ANGLE)

    assert len(rows_of(found.frame)[0]) == 3
    assert all(name in found.svg for name in ("printed durations", "SMWOA, re-run, 20 s"))
    assert "joint 1" not in found.svg.partition("</desc>")[2]


@pytest.mark.parametrize("figure", [ANGLE, ALL], ids=lambda figure: figure.label)
def test_every_figure_of_the_paper_is_drawn_without_any_run(figure: SplineMotion) -> None:
    drawn = draw(figure, evidence_of(PAPER, {}), "fig")

    assert "No runs yet of SMWOA." in drawn.description
    assert {row[0] for row in rows_of(drawn.frame)[1:]} == {
        "printed durations",
        "certified optimum",
    }
