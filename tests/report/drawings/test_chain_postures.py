import numpy as np
import pytest

from repro.report.drawings.chain_postures import postures
from repro.robotics.chain import Chain, Joint, from_dh
from repro.robotics.kinematics import Convention
from repro.robotics.skeleton import skeleton

# rows (a, alpha, d, theta offset), in m and rad
TABLE = [(0.1, 0.3, 0.4, 0.0), (0.5, -1.2, 0.1, 0.7), (0.0, 1.5, 0.6, 0.0), (0.2, 0.4, -0.1, 0.1)]
ANGLES = np.random.default_rng(5).uniform(-3, 3, (20, 4))


def bends(corners: np.ndarray) -> np.ndarray:
    """Return the corners without those that stand where the one before stands, or on its way."""
    kept = [corners[0]]
    for corner, after in zip(corners[1:], [*corners[2:], corners[-1]], strict=True):
        way, on = corner - kept[-1], after - corner
        if np.linalg.norm(np.cross(way, on)) > 1e-9 or corner is after:
            kept.append(corner)
    return np.array([*kept, corners[-1]])


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_chain_of_a_table_bends_where_its_skeleton_does(convention: Convention) -> None:
    chain = from_dh(TABLE, ["revolute"] * 4, convention)

    for q, made in zip(ANGLES, postures(chain, ANGLES), strict=True):
        expected = skeleton(TABLE, q, convention)
        np.testing.assert_allclose(made.axes, expected.axes, atol=1e-12)
        np.testing.assert_allclose(made.joints, expected.joints, atol=1e-12)
        np.testing.assert_allclose(bends(made.corners), bends(expected.corners), atol=1e-12)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_joint_that_slides_lengthens_its_link_along_its_axis(convention: Convention) -> None:
    kinds = ["revolute", "revolute", "prismatic", "revolute"]
    chain = from_dh(TABLE, kinds, convention)

    for q, made in zip(ANGLES, postures(chain, ANGLES), strict=True):
        a, alpha, d, offset = TABLE[2]
        slid = [*TABLE[:2], (a, alpha, d + q[2], offset), TABLE[3]]
        expected = skeleton(slid, q * [1, 1, 0, 1], convention)
        np.testing.assert_allclose(bends(made.corners), bends(expected.corners), atol=1e-12)


def test_link_whose_ends_are_on_no_common_normal_is_straight() -> None:
    """As in a robot's description, whose frames stand anywhere on the joints' axes."""
    before = np.eye(4)
    before[:3, 3] = 0.3, 0.2, 0.5
    turned = np.array([[0.6, 0, 0.8, 0.3], [0, 1, 0, 0.1], [-0.8, 0, 0.6, 0.4], [0, 0, 0, 1]])
    up = (0.0, 0.0, 1.0)
    joints = [
        Joint(name=name, kind="revolute", before=tuple(map(tuple, pose.tolist())), axis=up)
        for name, pose in (("pan", before), ("tilt", turned))
    ]
    chain = Chain(joints=tuple(joints), tool=tuple(map(tuple, np.eye(4).tolist())))
    (made,) = postures(chain, np.zeros((1, 2)))

    assert made.axes.tolist() == [[0, 0, 1], pytest.approx([0.8, 0, 0.6])]
    np.testing.assert_allclose(bends(made.corners)[-2:], [[0.3, 0.2, 0.5], [0.6, 0.3, 0.9]])
