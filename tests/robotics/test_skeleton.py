import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.robotics import Convention, forward_kinematics
from repro.robotics.skeleton import skeleton

JOINTS = st.lists(
    st.tuples(*(st.floats(-2.0, 2.0) for _ in range(4))), min_size=1, max_size=7
)  # a, alpha, d, theta
CONVENTIONS = pytest.mark.parametrize("convention", ["standard", "modified"])


@CONVENTIONS
@given(joints=JOINTS)
def test_the_last_corner_is_the_tool(
    convention: Convention, joints: list[tuple[float, float, float, float]]
) -> None:
    table = np.array(joints)
    posture = skeleton(table[:, :3], table[:, 3], convention)
    tool = forward_kinematics(table[:, :3], table[:, 3], convention)[:3, 3]
    assert posture.corners.shape == (2 * len(joints) + 1, 3)
    assert posture.corners[-1] == pytest.approx(tool, abs=1e-12)


@CONVENTIONS
@given(joints=JOINTS)
def test_a_link_is_as_long_as_its_offset_and_its_normal(
    convention: Convention, joints: list[tuple[float, float, float, float]]
) -> None:
    table = np.array(joints)
    posture = skeleton(table[:, :3], table[:, 3], convention)
    lengths = np.linalg.norm(np.diff(posture.corners, axis=0), axis=1).reshape(-1, 2)
    first, second = (2, 0) if convention == "standard" else (0, 2)
    assert lengths == pytest.approx(np.abs(table[:, [first, second]]), abs=1e-9)


@CONVENTIONS
@given(joints=JOINTS, joint=st.integers(0, 6), turn=st.floats(-3.0, 3.0))
def test_a_joint_turns_what_comes_after_it_about_its_axis(
    convention: Convention,
    joints: list[tuple[float, float, float, float]],
    joint: int,
    turn: float,
) -> None:
    table = np.array(joints)
    joint %= len(joints)
    before = skeleton(table[:, :3], table[:, 3], convention)
    table[joint, 3] += turn
    after = skeleton(table[:, :3], table[:, 3], convention)
    place, axis = before.joints[joint], before.axes[joint]
    for point, moved in zip(before.origins, after.origins, strict=True):
        # along the axis and away from it nothing changes
        assert (moved - place) @ axis == pytest.approx((point - place) @ axis, abs=1e-9)
        distance = np.linalg.norm(np.cross(axis, point - place))
        assert np.linalg.norm(np.cross(axis, moved - place)) == pytest.approx(distance, abs=1e-9)
    assert after.origins[: joint + 1] == pytest.approx(before.origins[: joint + 1], abs=1e-12)


def test_a_stretched_plane_arm_lies_along_x() -> None:
    posture = skeleton([(1.0, 0.0, 0.0), (0.5, 0.0, 0.0)], [0.0, 0.0])
    assert posture.origins == pytest.approx(np.array([[0, 0, 0], [1, 0, 0], [1.5, 0, 0]]))
    assert posture.axes == pytest.approx(np.array([[0, 0, 1], [0, 0, 1]]))
