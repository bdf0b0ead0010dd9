import math
from dataclasses import replace

import numpy as np
import pytest

from papers.mousa2023 import ARM_QUINTIC, QUINTIC, axis_angles
from papers.smwoa2022 import DH as UR5_LINKS
from papers.smwoa2022 import UR5
from repro.model.figures import Arm, ArmMotion
from repro.report.drawings.arm_motion import SAMPLES, moving, waypoints
from repro.robotics import forward_kinematics
from repro.robotics.polynomial_curves import values
from repro.robotics.proofs.spline_minimum import prove
from tests.small_arms import ARM, SWING


def test_a_motion_passes_every_waypoint_at_its_time() -> None:
    printed, certified = moving(ARM)
    stops = [stop.corners[-1] for stop in waypoints(ARM)]
    for motion, durations in ((printed, (4.0, 6.0)), (certified, SWING.shortest())):
        for time, stop in zip([0.0, *np.cumsum(durations)], stops, strict=True):
            nearest = int(np.argmin(abs(motion.times - time)))
            assert motion.times[nearest] == pytest.approx(time)
            assert motion.tool[nearest] == pytest.approx(stop, abs=1e-9)


def test_without_durations_a_motion_takes_the_certified_ones() -> None:
    _, certified = moving(ARM)
    # a quintic at rest at both ends peaks at 15/8 of its mean speed, which here is 1 rad/s
    assert certified.durations == pytest.approx([15 / 16 * math.pi] * 2)
    assert certified.total == pytest.approx(15 / 8 * math.pi)


def test_the_tool_travels_two_quarter_circles() -> None:
    printed, certified = moving(ARM)
    assert printed.length == pytest.approx((1.5 + 0.5) * math.pi / 2, rel=1e-3)
    assert certified.length == pytest.approx(printed.length)


def test_a_motion_has_no_more_samples_than_a_page_should_carry() -> None:
    assert all(100 < len(motion.times) <= SAMPLES for motion in moving(ARM))


def test_a_spline_goes_through_its_nodes_with_the_proved_durations() -> None:
    arm = replace(ARM, dh=UR5_LINKS, motions=(ArmMotion(name="optimum", problem=UR5),))
    (motion,) = moving(arm)
    assert motion.durations == pytest.approx([float(d) for d in prove(UR5).durations])
    assert motion.total == pytest.approx(sum(motion.durations))
    samples = len(motion.times) // UR5.segments
    passed = motion.tool[[*range(0, len(motion.times), samples), -1]]
    nodes = [forward_kinematics(UR5_LINKS, q)[:3, 3] for q in UR5.nodes]
    assert passed == pytest.approx(np.array(nodes), abs=1e-9)


def test_path_fits_are_shown_along_their_desired_paths() -> None:
    one = ((1.0, 0.0, 0.0),) * 6
    arm = Arm(
        label="Arm",
        caption="",
        dh=one,
        convention="standard",
        motions=(ArmMotion(name="quintic", problem=QUINTIC),),
    )
    (motion,) = moving(arm)
    start, goal = waypoints(arm)
    assert motion.total == QUINTIC[0].duration
    assert motion.tool[0] == pytest.approx(start.corners[-1])
    assert motion.tool[-1] == pytest.approx(goal.corners[-1])
    angles = np.transpose([values(fit.coefficients, motion.times) for fit in QUINTIC])
    tool = [forward_kinematics(one, q)[:3, 3] for q in angles]
    assert motion.tool == pytest.approx(np.array(tool), abs=1e-9)


def test_angles_of_the_real_kuka_arm_move_on_the_same_polynomial() -> None:
    for path, joint in zip(QUINTIC, ARM_QUINTIC, strict=True):
        assert (joint.law, joint.duration) == (path.law, path.duration)
    assert axis_angles(tuple(fit.start for fit in ARM_QUINTIC)) == pytest.approx(
        tuple(fit.start for fit in QUINTIC)
    )
