import importlib.util
from dataclasses import replace

import pytest

from repro.judge.outside_planners import outside_references, ruckig_time, toppra_time
from repro.robotics.fastest import fastest
from tests.doe2021 import ARM, PAPER

ABSENT = [name for name in ("ruckig", "toppra") if importlib.util.find_spec(name) is None]
needs_planners = pytest.mark.skipif(
    bool(ABSENT), reason=f"not installed: {', '.join(ABSENT)}; see nox -s references"
)


@pytest.mark.skipif(not ABSENT, reason="the planners are installed")
def test_a_planner_that_is_absent_is_skipped_with_its_reason() -> None:
    for row in outside_references([PAPER]):
        assert row.time is None
        assert "pip install" in row.skipped


@needs_planners
@pytest.mark.parametrize("jerk", [None, (30.0, 30.0)])
def test_the_least_time_of_any_curve_is_the_one_that_ruckig_finds(
    jerk: tuple[float, ...] | None,
) -> None:
    problem = replace(ARM, jerk=jerk)
    limit = jerk[0] if jerk else float("inf")
    own = max(
        fastest(distance, velocity=1.25, acceleration=9.0, jerk=limit)
        for distance in problem.distances[0]
    )
    assert ruckig_time(problem) == pytest.approx(own, rel=1e-9)


@needs_planners
def test_no_polynomial_beats_the_least_time_of_any_curve() -> None:
    assert ruckig_time(ARM) < ARM.shortest().sum()


@needs_planners
def test_one_straight_segment_takes_toppra_as_long_as_ruckig() -> None:
    assert toppra_time(ARM) == pytest.approx(ruckig_time(ARM), rel=1e-2)
