import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.robotics import Convention, forward_kinematics, freedoms, jacobian

ELBOW = ((0.3, math.pi / 2, 0.5), (0.6, 0.0, 0.1), (0.4, -math.pi / 2, 0.2))
POSTURE = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3).map(np.array)
CONVENTIONS = pytest.mark.parametrize("convention", ["standard", "modified"])


@CONVENTIONS
@given(q=POSTURE)
def test_linear_part_is_the_derivative_of_the_tool_position(
    convention: Convention, q: np.ndarray
) -> None:
    found = jacobian(ELBOW, q, convention)
    step = 1e-6
    for joint in range(3):
        moved = q.copy()
        moved[joint] += step
        before, after = (forward_kinematics(ELBOW, p, convention) for p in (q, moved))
        assert (after - before)[:3, 3] / step == pytest.approx(found[:3, joint], abs=1e-5)


@CONVENTIONS
@given(q=POSTURE)
def test_angular_part_is_the_derivative_of_the_orientation(
    convention: Convention, q: np.ndarray
) -> None:
    found = jacobian(ELBOW, q, convention)
    step = 1e-6
    for joint in range(3):
        moved = q.copy()
        moved[joint] += step
        before, after = (forward_kinematics(ELBOW, p, convention)[:3, :3] for p in (q, moved))
        spin = (after - before) @ before.T / step
        assert (spin[2, 1], spin[0, 2], spin[1, 0]) == pytest.approx(
            tuple(found[3:, joint]), abs=1e-5
        )


def test_plane_arm_has_three_freedoms_bent_and_stretched_two_with_two_joints() -> None:
    plane = ((0.5, 0.0, 0.0),) * 3

    assert freedoms(plane, [0.1, 0.7, -0.4]) == 3
    assert freedoms(plane, [0.1, 0.0, 0.0]) == 2
    assert freedoms(plane[:2], [0.1, 0.7]) == 2


def test_two_joints_about_one_axis_have_one_freedom() -> None:
    assert freedoms(((0.0, 0.0, 0.1), (0.2, 0.0, 0.0)), [0.3, 0.4]) == 1
