import math
from dataclasses import replace
from itertools import pairwise
from typing import Literal

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError
from repro.robotics import MinimumTime, RestToRestLaw, cubic, peak, quintic, septic
from repro.robotics.rest_to_rest import motion, peaks

Vector = NDArray[np.float64]

LAWS = st.sampled_from([cubic, quintic, septic, RestToRestLaw(9)])
LIMIT = st.floats(0.2, 20.0)


@st.composite
def problems(
    draw: st.DrawFn, handling: Literal["feasibility first", "penalty"] = "feasibility first"
) -> MinimumTime:
    """Draw a motion of one to three joints in one to three segments, none of them at rest."""
    joints, segments = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    limits = st.tuples(*[LIMIT] * joints)
    points = st.tuples(*[st.floats(-3.0, 3.0)] * joints)
    waypoints = draw(st.lists(points, min_size=segments + 1, max_size=segments + 1))
    assume(all(start != end for start, end in pairwise(waypoints)))
    problem = MinimumTime(
        waypoints=tuple(waypoints),
        law=draw(LAWS),
        velocity=draw(limits),
        acceleration=draw(limits),
        jerk=draw(st.none() | limits),
        durations=(0.01, 500.0),
        handling=handling,
        weight=draw(st.floats(0.1, 1000.0)),
    )
    assume((problem.distances.max(axis=1) > 0.01).all())
    return problem


TWO = MinimumTime(
    waypoints=((0.0, 0.0), (1.0, -2.0), (1.5, 0.0)),
    law=quintic,
    velocity=(1.0, 2.0),
    acceleration=(2.0, 3.0),
    durations=(0.1, 9.0),
)


def cost(problem: MinimumTime, durations: Vector) -> float:
    return float(ready(problem.kernel, COST)(np.array(durations, dtype=float), problem.data))


def shares(problem: MinimumTime, durations: Vector) -> list[float]:
    """Return peak over limit of every segment, derivative and joint, in plain Python."""
    found = []
    limits = (problem.velocity, problem.acceleration, problem.jerk)
    for time, start, end in zip(
        durations, problem.waypoints[:-1], problem.waypoints[1:], strict=True
    ):
        for m, kind in enumerate(limits, start=1):
            for a, b, limit in zip(start, end, kind or (math.inf,) * len(start), strict=True):
                found.append(problem.law.peak_factor(m) * abs(b - a) / time**m / limit)
    return found


def plain_cost(problem: MinimumTime, durations: Vector) -> float:
    excess = sum(max(share - 1.0, 0.0) for share in shares(problem, durations))
    total = math.fsum(durations)
    longest = len(durations) * problem.durations[1]
    if excess == 0.0:
        return total
    return {
        "feasibility first": longest + excess,
        "penalty": total + problem.weight * excess,
        "rejection": longest + 1.0,
    }[problem.handling]


def random_durations(problem: MinimumTime, seed: int) -> Vector:
    factors = np.random.default_rng(seed).choice([0.5, 0.9, 1.1, 2.0], problem.segments)
    return np.asarray(problem.shortest() * factors)


@pytest.mark.parametrize("handling", ["feasibility first", "penalty", "rejection"])
@given(problem=problems(), seed=st.integers(0, 99))
def test_compiled_cost_is_that_of_plain_python(
    handling: Literal["feasibility first", "penalty", "rejection"], problem: MinimumTime, seed: int
) -> None:
    problem = replace(problem, handling=handling)
    durations = random_durations(problem, seed)

    assert cost(problem, durations) == pytest.approx(plain_cost(problem, durations), rel=1e-12)


@given(problems(), st.integers(0, 99), st.integers(0, 99))
def test_motion_that_breaks_a_limit_costs_more_than_every_one_that_obeys(
    problem: MinimumTime, seed: int, other: int
) -> None:
    breaking, obeying = random_durations(problem, seed), random_durations(problem, other)
    breaking[0] = 0.9 * problem.shortest()[0]
    obeying = np.maximum(obeying, 1.001 * problem.shortest())

    assert cost(problem, breaking) > cost(problem, np.full(problem.segments, 500.0))
    assert cost(problem, breaking) > cost(problem, obeying)
    assert cost(problem, obeying) == pytest.approx(obeying.sum())


@given(problems())
def test_motion_that_breaks_limits_by_more_costs_more(problem: MinimumTime) -> None:
    shortest = problem.shortest()

    costs = [cost(problem, share * shortest) for share in (0.99, 0.9, 0.5, 0.1)]

    assert costs == sorted(costs)
    assert len(set(costs)) == 4


@given(problems())
def test_shortest_motion_keeps_every_limit_and_a_faster_one_does_not(problem: MinimumTime) -> None:
    limits = problem.limits

    def broken(durations: Vector) -> bool:
        return any(
            bool((np.abs(sampled(problem, durations, m)) > limits[m - 1] * (1 + 1e-9)).any())
            for m in (1, 2, 3)
        )

    assert not broken(problem.shortest())
    for k in range(problem.segments):
        faster = problem.shortest()
        faster[k] *= 0.999
        assert broken(faster)


def sampled(problem: MinimumTime, durations: Vector, derivative: int) -> Vector:
    """Return joint values at many times, among them the middle, where odd derivatives peak."""
    return motion(problem, durations, derivative=derivative, samples=4001)[1]


@given(problems(), st.floats(0.1, 10.0))
def test_time_goes_with_the_inverse_of_a_velocity_limit(problem: MinimumTime, by: float) -> None:
    # with the other limits out of reach
    free = replace(problem, acceleration=(1e9,) * len(problem.velocity), jerk=None)
    relaxed = replace(free, velocity=tuple(by * limit for limit in free.velocity))

    assert relaxed.shortest() * by == pytest.approx(free.shortest(), rel=1e-9)


