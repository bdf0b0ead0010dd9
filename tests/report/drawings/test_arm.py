import json
from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from papers.liang2026 import PAPER as LIANG
from papers.mousa2023 import PAPER as MOUSA
from papers.smwoa2022 import PAPER as SMWOA
from papers.syji import PAPER as SYJI
from repro.errors import DeclarationError
from repro.model.figures import Arm
from repro.model.paper import Paper
from repro.report.drawings.draw import Drawing, draw
from tests.small_arms import ARM, SHOWING_AN_ARM
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

PAPERS = (LIANG, MOUSA, SMWOA, SYJI)
SVG = "{http://www.w3.org/2000/svg}"


def drawn(paper: Paper = SHOWING_AN_ARM) -> Drawing:
    (arm,) = (figure for figure in paper.figures if isinstance(figure, Arm))
    found = evidence_of(paper, {})
    return draw(arm, found, "paper-arm", assumptions=paper.assumptions)


def test_the_scene_has_every_corner_of_the_arm_in_millimetres() -> None:
    scene = drawn().scene
    assert scene is not None
    printed, certified = scene["motions"]
    assert len(printed["times"]) == len(printed["corners"]) == len(printed["axes"])
    assert printed["corners"][0] == [0, 0, 0, 1000, 0, 0, 1500, 0, 0]
    assert certified["corners"][-1][-3:] == pytest.approx([-500, 1000, 0], abs=1)
    assert scene["waypoints"] == [[1500, 0, 0], [0, 1500, 0], [-500, 1000, 0]]
    assert scene["joints"] == [0, 1]


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_every_paper_shows_its_arm_with_two_motions_in_a_few_bytes(paper: Paper) -> None:
    drawing = drawn(paper)
    assert drawing.scene is not None
    assert len(drawing.scene["motions"]) == 2
    assert len(json.dumps(drawing.scene)) < 200_000
    assert "Assumed: Denavit-Hartenberg" in drawing.description or paper is SMWOA
    assert "Assumed: links of the UR5" in drawing.description or paper is not SMWOA


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_links_of_the_scene_keep_their_lengths(paper: Paper) -> None:
    scene = drawn(paper).scene
    assert scene is not None
    for motion in scene["motions"]:
        corners = np.array(motion["corners"]).reshape(len(motion["times"]), -1, 3)
        lengths = np.linalg.norm(np.diff(corners, axis=1), axis=2)
        assert (
            np.ptp(lengths, axis=0).max() <= 4
        )  # mm: half of one for each coordinate of both ends
        axes = np.array(motion["axes"]).reshape(len(motion["times"]), -1, 3)
        assert np.linalg.norm(axes, axis=2) == pytest.approx(100, abs=1)


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_everything_that_moves_lies_in_the_ball_that_the_camera_shows(paper: Paper) -> None:
    scene = drawn(paper).scene
    assert scene is not None
    for motion in scene["motions"]:
        corners = np.array(motion["corners"]).reshape(-1, 3)
        distances = np.linalg.norm(corners - np.array(scene["middle"]), axis=1)
        assert distances.max() <= scene["radius"] + 3


def test_the_text_alternative_says_what_the_view_shows() -> None:
    description = drawn().description
    assert "An arm of 2 joints" in description
    assert "1 at (1.500, 0.000, 0.000); 2 at (0.000, 1.500, 0.000)" in description
    assert "4 + 6 = 10 s, the tool travels 3.14" in description
    assert "certified optimum: 2.945 + 2.945 = 5.890 s" in description
    assert "Assumed: plane of the arm: level, because no other is" in description


def test_the_data_are_the_origins_of_the_frames_over_time() -> None:
    headings, first, *_, last = rows_of(drawn().frame)
    assert headings[:2] == ("motion", "time [s]")
    assert headings[2:5] == ("x of base [m]", "y of base [m]", "z of base [m]")
    assert headings[-3:] == ("x of tool [m]", "y of tool [m]", "z of tool [m]")
    assert first[1:] == (
        "0",
        *("0",) * 3,
        "1",
        *("0",) * 2,
        "1.5",
        *("0",) * 2,
    )
    assert [float(value) for value in last[-3:]] == pytest.approx([-0.5, 1.0, 0.0], abs=1e-4)


def test_the_still_numbers_the_waypoints_and_tells_its_scale() -> None:
    texts = [e.text for e in ET.fromstring(drawn().svg).iter(f"{SVG}text")]  # noqa: S314 (ours)
    assert {"1", "2", "3", "x 0.5 m", "y 0.5 m", "z 0.5 m", "squares: 0.5 m"} <= set(texts)
    assert {"arm at start", "between", "arm at goal", "path of the tool"} <= set(texts)


def test_an_assumption_that_is_not_there_is_refused_by_name() -> None:
    figure = replace(ARM, assumed=("colour of the arm",))
    refusal = r"no assumption 'colour of the arm'; known: .*plane of the arm"
    with pytest.raises(DeclarationError, match=refusal):
        draw(
            figure,
            evidence_of(SHOWING_AN_ARM, {}),
            "x",
            assumptions=SHOWING_AN_ARM.assumptions,
        )


def test_the_scene_tells_the_angles_and_the_nearest_limit_of_every_instant() -> None:
    scene = drawn().scene
    assert scene is not None
    _, certified = scene["motions"]
    middle = len(certified["times"]) // 4  # of the first segment, where joint 1 is fastest

    assert scene["names"] == ["1 [°]", "2 [°]"]
    assert scene["limits"][:3] == [
        "velocity of joint 1",
        "velocity of joint 2",
        "acceleration of joint 1",
    ]
    assert certified["angles"][0] == [0, 0]
    assert certified["angles"][-1] == [900, 900]
    assert certified["nearest"][middle] == [0, 100]
    assert len(certified["nearest"]) == len(certified["angles"]) == len(certified["times"])


def test_without_limits_those_of_the_machine_are_shown_and_else_none() -> None:
    scene = drawn(MOUSA).scene
    assert scene is not None
    assert len(scene["limits"]) == 12
    arm = next(figure for figure in MOUSA.figures if isinstance(figure, Arm))
    alone = draw(
        replace(arm, robot=None), evidence_of(MOUSA, {}), "x", assumptions=MOUSA.assumptions
    ).scene
    assert alone is not None
    assert alone["limits"] == alone["motions"][0]["nearest"] == []


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_a_foot_stands_only_where_the_parameters_leave_room_for_it(paper: Paper) -> None:
    scene = drawn(paper).scene
    assert scene is not None
    assert scene["column"] is (paper is not SYJI)


def test_what_the_parameters_do_not_say_is_said_to_be_ours() -> None:
    description = drawn().description
    assert "how thick links, joints and foot are is ours" in description
    assert "how high it is above a floor the parameters do not say" in description
