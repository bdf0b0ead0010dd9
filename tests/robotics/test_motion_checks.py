import dataclasses
import datetime as dt
import itertools
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import repro
from repro.errors import DeclarationError, InputError, ReproError
from repro.robotics import (
    DirectedSpline,
    MinimumTime,
    MinimumTimeSpline,
    PolynomialMotion,
    cubic,
    peak,
    quintic,
)
from repro.robotics.motion_checks import check_motion
from repro.robotics.rest_to_rest import motion, peaks
from repro.robotics.spline_motion import motion as spline_motion

GOOD: dict[str, Any] = {
    "velocity": (1.0, 2.0),
    "acceleration": (2.0, 3.0),
    "durations": (0.1, 9.0),
}
POINTS = ((0.0, 0.0), (1.0, -2.0), (1.5, 0.0))


def resting(**changed: object) -> MinimumTime:
    fields: dict[str, Any] = {"waypoints": POINTS, "law": quintic, **GOOD, **changed}
    return MinimumTime(**fields)


def spline(**changed: object) -> MinimumTimeSpline:
    fields: dict[str, Any] = {"nodes": POINTS, **GOOD, **changed}
    return MinimumTimeSpline(**fields)


def test_motion_that_can_be_passes() -> None:
    check_motion(((0.0, 1.0), (1.0, 1.0)), {"speed": (1.0, 2.0)}, (0.1, 0.1), called="points")


@pytest.mark.parametrize("limit", [0.0, -1.0, float("inf"), float("nan")])
def test_limit_that_cannot_be_is_refused(limit: float) -> None:
    fault = f"limits must be above 0 and finite: jerk of joint 1 is {limit}"
    with pytest.raises(DeclarationError, match=fault):
        check_motion(
            ((0.0,), (1.0,)), {"speed": (1.0,), "jerk": (limit,)}, (0.1, 9.0), called="points"
        )


@pytest.mark.parametrize("value", [float("inf"), float("nan")])
def test_points_are_named_as_the_problem_calls_them(value: float) -> None:
    fault = "nodes must be finite angles: joint 1 of number 2"
    with pytest.raises(DeclarationError, match=fault):
        check_motion(((0.0,), (value,)), {"speed": (1.0,)}, (0.1, 9.0), called="nodes")


@pytest.mark.parametrize("problem", [resting, spline])
def test_arrays_and_lists_are_taken_where_tuples_are_meant(problem: Any) -> None:  # noqa: ANN401
    name = "waypoints" if problem is resting else "nodes"
    for made in (np.array, list):
        own = problem(
            **{name: np.array(POINTS)},
            velocity=made((1.0, 2.0)),
            acceleration=made((2.0, 3.0)),
            durations=made((0.1, 9.0)),
        )

        assert own == problem()
        assert hash(own) == hash(problem())


def test_limit_of_the_jerk_may_be_an_array() -> None:
    assert resting(jerk=np.ones(2)) == resting(jerk=(1.0, 1.0))


SHARED = [
    ({"velocity": (1.0,)}, "number of joints: .* have 2, velocity has 1"),
    ({"velocity": 3.0}, "velocity: 3.0 is no list of numbers"),
    ({"velocity": (1.0, "fast")}, "velocity, number 2: 'fast' is no number"),
    ({"velocity": (1.0, None)}, "velocity, number 2: None is no number"),
    ({"velocity": (1.0, True)}, "velocity, number 2: True is no number"),
    ({"acceleration": (2.0, float("nan"))}, "acceleration of joint 2 is nan"),
    ({"durations": (0.1,)}, "durations .* 0 < shortest <= longest"),
    ({"durations": (9.0, 0.1)}, "durations .* 0 < shortest <= longest"),
    ({"durations": (-1.0, 0.1)}, "durations .* 0 < shortest <= longest"),
    ({"handling": "penalties"}, "handling 'penalties': known are feasibility first"),
]
OWN_POINTS = [
    ((), "a motion needs two or more, not 0"),
    (((1.0, 2.0),), "a motion needs two or more, not 1"),
    (((), ()), r"disagree on the number of joints: \[0\]"),
    (((0.0, 0.0), (1.0,)), r"disagree on the number of joints: \[1, 2\]"),
    (((0.0, 0.0), (1.0, float("inf"))), "joint 2 of number 2 is inf"),
    (((0.0, 0.0), (1.0, 1.0), (1.0, 1.0)), "2 and 3 are equal"),
    ("0 0 1 1", "is no list of points"),
    ((0.0, 1.0), "row 1: 0.0 is no list of numbers"),
]


@pytest.mark.parametrize("problem", [resting, spline])
@pytest.mark.parametrize(("changed", "fault"), SHARED)
def test_what_cannot_be_is_one_clear_error(
    problem: Any,  # noqa: ANN401
    changed: dict[str, object],
    fault: str,
) -> None:
    with pytest.raises(DeclarationError, match=fault) as raised:
        problem(**changed)
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize(("points", "fault"), OWN_POINTS)
def test_points_that_cannot_be_are_one_clear_error(points: object, fault: str) -> None:
    for problem, name in ((resting, "waypoints"), (spline, "nodes")):
        with pytest.raises(DeclarationError, match=f"{name}.*{fault}"):
            problem(**{name: points})


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"penalties": (1.0, 1.0)}, r"penalties \(1.0, 1.0\): there must be three, .* not 2"),
        ({"penalties": (1.0,) * 4}, "there must be three, .* not 4"),
        ({"penalties": (1.0, -1.0, 0.0)}, "must be 0 or more"),
        ({"weight": float("nan")}, "must be 0 or more"),
        ({"jerk": (1.0,)}, "jerk has 1"),
        ({"jerk": ()}, "jerk has 0"),
    ],
)
def test_penalties_weights_and_jerks_that_cannot_be_are_refused(
    changed: dict[str, object], fault: str
) -> None:
    with pytest.raises(DeclarationError, match=fault):
        resting(**changed)


