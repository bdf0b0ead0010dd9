import importlib.util
import sys
from dataclasses import replace
from types import SimpleNamespace

import pytest

from repro.judge.outside_planners import (
    NoAnswerError,
    _check_profile,
    outside_references,
    references_of,
    ruckig_time,
    toppra_path_time,
    toppra_time,
)
from repro.robotics import MinimumTime, MinimumTimeSpline, cubic
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


@needs_planners
def test_far_motion_whose_jerk_binds_is_answered_or_refused_by_name() -> None:
    far = MinimumTime(
        waypoints=((0.0,), (51_002.0,)), law=cubic,
        velocity=(1.0,), acceleration=(2.718,), jerk=(1.0,), durations=(0.1, 1e6),
    )  # fmt: skip
    (ruckig, toppra) = references_of(far, paper="", name="far")

    own = fastest(51_002.0, velocity=1.0, acceleration=2.718, jerk=1.0)
    assert ruckig.time == pytest.approx(own, rel=1e-9) or "ruckig" in ruckig.skipped
    assert toppra.time is not None or "toppra" in toppra.skipped


def failing(answer: object) -> SimpleNamespace:
    """Return a module like ruckig's that answers so, or raises it."""

    def calculate(*_: object) -> object:
        if isinstance(answer, Exception):
            raise answer
        return answer

    return SimpleNamespace(
        InputParameter=lambda _: SimpleNamespace(),
        Trajectory=lambda _: SimpleNamespace(),
        Result=SimpleNamespace(Working=0, Finished=1),
        Ruckig=lambda _: SimpleNamespace(calculate=calculate),
    )


class OwnError(Exception):
    """What a planner raises that is no kind of Python's."""


@pytest.mark.parametrize(
    "answer", [-100, ValueError("no\nroot"), RuntimeError("no root"), OwnError("\n" * 99)]
)
def test_what_ruckig_says_of_its_failure_is_looked_at(
    answer: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ruckig", failing(answer))

    row = references_of(ARM, paper="", name="arm")[0]

    assert row.time is None
    assert row.skipped.startswith("ruckig has no motion for segment 1: ")
    assert "\n" not in row.skipped


def profile(**changed: object) -> SimpleNamespace:
    """Return ruckig's motion over 5 rad under limits of 1, as it gives it."""
    given = {
        "t": [1.0, 0.0, 1.0, 3.0, 1.0, 0.0, 1.0],
        "j": [1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0],
        "v": [0.0, 0.5, 0.5, 1.0, 1.0, 0.5, 0.5, 0.0],
        "a": [0.0, 1.0, 1.0, 0.0, 0.0, -1.0, -1.0, 0.0],
        "p": [0.0, 1 / 6, 1 / 6, 1.0, 4.0, 29 / 6, 29 / 6, 5.0],
    }
    return SimpleNamespace(**{**given, **changed})


@pytest.mark.parametrize(
    "changed",
    [
        {"v": [0.0, 0.5, 0.5, 1.01, 1.0, 0.5, 0.5, 0.0]},
        {"a": [0.0, 1.2, 1.0, 0.0, 0.0, -1.0, -1.0, 0.0]},
        {"j": [1.0, 0.0, -3.0, 0.0, -1.0, 0.0, 1.0]},
        {"p": [0.0, 1 / 6, 1 / 6, 1.0, 4.0, 29 / 6, 29 / 6, 4.9]},
        {"v": [0.0, 0.5, 0.9, 0.9, 1.0, 0.5, 0.5, 0.0], "a": [0.0, 1.0, 1.0, -1.0, 0, 0, 0, 0]},
    ],
)
def test_motion_of_ruckig_that_breaks_a_limit_is_not_shown(changed: dict[str, object]) -> None:
    straight = MinimumTime(
        waypoints=((0.0,), (5.0,)), law=cubic,
        velocity=(1.0,), acceleration=(1.0,), jerk=(1.0,), durations=(0.1, 99.0),
    )  # fmt: skip
    _check_profile(straight, 0, 0, profile())

    with pytest.raises(NoAnswerError, match="joint 1 in segment 1 is none"):
        _check_profile(straight, 0, 0, profile(**changed))


STRAIGHT = MinimumTimeSpline(
    nodes=((0.0, 0.0), (0.5, 0.25), (1.0, 0.5)),
    velocity=(1.25, 1.25),
    acceleration=(9.0, 9.0),
    durations=(0.1, 9.0),
)


@needs_planners
def test_along_a_straight_path_toppra_takes_the_least_time_of_the_slowest_joint() -> None:
    least = fastest(1.0, velocity=1.25, acceleration=9.0)

    assert toppra_path_time(STRAIGHT) == pytest.approx(least, rel=1e-2)


def test_of_a_spline_toppra_alone_is_asked_on_the_path_of_the_paper() -> None:
    (row,) = references_of(STRAIGHT, paper="key", name="motion/arm")

    assert row.planner == "toppra"
    assert "the paper's own B-spline in the angles" in row.what
    assert (row.time is None) == bool(row.skipped)


def test_whatever_a_planner_raises_is_a_reason_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    def raising(_: MinimumTimeSpline) -> float:
        """Time of nothing, in s."""
        raise OwnError("no\n" * 999)

    monkeypatch.setattr("repro.judge.outside_planners.toppra_path_time", raising)
    (row,) = references_of(STRAIGHT, paper="key", name="motion/arm")

    assert row.skipped.startswith("it raises OwnError: ")
    assert "\n" not in row.skipped
    assert len(row.skipped) < 200
