"""Mousa et al.: the arm of Table IV, and the real KUKA KR4 R600 beside it.

The real arm's axes are compared with the joints of Table IV by the poses of the flange: the chain
of the description file and the standard convention agree in every posture when the joint angles
are -A1, -A2, 90° - A3, -A4, -A5 and 180° - A6.
"""

import math

from papers.mousa2023.printed import ANGLES, TABLE_IV
from repro.robotics import dh_rows, freedoms
from repro.tables.published import PublishedTable

REAL_ARM = PublishedTable.read("""
    KUKA KR4 R600, github kroshu/kuka_robot_descriptions, kuka_agilus_support: kr4_r600_macro.xacro
    axis || least [deg] | greatest [deg] | speed [rad/s] | acceleration [rad/s^2]
    A1   || -170        | 170            | 5.864         | 29.22
    A2   || -195        | 40             | 5.864         | 9.951
    A3   || -115        | 150            | 8.508         | 19.95
    A4   || -185        | 185            | 10.472        | 30.07
    A5   || -120        | 120            | 9.235         | 35.24
    A6   || -350        | 350            | 13.963        | 76.66
""")

DH = dh_rows(a=TABLE_IV.column("a"), alpha=TABLE_IV.column("α"), d=TABLE_IV.column("d"))
START = ANGLES.column("start angles")
END = ANGLES.column("end angles")
_AT_ZERO = (0.0, 0.0, math.pi / 2, 0.0, 0.0, math.pi)  # joint angles of Table IV where A1…A6 are 0


def axis_angles(joints: tuple[float, ...]) -> tuple[float, ...]:
    """Return A1…A6 of the real arm for joint angles θ of Table IV, in rad."""
    return tuple(zero - angle for zero, angle in zip(_AT_ZERO, joints, strict=True))


def joint_angles(axes: tuple[float, ...]) -> tuple[float, ...]:
    """Return joint angles θ of Table IV for angles A1…A6 of the real arm, in rad."""
    return axis_angles(axes)  # zero less an angle, both ways


def axes_out_of_range(*postures: tuple[float, ...]) -> int:
    """Return how many axes of the real arm lie outside their range in any of the postures."""
    lowest, highest = REAL_ARM.column("least"), REAL_ARM.column("greatest")
    return sum(
        any(not low <= posture[axis] <= high for posture in postures)
        for axis, (low, high) in enumerate(zip(lowest, highest, strict=True))
    )


def reach() -> float:
    """Return how far the wrist centre of Table IV gets from the axis of joint 1, in m."""
    (_, _, _), (a2, _, _), (a3, _, _), (_, _, d4), *_ = DH
    return a2 + math.hypot(a3, d4)


def least_freedoms() -> int:
    """Return the degrees of freedom of Table IV at the start or the end, whichever has fewer."""
    return min(freedoms(DH, START), freedoms(DH, END))