@pytest.mark.parametrize("name", ["ends", "time_ends"])
def test_unknown_rule_for_the_ends_of_a_spline_is_refused(name: str) -> None:
    with pytest.raises(DeclarationError, match=f"^{name} 'free': known are repeated, natural"):
        spline(**{name: "free"})


@pytest.mark.parametrize("durations", [(5.0,), (-1.0, 2.0), (0.0, 1.0), (1.0, float("nan")), ()])
def test_durations_that_no_motion_has_are_refused(durations: tuple[float, ...]) -> None:
    asked = (
        lambda: peaks(resting(law=cubic), durations, 1),
        lambda: peak(resting(), durations, 2),
        lambda: motion(resting(), np.array(durations), derivative=0, samples=9),
        lambda: resting().obeys(np.array(durations)),
        lambda: spline_motion(spline(), np.array(durations), derivative=0, samples=9),
    )
    for ask in asked:
        with pytest.raises(InputError, match="a motion of 2 segments needs 2"):
            ask()


def test_durations_of_another_number_of_segments_have_no_peaks() -> None:
    with pytest.raises(InputError, match="the last side must be 2"):
        spline().peak_shares(np.ones((4, 3)))


def test_every_small_motion_is_made_or_refused_by_name() -> None:
    values = (0.0, 1.0, -1.0, float("nan"), float("inf"))
    made = 0
    for point, velocity, durations in itertools.product(
        itertools.product(values, repeat=2), values, itertools.product(values, repeat=2)
    ):
        try:
            resting(
                waypoints=[(point[0],), (point[1],)],
                velocity=[velocity],
                acceleration=[1.0],
                durations=durations,
            )
        except ReproError:
            continue
        made += 1
    assert made == 6  # two different finite points, velocity 1, durations (1, 1)


class Unspeakable:
    """What not even shows itself."""

    def __repr__(self) -> str:
        """Raise."""
        message = "no repr"
        raise RuntimeError(message)


HOSTILE: tuple[object, ...] = (
    *(None, True, 0, 3.0, -1, 10**400, 10**5000, 1e-300, float("nan"), float("inf"), 2 + 1j),
    *("fast", b"12", "", "still", object(), Unspeakable(), dict, {1: 2, 3: 4}, {1.0, 2.0}),
    *((), [], [[]], [1], [1.0, 2.0, 3.0], [10**400, 1], [1e-300, 1.0], [None, 1], ["1", "2"]),
    *([[1, 2], [3]], [[1, 2]] * 2, [[[1, 2]], [[3, 4]]], iter([1.0, 2.0]), itertools.count()),
    *(np.array(3.0), np.ones(2), np.ones((2, 2)), np.ones((2, 2, 2)), np.zeros((0, 2))),
    *(np.array(["a", "b"]), np.array([None, 1]), np.array([1j, 2]), np.ones(2, dtype=bool)),
    *(Fraction(10**400, 3), [Fraction(1, 10**400), 1], Decimal(1), [Decimal(1), Decimal(2)]),
    *(range(2), dt.timedelta(1), lambda *_: 1.0, quintic, type(quintic), 2**63, -(10**400)),
)
MADE: dict[type, dict[str, Any]] = {
    MinimumTime: {"waypoints": POINTS, "law": quintic, **GOOD},
    MinimumTimeSpline: {"nodes": POINTS, **GOOD},
    DirectedSpline: {
        "nodes": POINTS, "durations": (0.1, 9.0),
        "velocity": ((-1.0, 1.0),) * 2, "acceleration": ((-1.0, 2.0),) * 2,
    },
    PolynomialMotion: {
        "waypoints": POINTS, "degree": 5, "durations": (0.1, 9.0),
        "velocity": ((-1.0, 1.0),) * 2, "acceleration": ((-1.0, 1.0),) * 2,
    },
}  # fmt: skip


def fault(call: Callable[[], object]) -> str:
    """Return what is told of a call that is refused, nothing of one that is not."""
    try:
        call()
    except ReproError as error:
        return str(error) or "no word"
    return ""


@pytest.mark.parametrize("value", HOSTILE, ids=lambda value: type(value).__name__)
@pytest.mark.parametrize(
    ("kind", "name"),
    [(kind, field.name) for kind in MADE for field in dataclasses.fields(kind)],
    ids=lambda part: getattr(part, "__name__", part),
)
def test_whatever_a_field_holds_is_taken_or_one_clear_error(
    kind: type, name: str, value: object
) -> None:
    told = fault(lambda: kind(**{**MADE[kind], name: value}))
    if told:
        assert "\n" not in told
        assert len(told) < 300
        assert name.rstrip("s") in told or "number of joints" in told or "limits must be" in told
        return
    found = repro.certify(kind(**{**MADE[kind], name: value}), seconds=0.2)
    assert found.minimum is None or found.minimum > 0.0


@pytest.mark.parametrize("value", HOSTILE, ids=lambda value: type(value).__name__)
def test_whatever_a_call_holds_is_taken_or_one_clear_error(value: Any) -> None:  # noqa: ANN401
    told = [
        fault(lambda: repro.certify(value)),
        fault(lambda: repro.certify(resting(), seconds=value)),
        fault(lambda: repro.certify(resting(), title=value)),
        fault(lambda: resting().obeys(value)),
        fault(lambda: spline().obeys(value)),
    ]
    assert told[0]
    assert all("\n" not in each and len(each) < 300 for each in told)
