from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from papers import liang2026, mousa2023, smwoa2022, syji
from repro.audit.arms import arm_rows, rows_of_arm
from repro.model import Arm, Paper
from repro.model.arm_motions import course, peaks
from repro.robotics import forward_kinematics
from repro.tables.rows import AuditRow, Grade
from tests.small_arms import ARM as OF_TWO_JOINTS


def arm_of(paper: Paper) -> Arm:
    return next(figure for figure in paper.figures if isinstance(figure, Arm))


@cache
def rows(paper_key: str) -> dict[str, list[AuditRow]]:
    modules = {"fanuc": liang2026, "syji": syji, "ur5": smwoa2022, "kuka": mousa2023}
    found: dict[str, list[AuditRow]] = {}
    for row in arm_rows(modules[paper_key].PAPER):
        found.setdefault(row.check, []).append(row)
    return found


def test_links_of_the_fanuc_differ_from_the_machine_s_and_by_how_much() -> None:
    (row,) = rows("fanuc")["arm-links"]

    assert row.grade is Grade.INCONSISTENT
    assert row.condition is not None
    for told in ("490 and 670 mm (-180)", "175 and 312", "1500 and 1075", "162 and 1280"):
        assert told in row.explanation


def test_links_of_the_kuka_are_the_machine_s() -> None:
    (row,) = rows("kuka")["arm-links"]

    assert row.grade is Grade.NOTED
    assert "has the links of the KUKA KR4 R600" in row.explanation


def test_speeds_that_the_machine_has_not_are_named_with_those_that_it_has() -> None:
    (row,) = rows("fanuc")["arm-limits"]

    for joint, speed in ((1, 2.27), (2, 2.01), (3, 2.18)):
        assert f"joint {joint} 3 over {speed} rad/s" in row.explanation
    assert "joint 4" not in row.explanation
    assert row.table == "section IV-B"


def test_printed_motion_of_the_fanuc_needs_more_than_its_axes_can_do() -> None:
    told = {
        row.explanation.partition(",")[0]: row.explanation for row in rows("fanuc")["arm-needs"]
    }

    assert "110 % of the speed of joint 1" in told["IWOA as printed"]
    assert "127 % of the speed of joint 3" in told["IWOA as printed"]
    assert "joint 2" not in told["IWOA as printed"]


def test_slow_machines_are_not_said_to_be_too_slow() -> None:
    assert "arm-needs" not in rows("kuka")
    assert not {"arm-limits", "arm-needs"} & rows("ur5").keys()


@pytest.mark.parametrize(
    ("arm", "lowest", "tool"), [("ur5", -697, -610), ("syji", -750, -641), ("fanuc", -89, 50)]
)
def test_depth_below_the_base_is_that_of_the_drawn_path(arm: str, lowest: int, tool: int) -> None:
    (row,) = rows(arm)["arm-below-base"]

    assert f"comes to {lowest} mm" in row.explanation
    assert f"the tool to {tool} mm" in row.explanation
    assert row.condition is not None


def test_time_below_the_base_is_that_of_samples_ten_times_as_fine() -> None:
    arm = arm_of(smwoa2022.PAPER)
    times, angles = course(arm.motions[0], derivative=0, samples=201)
    heights = [forward_kinematics(arm.dh, q)[2, 3] for q in angles]
    steps = np.diff(times)[np.array(heights[:-1]) < 0].sum()
    (row,) = rows("ur5")["arm-below-base"]

    assert f"({100 * steps / times[-1]:.0f} %)" in row.explanation
    assert "the tool for 4.33 s (37 %)" in row.explanation


def test_an_arm_that_stays_above_its_base_has_no_row_about_it() -> None:
    assert not {"arm-below-base", "arm-in-column"} & rows("kuka").keys()


def test_where_the_table_begins_at_the_shoulder_the_height_of_the_floor_is_said_to_be_unknown() -> (
    None
):
    assert "nothing says how high" in (rows("syji")["arm-below-base"][0].condition or "")
    assert "nothing says how high" not in (rows("ur5")["arm-below-base"][0].condition or "")


def test_wrist_beside_the_axis_of_the_column_is_told_in_millimetres() -> None:
    (row,) = rows("fanuc")["arm-in-column"]

    assert "44 mm from the axis of joint 1 and 324 mm above" in row.explanation


def test_ranges_say_what_is_left_and_what_is_beyond() -> None:
    (fanuc,), (kuka,) = rows("fanuc")["arm-ranges"], rows("kuka")["arm-ranges"]

    assert "J2 from -72.4° to 3.8° in -60°…76° (12.4° beyond)" in fanuc.explanation
    assert fanuc.explanation.endswith("Out of range: J2")
    assert "J3 over 277.8° of 312°" in fanuc.explanation
    assert "(7.4° left)" in kuka.explanation
    assert "A3 = 90° - θ3" in (kuka.condition or "")


def test_an_arm_without_a_machine_is_compared_with_none() -> None:
    arm = replace(arm_of(liang2026.PAPER), robot=None)

    checks = {row.check for row in rows_of_arm("key", arm)}

    assert checks == {"arm-below-base", "arm-in-column"}


@pytest.mark.parametrize("paper", [liang2026.PAPER, smwoa2022.PAPER, mousa2023.PAPER])
@pytest.mark.parametrize("derivative", [1, 2])
def test_exact_peaks_are_never_below_the_sampled_ones_and_near_them(
    paper: Paper, derivative: int
) -> None:
    for motion in arm_of(paper).motions:
        _, values = course(motion, derivative=derivative, samples=301)
        sampled = np.abs(values).max(axis=0)

        exact = peaks(motion, derivative)

        assert (exact >= sampled * (1 - 1e-12)).all()
        assert exact == pytest.approx(sampled, rel=1e-3, abs=1e-12)


def test_an_arm_of_two_joints_has_no_wrist_to_look_at() -> None:
    assert list(rows_of_arm("key", OF_TWO_JOINTS)) == []