@given(problems(), st.floats(0.1, 10.0))
def test_time_goes_with_the_inverse_root_of_an_acceleration_limit(
    problem: MinimumTime, by: float
) -> None:
    free = replace(problem, velocity=(1e9,) * len(problem.velocity), jerk=None)
    relaxed = replace(free, acceleration=tuple(by * limit for limit in free.acceleration))

    assert relaxed.shortest() * math.sqrt(by) == pytest.approx(free.shortest(), rel=1e-9)


@given(problems(), st.floats(0.5, 2.0))
def test_motion_slowed_down_as_a_whole_keeps_limits_that_fall_with_its_powers(
    problem: MinimumTime, by: float
) -> None:
    slow = replace(
        problem,
        velocity=tuple(limit / by for limit in problem.velocity),
        acceleration=tuple(limit / by**2 for limit in problem.acceleration),
        jerk=problem.jerk and tuple(limit / by**3 for limit in problem.jerk),
    )

    assert slow.shortest() == pytest.approx(by * problem.shortest(), rel=1e-9)


@given(problems())
def test_motion_back_takes_as_long_as_the_motion_there(problem: MinimumTime) -> None:
    back = replace(problem, waypoints=problem.waypoints[::-1])

    assert back.shortest() == pytest.approx(problem.shortest()[::-1])


def test_no_jerk_limit_is_a_jerk_limit_out_of_reach() -> None:
    assert np.isinf(TWO.limits[2]).all()
    assert TWO.shortest() == pytest.approx(replace(TWO, jerk=(1e99, 1e99)).shortest())


def test_shortest_durations_are_those_worked_out_by_hand() -> None:
    # joint 2 moves 2 rad in both: 15/8 · 2 / 2 = 1.875 s for its velocity,
    # sqrt(10/sqrt(3) · 2 / 3) = 1.962 s for its acceleration
    by_acceleration = math.sqrt(10 / math.sqrt(3) * 2 / 3)

    assert TWO.shortest() == pytest.approx([by_acceleration, by_acceleration])
    assert TWO.times_to_keep()[0, 0] == pytest.approx([15 / 8, 15 / 8])


def test_peaks_are_those_of_the_samples() -> None:
    durations = (1.5, 2.5)

    for m in (1, 2, 3):
        greatest = np.abs(sampled(TWO, np.array(durations), m)).max(axis=0)
        assert peaks(TWO, durations, m) == pytest.approx(greatest, rel=1e-5)
        assert peak(TWO, durations, m) == pytest.approx(greatest.max(), rel=1e-5)


def test_motion_passes_its_waypoints_at_rest_and_is_the_integral_of_its_velocity() -> None:
    durations = np.array([1.5, 2.5])

    times, angles = motion(TWO, durations, derivative=0, samples=1001)
    _, velocities = motion(TWO, durations, derivative=1, samples=1001)

    waypoints = np.array(TWO.waypoints)
    assert angles[[0, 1000, 2001]] == pytest.approx(waypoints, abs=1e-12)
    assert velocities[[0, 1000, 2001]] == pytest.approx(np.zeros((3, 2)), abs=1e-9)
    assert times[[0, 1000, 2001]] == pytest.approx([0.0, 1.5, 4.0])
    travelled = np.trapezoid(velocities, times, axis=0)
    assert travelled == pytest.approx(waypoints[-1] - waypoints[0], abs=1e-5)


def test_reported_time_is_that_of_a_motion_that_obeys() -> None:
    shortest = TWO.shortest()
    points = np.array([[0.5, 0.5], [9.0, 0.1], [3.0, 4.0]])

    assert TWO.quantity("total", points) == pytest.approx([shortest.sum(), 9.0 + shortest[1], 7.0])
    assert TWO.quantity("duration 1", points) == pytest.approx([shortest[0], 9.0, 3.0])
    assert TWO.quantity("duration 2", points) == pytest.approx([*shortest[[1, 1]], 4.0])


@pytest.mark.parametrize("name", ["duration 0", "duration 3", "duration", "time", "duration x"])
def test_unknown_quantity_is_refused_with_the_known_ones(name: str) -> None:
    with pytest.raises(DeclarationError, match="it has total, duration 1, duration 2"):
        TWO.quantity(name, np.ones((1, 2)))


@pytest.mark.parametrize(
    "changed",
    [
        {"velocity": (1.0,)},
        {"acceleration": (1.0, 1.0, 1.0)},
        {"jerk": (1.0,)},
        {"waypoints": ((0.0, 0.0), (1.0,))},
        {"waypoints": ((0.0, 0.0),)},
    ],
)
def test_limits_and_waypoints_that_do_not_fit_are_refused(changed: dict[str, object]) -> None:
    with pytest.raises(DeclarationError, match=r"disagree on the number of joints|two or more"):
        replace(TWO, **changed)  # type: ignore[arg-type]


def test_bounds_are_one_pair_of_durations_per_segment() -> None:
    assert TWO.bounds.tolist() == [[0.1, 9.0], [0.1, 9.0]]


@pytest.mark.parametrize(
    "changed",
    [
        {"law": septic},
        {"velocity": (1.0, 2.0000001)},
        {"jerk": (9.0, 9.0)},
        {"durations": (0.1, 8.0)},
        {"handling": "penalty"},
        {"weight": 999.0},
    ],
    ids=lambda changed: next(iter(changed)),
)
def test_identity_changes_with_every_part_of_the_problem(changed: dict[str, object]) -> None:
    assert replace(TWO, **changed).identity != TWO.identity  # type: ignore[arg-type]
    assert replace(TWO).identity == TWO.identity
