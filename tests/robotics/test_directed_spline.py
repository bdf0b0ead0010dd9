from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.errors import DeclarationError, InputError
from repro.robotics import DirectedSpline
from repro.robotics.spline_motion import motion
from tests.robotics.test_spline_motion import BACKWARDS, PROBLEM, QUICK, SLOW

Vector = NDArray[np.float64]
ALIKE = DirectedSpline(
    nodes=PROBLEM.nodes,
    velocity=((-1.0, 1.0), (-0.8, 0.8)),
    acceleration=((-2.0, 2.0), (-3.0, 3.0)),
    durations=PROBLEM.durations,
)
DIRECTED = replace(ALIKE, velocity=((-0.5, 1.0), (-0.8, 2.0)), acceleration=((-2.0, 1.0),) * 2)


@pytest.mark.parametrize("durations", [SLOW, QUICK])
def test_limits_alike_in_both_directions_have_the_shares_of_one_limit(durations: Vector) -> None:
    assert ALIKE.peak_shares(durations) == pytest.approx(PROBLEM.peak_shares(durations), rel=1e-12)
    assert ALIKE.widest == PROBLEM


@pytest.mark.parametrize("durations", [SLOW, QUICK])
def test_shares_are_the_peaks_of_dense_samples_over_the_limit_on_that_side(
    durations: Vector,
) -> None:
    expected = []
    for m, limits in ((1, DIRECTED.velocity), (2, DIRECTED.acceleration)):
        _, values = motion(DIRECTED.widest, durations, derivative=m, samples=5001)
        low, high = np.array(limits).T
        expected.append(np.maximum(values / low, values / high).max())

    assert DIRECTED.peak_shares(durations) == pytest.approx(expected, rel=1e-6)
    assert DIRECTED.obeys(durations) == (max(expected) <= 1.0)


def test_durations_with_which_time_runs_backwards_have_no_peaks() -> None:
    found = DIRECTED.peak_shares(np.stack([SLOW, BACKWARDS]))

    assert np.isfinite(found[0]).all()
    assert np.isposinf(found[1]).all()


def test_durations_of_another_number_of_segments_have_none_either() -> None:
    with pytest.raises(InputError, match="the last side must be 3"):
        DIRECTED.peak_shares(np.ones((2, 4)))


@pytest.mark.parametrize(
    ("pairs", "fault"),
    [
        (((-1.0, 1.0),), "nodes have 2, velocity has 1"),
        (((-1.0, 1.0), (0.0, 1.0)), r"velocity of joint 2: \(0.0, 1.0\) must be lowest < 0 < high"),
        (((-1.0, 1.0), (1.0,)), r"velocity of joint 2: \(1.0,\) must be lowest < 0 < highest"),
        (((-1.0, float("inf")),) * 2, "velocity of joint 1 is inf"),
        ((1.0, 2.0), "velocity, row 1: 1.0 is no list of numbers"),
    ],
)
def test_limits_are_a_pair_around_zero_for_each_joint(pairs: object, fault: str) -> None:
    with pytest.raises(DeclarationError, match=fault):
        replace(DIRECTED, velocity=pairs)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("jerk", "fault"),
    [
        (((-1.0, 1.0),), "nodes have 2, jerk has 1"),
        (((-1.0, 1.0), (0.0, 1.0)), r"jerk of joint 2: \(0.0, 1.0\) must be lowest < 0 < highest"),
        (((-1.0, 1.0), (-1.0, float("nan"))), r"jerk of joint 2: \(-1.0, nan\) must be lowest"),
        (((-1.0, float("inf")),) * 2, "jerk of joint 1 is inf"),
        (((-1.0, 1.0), (-1e-200, 1.0)), "jerk of joint 2: -1e-200 is beyond what is computed"),
        (((-1.0, 1.0), (-1.0, 1e200)), "jerk, row 2, number 2: 1e.200 is beyond what is computed"),
        ((1.0, 2.0), "jerk, row 1: 1.0 is no list of numbers"),
    ],
)
def test_jerk_that_cannot_be_is_refused_by_joint_and_value(jerk: object, fault: str) -> None:
    with pytest.raises(DeclarationError, match=fault):
        replace(DIRECTED, jerk=jerk)  # type: ignore[arg-type]


def test_jerk_may_be_an_array() -> None:
    limited = replace(DIRECTED, jerk=np.array([[-1.0, 2.0], [-3.0, 4.0]]))  # type: ignore[arg-type]

    assert limited.jerk == ((-1.0, 2.0), (-3.0, 4.0))
    assert hash(limited)
