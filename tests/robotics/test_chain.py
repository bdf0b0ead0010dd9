import importlib.util
import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.errors import InputError
from repro.robotics import Convention, forward_kinematics
from repro.robotics.chain import from_dh
from repro.robotics.urdf import read_urdf

PANDA = Path(__file__).parents[1] / "motions" / "panda.urdf"
needs_yourdfpy = pytest.mark.skipif(
    importlib.util.find_spec("yourdfpy") is None, reason="the extra `urdf` is not installed"
)
# a, alpha, d, theta offset of the Panda in the modified convention, as its maker prints them
CRAIG = [
    (0, 0, 0.333, 0), (0, -math.pi / 2, 0, 0), (0, math.pi / 2, 0.316, 0),
    (0.0825, math.pi / 2, 0, 0), (-0.0825, -math.pi / 2, 0.384, 0), (0, math.pi / 2, 0, 0),
    (0.088, math.pi / 2, 0, 0), (0, 0, 0.107, 0),
]  # fmt: skip
ROW = st.tuples(st.floats(-1, 1), st.floats(-3, 3), st.floats(-1, 1), st.floats(-3, 3))


@given(st.lists(st.tuples(ROW, st.floats(-3, 3)), min_size=1, max_size=5))
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_chain_of_a_table_ends_where_its_forward_kinematics_do(
    convention: Convention, joints: list[tuple[tuple[float, ...], float]]
) -> None:
    rows, q = [row for row, _ in joints], [angle for _, angle in joints]
    chain = from_dh(rows, ["revolute"] * len(rows), convention)

    tool = forward_kinematics(rows, q, convention)[:3, 3]
    assert chain.corners(q)[-1] == pytest.approx(tool, abs=1e-9)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_prismatic_joint_adds_to_d(convention: Convention) -> None:
    rows = [(0.3, 1.0, 0.2, 0.4), (0.1, -0.5, 0.6, 0.2)]
    longer = [rows[0], (0.1, -0.5, 0.6 + 0.25, 0.2)]
    chain = from_dh(rows, ["revolute", "prismatic"], convention)

    tool = forward_kinematics(longer, [0.7, 0.0], convention)[:3, 3]
    assert chain.corners([0.7, 0.25])[-1] == pytest.approx(tool, abs=1e-12)


def test_joint_of_another_kind_is_refused() -> None:
    with pytest.raises(InputError, match="'screw': known are revolute, prismatic"):
        from_dh([(0, 0, 0, 0)], ["screw"], "standard")


@needs_yourdfpy
def test_description_and_table_of_the_panda_are_one_arm() -> None:
    chain, limits = read_urdf(PANDA)
    rng = np.random.default_rng(1)

    for q in rng.uniform(-1.5, 1.5, (20, 7)):
        tool = forward_kinematics(CRAIG, [*q, 0.0], "modified")[:3, 3]
        assert chain.corners(q)[-1] == pytest.approx(tool, abs=1e-9)
    assert limits["velocity"][6] == (-2.61, 2.61)
    assert limits["range"][3] == (-3.0718, -0.0698)
    assert [joint.name for joint in chain.joints] == [f"panda_joint{k}" for k in range(1, 8)]


def described(folder: Path, joints: str) -> Path:
    path = folder / "arm.urdf"
    links = "".join(f'<link name="{name}"/>' for name in "abcd")
    path.write_text(f'<robot name="arm">{links}{joints}</robot>', encoding="utf-8")
    return path


def joint(name: str, kind: str, parent: str, child: str, more: str = "") -> str:
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f"{more}</joint>"
    )


@needs_yourdfpy
def test_prismatic_and_continuous_joints_of_a_description(tmp_path: Path) -> None:
    path = described(
        tmp_path,
        joint("turn", "continuous", "a", "b", '<axis xyz="0 0 2"/>')
        + joint(
            "slide", "prismatic", "b", "c",
            '<origin xyz="0.5 0 0"/><axis xyz="1 0 0"/>'
            '<limit lower="0" upper="0.3" velocity="0.2" effort="1"/>',
        ),
    )  # fmt: skip
    chain, limits = read_urdf(path)

    assert chain.corners([math.pi / 2, 0.1])[-1] == pytest.approx([0, 0.6, 0], abs=1e-12)
    assert set(limits) == {"range"}  # the joint that turns has no velocity
    assert limits["range"] == ((-math.inf, math.inf), (0.0, 0.3))


@needs_yourdfpy
@pytest.mark.parametrize(
    ("joints", "fault"),
    [
        (joint("one", "fixed", "a", "b"), "no joint of it moves"),
        (
            joint("one", "continuous", "a", "b") + joint("two", "continuous", "a", "c"),
            "is no single chain: two move beside one",
        ),
        (
            joint("one", "continuous", "a", "b") + joint("two", "continuous", "b", "a"),
            "is no chain: joint (one|two) comes back to itself",
        ),
        (
            joint("one", "floating", "a", "b") + joint("two", "continuous", "b", "c"),
            "joint one is floating: an arm's are revolute, continuous, prismatic, fixed",
        ),
        (
            joint("one", "continuous", "a", "b")
            + joint("two", "continuous", "b", "c", '<mimic joint="one"/>')
            + joint("three", "continuous", "c", "d"),
            "joint two mimics one: it does not move by itself",
        ),
        (joint("one", "continuous", "a", "b", '<axis xyz="0 0 0"/>'), "axis of joint one is 0"),
        ("<joint", "is no URDF"),
    ],
)
def test_what_is_no_single_arm_is_refused(
    joints: str, fault: str, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    with pytest.raises(InputError, match=fault) as raised:
        read_urdf(described(tmp_path, joints))
    assert "\n" not in str(raised.value)
    assert caplog.text == ""  # the parser's own words, which would stand beside the one line


@needs_yourdfpy
def test_entities_that_grow_are_not_unfolded(tmp_path: Path) -> None:
    path = tmp_path / "bomb.urdf"
    grown = "".join(f'<!ENTITY {b} "{10 * f"&{a};"}">' for a, b in pairwise("abcdefghij"))
    path.write_text(f'<!DOCTYPE r [<!ENTITY a "ha">{grown}]><robot name="r">&j;</robot>')

    with pytest.raises(InputError, match=r"bomb\.urdf: "):
        read_urdf(path)
