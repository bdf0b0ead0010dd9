"""Mousa et al.: what the pages say of the arm, the polynomials and the fits, checked by itself."""

import math
from collections import Counter
from collections.abc import Sequence

import numpy as np
import pytest

from papers.mousa2023 import (
    CUBIC,
    DH,
    DURATION,
    END,
    FIT,
    GA_BY_GENERATIONS,
    PAPER,
    POLYNOMIAL_CLAIMS,
    QUINTIC,
    REAL_ARM,
    SEPTIC,
    START,
    axes_out_of_range,
    axis_angles,
    box_about,
    greatest_jump,
    printed_curve,
    reach,
    search_claims,
    sensitive,
)
from repro.determinism.compiled import COST, ready
from repro.judge.findings import findings_of
from repro.judge.verdict import Verdict
from repro.model import Alternative, Assumption, Between, Claim, Sentence
from repro.robotics import MinimumTime, PathFitting, forward_kinematics, freedoms, quintic
from repro.runs.readings import readings
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
    assert np.abs(QUINTIC[1].nearest() * powers)[1:].max() == pytest.approx(0.15)
    told = assumption("bounds of the coefficients").because
    assert "is 30 rad, for joint 2 only 0.15 rad after the start angle" in told
    assert "on the septic path the best would be 64" in told


@pytest.mark.parametrize(("share", "centre"), [(2.0, 0.0), (0.1, 1.0)])
def test_bounds_about_the_best_coefficients_hold_them_and_leave_room_at_zero(
    share: float, centre: float
) -> None:
    for path in (*QUINTIC, *CUBIC, *SEPTIC):
        box = np.array(box_about(path, share, centre=centre))
        best = path.nearest() * DURATION ** np.arange(6)
        half = np.diff(box).ravel() / 2

        assert (box[:, 0] < best).all()
        assert (best < box[:, 1]).all()
        assert half[best != 0] == pytest.approx(share * np.abs(best[best != 0]))
        assert half[best == 0] == pytest.approx(share * abs(path.end - path.start))


def verdicts(claims: Sequence[Claim]) -> dict[str, Verdict]:
    """Return the verdict of each sentence that needs no run."""
    found = findings_of(claims, evidence_of(PAPER, {}))
    return {str(finding.claim): finding.verdict for finding in found}


def changed(name: str) -> Alternative:
    every = (each for own in PAPER.assumptions for each in own.alternatives)
    return next(each for each in every if each.name == name)


def test_polynomials_as_read_fail_only_where_they_shall_enlarge_a_change() -> None:
    found = verdicts(POLYNOMIAL_CLAIMS)
    failed = [claim for claim, verdict in found.items() if verdict is not Verdict.REPRODUCED]

    assert failed == ["a polynomial can be sensitive to its initial conditions"]
    assert Counter(found.values())[Verdict.REPRODUCED] == 13


@pytest.mark.parametrize(
    ("name", "verdict"),
    [
        ("greatest jerk of the polynomials", Verdict.CONTRADICTED),
        ("squared jerk of the polynomials", Verdict.CONTRADICTED),
        ("any change at all", Verdict.REPRODUCED),
        ("angles as θ", Verdict.CONTRADICTED),
    ],
)
def test_readings_of_sentences_on_polynomials_turn_them(name: str, verdict: Verdict) -> None:
    assert list(verdicts(changed(name).claims).values()) == [verdict]


def test_truths_by_definition_and_the_two_numbers_of_the_arm_are_not_counted() -> None:
    shown = [claim for claim in PAPER.claims if not claim.counts]

    assert [c.printed.text for c in shown if isinstance(c, Sentence) and not c.in_words] == [
        "6",
        "600",
    ]
    assert [c for c in PAPER.claims if c.counts and not getattr(c, "in_words", False)] == []
    assert len(shown) == 6


