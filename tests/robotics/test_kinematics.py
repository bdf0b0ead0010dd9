import math
from functools import reduce

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.errors import InputError
from repro.robotics import Convention, dh_rows, forward_kinematics
from repro.robotics.kinematics import tool_coordinate

Matrix = NDArray[np.float64]

ANGLE = st.floats(-7.0, 7.0)
LENGTH = st.floats(-3.0, 3.0)
JOINT = st.tuples(LENGTH, ANGLE, LENGTH, ANGLE)  # a, alpha, d, theta
ARM = st.lists(JOINT, min_size=1, max_size=7)


def turn(angle: float, axis: int) -> Matrix:
    """Return the pose that is turned about the x axis (0) or the z axis (2)."""
    pose = np.eye(4)
    first, second = [k for k in range(3) if k != axis]
    pose[first, first] = pose[second, second] = math.cos(angle)
    pose[first, second], pose[second, first] = -math.sin(angle), math.sin(angle)
    return pose


def shift(length: float, axis: int) -> Matrix:
    """Return the pose that is shifted along an axis."""
    pose = np.eye(4)
    pose[axis, 3] = length
    return pose


def product(arm: list[tuple[float, float, float, float]], convention: Convention) -> Matrix:
    """Return the pose as a product of elementary motions: z then x, or x then z."""
    steps = []
    for a, alpha, d, theta in arm:
        about_z, about_x = [turn(theta, 2), shift(d, 2)], [shift(a, 0), turn(alpha, 0)]
        steps += about_z + about_x if convention == "standard" else about_x + about_z
    return reduce(np.matmul, steps)


def split(arm: list[tuple[float, float, float, float]]) -> tuple[Matrix, Matrix]:
    """Return the table (a, alpha, d) and the joint angles."""
    table = np.array(arm)
    return table[:, :3], table[:, 3]


@pytest.mark.parametrize("convention", ["standard", "modified"])
@given(arm=ARM)
def test_pose_is_the_product_of_turns_and_shifts(
    convention: Convention, arm: list[tuple[float, float, float, float]]
) -> None:
    pose = forward_kinematics(*split(arm), convention)

    assert pose == pytest.approx(product(arm, convention), abs=1e-12)


@pytest.mark.parametrize("convention", ["standard", "modified"])
@given(arm=ARM)
def test_pose_is_a_rigid_motion(
    convention: Convention, arm: list[tuple[float, float, float, float]]
) -> None:
    pose = forward_kinematics(*split(arm), convention)

    assert pose[:3, :3] @ pose[:3, :3].T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)
    assert pose[3].tolist() == [0.0, 0.0, 0.0, 1.0]


@given(st.floats(0.1, 2.0), st.floats(0.1, 2.0), ANGLE, ANGLE)
def test_planar_arm_of_two_links_stands_where_geometry_puts_it(
    first: float, second: float, q1: float, q2: float
) -> None:
    pose = forward_kinematics(dh_rows(a=(first, second), alpha=(0, 0), d=(0, 0)), (q1, q2))

    x = first * math.cos(q1) + second * math.cos(q1 + q2)
    y = first * math.sin(q1) + second * math.sin(q1 + q2)
    assert pose[:3, 3] == pytest.approx([x, y, 0.0], abs=1e-12)
    assert math.sin(math.atan2(pose[1, 0], pose[0, 0]) - q1 - q2) == pytest.approx(0.0, abs=1e-9)


@given(ARM)
def test_conventions_agree_where_the_table_is_shifted_by_a_row(
    arm: list[tuple[float, float, float, float]],
) -> None:
    table, q = split(arm)
    # the modified convention takes a and alpha of the row before; a last row closes the chain
    shifted = np.zeros((len(arm) + 1, 3))
    shifted[1:, :2] = table[:, :2]
    shifted[:-1, 2] = table[:, 2]

    modified = forward_kinematics(shifted, [*q, 0.0], "modified")

    assert modified == pytest.approx(forward_kinematics(table, q, "standard"), abs=1e-12)


@given(ARM, ARM)
def test_arm_on_an_arm_has_the_product_of_their_poses(
    lower: list[tuple[float, float, float, float]], upper: list[tuple[float, float, float, float]]
) -> None:
    whole = forward_kinematics(*split(lower + upper))

    parts = forward_kinematics(*split(lower)) @ forward_kinematics(*split(upper))
    assert whole == pytest.approx(parts, abs=1e-12)


@given(ARM)
def test_fourth_entry_is_added_to_the_joint_angle(
    arm: list[tuple[float, float, float, float]],
) -> None:
    moved = forward_kinematics(arm, np.zeros(len(arm)))

    assert moved == pytest.approx(forward_kinematics(*split(arm)), abs=1e-12)


@pytest.mark.parametrize(
    ("dh", "q"),
    [
        ([(1, 0, 0)], [0, 0]),
        ([(1, 0, 0), (1, 0, 0)], [0]),
        ([(1, 0)], [0]),
        ([(1, 0, 0, 0, 0)], [0]),
        ([(1, 0, 0)], [[0]]),
    ],
)
def test_shapes_that_do_not_fit_are_refused(dh: list[tuple[float, ...]], q: list[float]) -> None:
    with pytest.raises(InputError, match=r"D-H rows of shape \(.*\) and angles of shape"):
        forward_kinematics(dh, q)


def test_unknown_convention_is_refused_with_the_known_ones() -> None:
    unknown: Convention = "proximal"  # type: ignore[assignment]

    with pytest.raises(
        InputError, match="unknown convention 'proximal'; known: standard, modified"
    ):
        forward_kinematics([(1, 0, 0)], [0], unknown)


def test_tool_coordinate_is_an_entry_of_the_pose() -> None:
    dh, q = dh_rows(a=(1.0, 0.5), alpha=(math.pi / 2, 0.0), d=(0.3, 0.1)), (0.4, -1.1)
    position = forward_kinematics(dh, q)[:3, 3]

    assert [tool_coordinate(dh, q, axis) for axis in "xyz"] == position.tolist()
    assert tool_coordinate(dh, q, "x", "modified") != position[0]
