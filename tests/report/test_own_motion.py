"""What names of joints and a title, which a file of somebody's gives, do to what is written."""

import csv
import io
import json
import re
from dataclasses import replace

import pytest

from repro.commands.motion import result
from repro.commands.motion_files import read_motion
from repro.judge.own_motion import OwnResult
from repro.report.own_motion import csv_text, page
from tests.hostile import STRINGS, tags

FILE = """
title = "pick"
unit = "deg"
law = "quintic"
waypoints = [[0, 0], [90, -45]]
velocity = 180
acceleration = 300
dh = [[0, 0.4, 0.025, -90], [0, 0, 0.315, 0]]
"""
HOSTILE = (*STRINGS, "</script><script>alert(1)</script>", 'a"b,c\nd', "=1+1", "a\r\nb")


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> OwnResult:
    """Return what is proved of a motion of two joints."""
    path = tmp_path_factory.mktemp("motion") / "pick.toml"
    path.write_text(FILE)
    return result(read_motion(path), 1.0)


@pytest.mark.parametrize("text", HOSTILE)
def test_a_name_of_a_joint_is_one_heading_of_its_own(found: OwnResult, text: str) -> None:
    plain, named = (
        list(csv.reader(io.StringIO(csv_text(replace(found, names=names)), newline="")))
        for names in (found.names, (text, "b"))
    )

    assert named[0][1] == f"positions.{text}".replace("\r", "\n")
    assert named[0][2::2] == ["positions.b", "velocities.b", "accelerations.b"]
    assert named[1:] == plain[1:]


@pytest.mark.parametrize("text", HOSTILE)
def test_no_name_of_a_joint_and_no_title_is_markup_on_the_page(found: OwnResult, text: str) -> None:
    said = page(replace(found, names=(text, "b"), title=text), says=[text])
    scene = re.search(r'class="arm-scene">(.*?)</script>', said)

    assert tags(said) == tags(page(found, says=["x"]))
    assert scene
    assert json.loads(scene[1])["names"][0].startswith(text)
