import math

import pytest

from repro.robotics.kinematics import dh_rows
from repro.robotics.link_lengths import link_lengths

RIGHT = math.pi / 2
STANDARD = dh_rows(a=(0.3, 1.0, 0.2), alpha=(RIGHT, 0.0, 0.0), d=(0.7, 0.1, 0.25))


def test_lengths_along_parallel_axes_are_told_as_their_sum() -> None:
    assert link_lengths(STANDARD).lengths == pytest.approx(
        {
            "along axis 1": 0.7,
            "between axes 1 and 2": 0.3,
            "along axes 2 to 3": 0.35,
            "between axes 2 and 3": 1.0,
        }
    )


def test_both_conventions_of_one_arm_have_the_same_lengths() -> None:
    modified = dh_rows(a=(0.0, 0.3, 1.0), alpha=(0.0, -RIGHT, 0.0), d=(0.7, 0.15, 0.2))

    assert link_lengths(modified, "modified") == link_lengths(STANDARD)


def test_axes_that_point_against_each_other_subtract() -> None:
    turned = dh_rows(a=(0.0, 1.0, 0.0), alpha=(RIGHT, math.pi, 0.0), d=(0.7, 0.3, 0.1))

    assert link_lengths(turned).lengths["along axes 2 to 3"] == pytest.approx(0.2)