def test_cubic_changes_within_a_moment_by_no_more_than_its_slopes_let_it() -> None:
    # by hand: jerk 12 · 2 rad / 2³ s³ over 1e-9 s, acceleration and velocity being lower or alike
    assert greatest_jump("cubic") == pytest.approx(3e-9, rel=1e-3)


def test_no_condition_at_the_start_comes_out_larger_than_it_went_in() -> None:
    # shares of a change of angle, velocity and acceleration at the start, of the cubic and the
    # quintic of Eqs. (2) and (6), by hand, each in its own unit and the duration 1
    tau = np.linspace(0, 1, 1001)
    angle = 1 - 10 * tau**3 + 15 * tau**4 - 6 * tau**5
    velocity = 1 - 18 * tau**2 + 32 * tau**3 - 15 * tau**4
    acceleration = 1 - 9 * tau + 18 * tau**2 - 10 * tau**3
    cubics = 1 - 3 * tau**2 + 2 * tau**3, 1 - 4 * tau + 3 * tau**2

    for share in (angle, velocity, acceleration, *cubics):
        assert np.abs(share).max() == 1
    assert sensitive(Between(1 + 1e-9, 1e9)).claim in verdicts(POLYNOMIAL_CLAIMS)


def test_no_claim_names_a_reading_and_each_is_made_once() -> None:
    texts = [claim.claim for claim in PAPER.claims if isinstance(claim, Sentence)]

    assert len(set(texts)) == len(texts)
    assert not [t for t in texts if any(w in t for w in ("as told", "by generations", "mean "))]
    assert set(FIT.algorithms) == {"WOA", "GA"}


def test_fitness_is_convex_so_that_no_optimum_is_local_alone() -> None:
    fit = FIT.problems["joint 1"]
    cost, rng = ready(fit.kernel, COST), np.random.default_rng(1)
    for _ in range(100):
        first, second = (rng.uniform(fit.bounds[:, 0], fit.bounds[:, 1]) for _ in range(2))
        between = cost((first + second) / 2, fit.data)
        assert between <= (cost(first, fit.data) + cost(second, fit.data)) / 2


def test_lineage_by_generations_takes_the_place_of_ga_in_every_experiment() -> None:
    places = changed("GA by generations").algorithms

    assert places == {(e.name, "GA"): GA_BY_GENERATIONS for e in PAPER.experiments}


def test_whatever_changes_the_quintic_path_changes_it_where_its_start_shifts() -> None:
    for reading in readings(PAPER):
        names = {
            e.name
            for e in PAPER.experiments
            for alternative in reading.alternatives
            if e.name in alternative.protocol
            or any(name == e.name for name, _ in alternative.problems)
        }
        assert ("quintic path" in names) == ("shifted start" in names), reading.name


def test_points_of_every_range_have_their_place_in_it() -> None:
    ranges = {
        own.what: (own.at, [each.at for each in own.alternatives if each.at is not None])
        for own in PAPER.assumptions
        if own.open
    }

    assert ranges == {
        "duration of the motion": (2, []),
        "bounds of the coefficients": (50, [32, 500]),
        "number of points M": (100, [50, 200]),
        "population": (30, [20, 50, 100]),
        "iterations": (500, [200, 1000]),
    }


def test_means_take_the_place_of_medians_in_every_claim_on_the_searches() -> None:
    brought = changed("means of the runs").claims

    assert [c.claim for c in brought if isinstance(c, Sentence)] == [
        claim.claim for claim in search_claims()
    ]


@pytest.mark.parametrize(
    "place",
    ["abstract", "section IV", "section V", "section VI", *(f"Fig. {n}" for n in range(2, 7))],
)
def test_every_place_with_results_has_claims_or_gaps(place: str) -> None:
    places = [claim.where for claim in PAPER.claims] + [gap.where for gap in PAPER.gaps]
    ranges = {"Fig. 4": "Figs. 4 and 5"}

    assert any(place in where or ranges.get(place, place) in where for where in places)
