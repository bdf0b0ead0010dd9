import math
from dataclasses import replace

import numpy as np
import pytest

from papers.liang2026 import MACHINE, PAPER
from papers.mousa2023 import KUKA
from repro.errors import DeclarationError
from repro.model import Arm, NamedRobot, PublishedTable

ONE_AXIS = PublishedTable.read("""
    maker's page, limits
    axis || least [deg] | greatest [deg] | speed [deg/s]
    A1   || -90         | 90             | 180
""")


def test_an_axis_reads_what_its_zero_and_its_sense_make_of_the_joint() -> None:
    third = KUKA.reads(2, np.array([math.pi / 2, 0.0]))

    assert third is not None
    assert third == pytest.approx([0.0, math.pi / 2])
    assert MACHINE.reads(0, np.zeros(1)) is None


def test_axes_out_of_range_are_counted_once_over_all_postures() -> None:
    robot = NamedRobot(name="one", axes=ONE_AXIS)

    assert robot.outside((1.0,), (-1.0,)) == 0
    assert robot.outside((2.0,), (-2.0,)) == 1


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"name": ""}, "its name must be a text"),
        ({"zeros": (0.0, 0.0)}, "zeros has 2 entries for 1 joints"),
        ({"signs": (2,)}, "signs are 1 or -1, not (2,)"),
        ({"links": ONE_AXIS}, "has no column 'a'; there is least, greatest, speed"),
        ({"links": MACHINE.links}, "has 6 rows and"),
        ({"axes": MACHINE.links}, "has no column 'least'"),
        ({"axes": "UR5"}, "'UR5' is no PublishedTable"),
    ],
)
def test_a_robot_that_cannot_be_is_refused_in_one_line(
    change: dict[str, object], told: str
) -> None:
    with pytest.raises(DeclarationError) as caught:
        replace(NamedRobot(name="one", axes=ONE_AXIS), **change)  # type: ignore[arg-type]

    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_robot_of_another_number_of_joints_than_the_links_is_refused() -> None:
    arm = next(figure for figure in PAPER.figures if isinstance(figure, Arm))

    with pytest.raises(DeclarationError, match="has 1 joints, the links 6"):
        replace(arm, robot=NamedRobot(name="one", axes=ONE_AXIS))
    with pytest.raises(DeclarationError, match="'UR5', which is no NamedRobot"):
        replace(arm, robot="UR5")  # type: ignore[arg-type]
