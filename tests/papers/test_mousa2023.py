"""Mousa et al.: what the pages say of the arm, the polynomials and the fits, checked by itself."""

import math
from collections import Counter

import numpy as np
import pytest

from papers.mousa2023 import (
    ALGORITHMS,
    CUBIC,
    DH,
    DURATION,
    END,
    PAPER,
    POLYNOMIAL_CLAIMS,
    QUINTIC,
    REAL_ARM,
    SEPTIC,
    START,
    axes_out_of_range,
    axis_angles,
    printed_curve,
    reach,
    search_claims,
)
from repro.judge.findings import findings_of
from repro.judge.verdict import Verdict
from repro.model.claims import Sentence
from repro.model.paper import Assumption
from repro.robotics import MinimumTime, PathFitting, forward_kinematics, freedoms, quintic
from tests.small_papers import evidence_of

# The description of the real arm: roll, pitch, yaw in quarter turns and origin in m of A1 to A6,
# then of the flange (kuka_robot_descriptions, kr4_r600_macro.xacro).
CHAIN = (
    ((2, 0, 0), (0.0, 0.0, 0.1494)),
    ((1, 0, 0), (0.0, -0.0636, -0.1806)),
    ((0, 0, 0), (0.29, 0.0, -0.0046)),
    ((1, 0, -1), (0.1694, -0.02, -0.059)),
    ((0, 1, 1), (0.0, 0.045, -0.1406)),
    ((1, 0, -1), (0.0465, 0.0, -0.045)),
    ((2, 0, 2), (0.0, 0.0, -0.0285)),
)
RIGHT_ANGLES = tuple((a, math.copysign(math.pi / 2, alpha) * (alpha != 0), d) for a, alpha, d in DH)


def assumption(what: str) -> Assumption:
    return next(a for a in PAPER.assumptions if a.what == what)


