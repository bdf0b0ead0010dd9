from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.optimisers import DE, SMA, WOA, Optimiser
from repro.robotics import MinimumTimeSpline
from repro.robotics.bsplines import Ends
from repro.robotics.proofs.limit_rows import Cut, exact
from repro.robotics.proofs.spline_minimum import _obeys, prove
from repro.robotics.spline_motion import motion
from tests.robotics.test_spline_motion import PROBLEM

Vector = NDArray[np.float64]
LIGHT = replace(PROBLEM, acceleration=(1e3, 1e3), durations=(0.01, 100.0))
HEAVY = replace(LIGHT, acceleration=(0.2, 0.2))
LINE = replace(LIGHT, nodes=((0.0, 0.0), (3.0, 1.0)), ends="natural", time_ends="natural")


def peak(problem: MinimumTimeSpline, durations: Vector, derivative: int) -> float:
    """Return the greatest share of a limit among dense samples."""
    _, values = motion(problem, durations, derivative=derivative, samples=3001)
    return float((abs(values) / problem.limits[derivative - 1]).max())


def test_straight_line_takes_the_time_of_its_slowest_joint() -> None:
    proof = prove(LINE)

    assert proof.lower_bound <= 3
    assert float(proof.lower_bound) == pytest.approx(3, rel=1e-12)
    assert proof.attained == pytest.approx(3, abs=1e-6)


def test_bound_and_motion_are_a_microsecond_apart_where_accelerations_are_slack() -> None:
    proof = prove(LIGHT)

    assert 0 < proof.attained - proof.lower_bound < Fraction(1, 10**5)
    assert proof.acceleration_share < 0.1


@pytest.mark.parametrize("problem", [LIGHT, HEAVY, replace(LIGHT, ends="still")])
def test_proved_motion_keeps_both_limits_at_dense_samples(problem: MinimumTimeSpline) -> None:
    durations = np.array(prove(problem).durations, dtype=np.float64)

    assert peak(problem, durations, 1) < 1
    assert peak(problem, durations, 2) < 1


def test_a_slightly_shorter_motion_breaks_a_velocity_limit() -> None:
    durations = np.array(prove(LIGHT).durations, dtype=np.float64)

    assert peak(LIGHT, 0.999 * durations, 1) > 1


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_motion_that_breaks_a_limit_in_one_direction_is_not_proved(sign: float) -> None:
    line = replace(LINE, nodes=((0.0, 0.0), (3.0 * sign, sign)))
    model, proof = exact(line), prove(line)
    shorter = tuple(h * Fraction(999, 1000) for h in proof.durations)

    assert _obeys(model, proof.durations)
    assert not _obeys(model, shorter)


@pytest.mark.parametrize("optimiser", [WOA(), SMA(), DE()], ids=repr)
@pytest.mark.parametrize("problem", [LIGHT, HEAVY], ids=["light", "heavy"])
def test_no_search_beats_the_bound(problem: MinimumTimeSpline, optimiser: Optimiser) -> None:
    for seed in range(5):
        found = optimiser.minimise(
            problem, population=20, iterations=60, rng=np.random.default_rng(seed)
        )
        assert problem.quantity("total", found.x) >= float(prove(problem).lower_bound)


def test_search_comes_close_to_the_proved_minimum() -> None:
    found = SMA().minimise(LIGHT, population=50, iterations=200, rng=np.random.default_rng(1))

    assert found.cost == pytest.approx(float(prove(LIGHT).attained), rel=1e-3)


def test_bound_is_the_linear_programme_of_dense_samples() -> None:
    proof = prove(LIGHT)
    cuts = [limit for limit in proof.holding if isinstance(limit, Cut)]
    weights = np.array([cut.weights for cut in cuts], dtype=np.float64)
    least = np.array([cut.least for cut in cuts], dtype=np.float64)
    durations = np.array(proof.durations, dtype=np.float64)

    # the cuts are tight at the optimum, and a combination of them is the objective
    assert weights @ durations == pytest.approx(least, abs=1e-5)
    multipliers = np.linalg.lstsq(weights.T, np.ones(3), rcond=None)[0]
    assert (multipliers >= 0).all()
    assert multipliers @ least == pytest.approx(float(proof.lower_bound), rel=1e-12)


def test_limit_that_holds_at_an_inner_node_is_not_counted_twice() -> None:
    even = replace(LINE, nodes=((0.0, 0.0), (3.0, 1.0), (6.0, 2.0), (9.0, 3.0)))

    proof = prove(even)

    assert float(proof.lower_bound) == pytest.approx(9)
    assert len(proof.holding) <= 3


@pytest.mark.parametrize("ends", ["repeated", "still", "natural"])
def test_minimum_is_proved_where_accelerations_bite(ends: Ends) -> None:
    proof = prove(replace(HEAVY, ends=ends))

    assert 0 <= proof.attained - proof.lower_bound < Fraction(1, 10**4)
    assert proof.attained > prove(replace(LIGHT, ends=ends)).attained + 1
    assert proof.acceleration_share == pytest.approx(1, abs=1e-5)
    assert proof.boxes > 0


def test_only_velocities_hold_a_motion_whose_accelerations_are_slack() -> None:
    assert prove(LIGHT).boxes == 0
    assert {type(limit) for limit in prove(LIGHT).holding} == {Cut}