def turn(axis: int, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    other = [i for i in range(3) if i != axis]
    matrix = np.eye(4)
    matrix[np.ix_(other, other)] = [[c, -s], [s, c]] if axis != 1 else [[c, s], [-s, c]]
    return matrix


def real_pose(axes: tuple[float, ...]) -> np.ndarray:
    """Return the flange of the real arm, by its description alone."""
    pose = np.eye(4)
    for (quarters, origin), angle in zip(CHAIN, (*axes, 0.0), strict=True):
        roll, pitch, yaw = (q * math.pi / 2 for q in quarters)
        step = turn(2, yaw) @ turn(1, pitch) @ turn(0, roll) @ turn(2, angle)
        step[:3, 3] = origin
        pose = pose @ step
    return pose


def test_angles_read_a_second_time_are_those_of_the_page() -> None:
    assert START == (-1.856, -1.73, -0.009, 3.1, -1.8, -0.30)  # Eq. (10)
    assert END == (-0.388, -1.74, 0.248, 1.50, -1.30, 1.7)  # Eq. (11)


def test_link_parameters_are_the_chain_of_the_real_arm_in_every_posture() -> None:
    rng = np.random.default_rng(1)
    for _ in range(20):
        joints = tuple(rng.uniform(-3, 3, 6))
        mine = forward_kinematics(RIGHT_ANGLES, joints)
        assert mine == pytest.approx(real_pose(axis_angles(joints)), abs=1e-12)


def test_right_angles_in_place_of_the_printed_ones_move_the_tool_by_less_than_a_millimetre() -> (
    None
):
    for posture in (START, END):
        printed, exact = (forward_kinematics(dh, posture)[:3, 3] for dh in (DH, RIGHT_ANGLES))
        assert 1e-5 < np.linalg.norm(printed - exact) < 1e-3


def test_arm_has_six_freedoms_in_the_standard_convention_and_five_in_the_modified() -> None:
    for posture in (START, END):
        assert freedoms(DH, posture, "standard") == 6
        assert freedoms(DH, posture, "modified") == 5


def test_reach_is_that_of_the_stretched_arm() -> None:
    radii = []
    for elbow in np.linspace(-math.pi, math.pi, 721):
        x, y, z = forward_kinematics(RIGHT_ANGLES[:4], [0.3, 0.0, elbow, 0.0])[:3, 3]
        radii.append(math.hypot(x, y, z - DH[0][2]))  # any shoulder angle can level it
    assert max(radii) == pytest.approx(reach(), abs=1e-5)


def test_postures_suit_the_real_arm_as_its_axes_and_not_as_joints_of_the_table() -> None:
    assert axes_out_of_range(START, END) == 0
    a2 = [math.degrees(axis_angles(posture)[1]) for posture in (START, END)]
    beyond = [angle - 40 for angle in a2]

    assert axes_out_of_range(axis_angles(START), axis_angles(END)) == 1
    assert min(beyond) > 59
    assert "59° beyond" in assumption("what the start and end angles are").because


def test_heights_of_the_tool_and_elbow_are_those_told() -> None:
    told = assumption("what the start and end angles are").because
    as_axes = [real_pose(posture)[2, 3] for posture in (START, END)]
    tools = [forward_kinematics(DH, posture)[2, 3] for posture in (START, END)]
    elbows = [forward_kinematics(DH[:2], posture[:2])[:3, 3] for posture in (START, END)]

    assert [f"{height:.2f}" for height in as_axes] == ["0.91", "0.95"]
    assert "0.91 m and 0.95 m high" in told
    assert [round(1000 * height) for height in tools] == [1, 3]
    assert "1 mm and 3 mm" in told
    assert [round(1000 * elbow[2]) for elbow in elbows] == [44, 44]
    assert max(math.hypot(*elbow[:2]) for elbow in elbows) < 0.05


def test_quintic_keeps_the_real_arm_s_limits_from_the_time_told() -> None:
    motion = MinimumTime(
        waypoints=(START, END),
        law=quintic,
        velocity=REAL_ARM.column("speed"),
        acceleration=REAL_ARM.column("acceleration"),
        durations=(0.1, 5.0),
    )

    (least,) = motion.shortest()

    assert 0.55 < least < 0.56
    assert "From 0.56 s on" in assumption("duration of the motion").because
    assert least < DURATION


@pytest.mark.parametrize(("name", "paths"), [("cubic", CUBIC), ("quintic", QUINTIC)])
def test_printed_coefficients_are_those_of_the_law(
    name: str, paths: tuple[PathFitting, ...]
) -> None:
    for path in paths:
        curve = printed_curve(name, path)
        law = path.coefficients
        assert np.pad(curve, (0, 6 - len(curve))) == pytest.approx(law, abs=1e-12)


def test_bounds_hold_what_is_told_of_them() -> None:
    powers = DURATION ** np.arange(6)
    quintics = [np.abs(path.nearest() * powers).max() for path in QUINTIC]
    septics = [np.abs(path.nearest() * powers).max() for path in SEPTIC]

    assert round(max(quintics)) == 30
    assert round(max(septics)) == 64
    assert all(path.allows(path.nearest()) for path in QUINTIC)


def test_verdicts_on_the_polynomials_need_no_run() -> None:
    found = findings_of(POLYNOMIAL_CLAIMS, evidence_of(PAPER, {}))
    verdicts = {finding.claim: finding.verdict for finding in found}
    contradicted = {claim for claim, verdict in verdicts.items() if verdict != Verdict.REPRODUCED}

    assert Counter(verdicts.values()) == {Verdict.REPRODUCED: 12, Verdict.CONTRADICTED: 4}
    assert sum("jerk between the ends" in str(claim) for claim in contradicted) == 2
    assert sum("sensitive" in str(claim) for claim in contradicted) == 1
    assert sum("θ of Table IV" in str(claim) for claim in contradicted) == 1


def test_every_comparison_with_ga_is_made_for_both_lineages() -> None:
    claims = [claim.claim for claim in search_claims() if isinstance(claim, Sentence)]
    told = sorted(c.replace("GA as told", "GA") for c in claims if "GA as told" in c)
    other = sorted(c.replace("GA by generations", "GA") for c in claims if "GA by gen" in c)

    assert told == other
    assert len(told) == 14
    assert set(ALGORITHMS) == {"WOA", "GA", "GA by generations"}


@pytest.mark.parametrize(
    "place",
    ["abstract", "section IV", "section V", "section VI", *(f"Fig. {n}" for n in range(2, 7))],
)
def test_every_place_with_results_has_claims_or_gaps(place: str) -> None:
    places = [claim.where for claim in PAPER.claims] + [gap.where for gap in PAPER.gaps]
    ranges = {"Fig. 4": "Figs. 4 and 5"}

    assert any(place in where or ranges.get(place, place) in where for where in places)
