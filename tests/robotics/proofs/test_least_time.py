"""What is said of a spline's least time: gap, box, scale and time limit."""

import math
from dataclasses import replace
from functools import cache
from itertools import count

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.determinism.compiled import COST, ready
from repro.robotics import MinimumTimeSpline
from repro.robotics.bsplines import Ends
from repro.robotics.proofs.least_time import least_time
from repro.robotics.proofs.proved import FREE, GAP, LeastTime
from repro.robotics.proofs.spline_minimum import SplineProof
from repro.robotics.proofs.watch import Watch

# five points up to 0.2 rad apart, as an engineer's UR5e would go through them
POINTS = (
    (0.0, 0.0, 0.0),
    (0.02, -0.1, 0.05),
    (0.15, -0.05, 0.2),
    (0.1, 0.1, 0.3),
    (0.3, 0.2, 0.25),
)
SMALL = MinimumTimeSpline(
    nodes=POINTS,
    velocity=(math.pi,) * 3,
    acceleration=(5.0,) * 3,
    durations=(0.001, 10.0),
    ends="still",
)
proved = cache(least_time)
"""What several tests compare with is proved once."""


def turned(seed: int, ends: Ends) -> MinimumTimeSpline:
    """Return a spline through five random points of six joints."""
    moves = np.random.default_rng(seed).uniform(-0.2, 0.2, (5, 6))
    return replace(
        SMALL,
        nodes=tuple(map(tuple, np.cumsum(moves, axis=0))),
        ends=ends,
        velocity=(math.pi,) * 6,
        acceleration=(5.0,) * 6,
    )


def ticking(seconds: float) -> Watch:
    """Return a watch whose clock goes on by one second whenever somebody looks."""
    ticks = map(float, count())
    return Watch(clock=lambda: next(ticks), until=seconds)


@pytest.mark.parametrize("ends", ["still", "repeated"])
@pytest.mark.parametrize("seed", [0, 1])
def test_small_motions_are_proved_to_a_millionth(seed: int, ends: Ends) -> None:
    problem = turned(seed, ends)
    found = least_time(problem)

    assert found.minimum == found.attained
    assert found.gap is not None
    assert found.gap < 2e-6
    assert ready(problem.kernel, COST)(np.array(found.at), problem.data) == found.attained


@given(st.lists(st.floats(0.1, 1.0), min_size=4, max_size=4))
def test_no_direction_obeys_in_less_than_the_bound(direction: list[float]) -> None:
    scaled = replace(SMALL, handling="time scaling")
    total = scaled.obeying(np.array(direction)).sum()

    assert total >= (proved(SMALL).lower_bound or math.inf)


@pytest.mark.parametrize("power", [-3, 0, 5])
def test_fast_and_slow_splines_are_proved_alike(power: int) -> None:
    by = 10.0**power
    scaled = replace(
        SMALL,
        velocity=tuple(limit / by for limit in SMALL.velocity),
        acceleration=tuple(limit / by**2 for limit in SMALL.acceleration),
        durations=(0.001 * by, 10.0 * by),
    )
    found = least_time(scaled)

    assert found.minimum == pytest.approx(by * (proved(SMALL).minimum or 0.0), rel=2e-6)
    assert found.gap is not None
    assert found.gap < 2e-6


def test_proof_that_is_cut_short_has_bounds_and_no_minimum() -> None:
    whole, cut = proved(SMALL), least_time(SMALL, ticking(40))

    assert cut.minimum is None
    assert cut.lower_bound is not None
    assert cut.attained is not None
    assert cut.lower_bound < (whole.lower_bound or 0.0) <= (whole.attained or 0.0) <= cut.attained
    assert cut.gap is not None
    assert cut.gap > GAP
    assert "% apart" in cut.explanation


def test_proof_that_has_no_time_at_all_still_has_a_motion_that_obeys() -> None:
    found = least_time(SMALL, ticking(0))

    assert found.minimum is None
    assert 0 < (found.lower_bound or 0.0) < (found.attained or 0.0)
    assert SMALL.obeys(np.array(found.at))


def test_search_tells_how_far_it_is() -> None:
    told: list[tuple[float, float]] = []
    watch = replace(ticking(math.inf), tell=lambda *state: told.append(state))

    found = least_time(SMALL, watch)

    lower = [state[0] for state in told]
    assert lower == sorted(lower)
    assert told[-1][1] == pytest.approx(found.attained, rel=1e-6)
    assert all(bound <= motion for bound, motion in told)


def test_durations_of_a_spline_stay_in_the_box() -> None:
    free = proved(SMALL)
    shortest = 1.2 * min(free.at)
    boxed = replace(SMALL, durations=(shortest, 10.0))
    found = least_time(boxed)

    assert min(found.at) >= shortest
    assert found.minimum is not None
    assert found.minimum > (free.minimum or math.inf)
    assert any("shortest duration allowed" in text for text in found.binding)


def test_box_in_which_no_spline_obeys_is_proved_to_be_one() -> None:
    free = proved(SMALL)
    found = least_time(replace(SMALL, durations=(0.001, 0.5 * max(free.at))))

    assert (found.minimum, found.lower_bound, found.attained, found.at) == (None, None, None, ())
    assert found.explanation.startswith("No durations from 0.001 to ")


@pytest.mark.parametrize(
    ("boxes", "says"), [(0, ""), (1, ", proved by 1 box"), (2, ", proved by 2 boxes")]
)
@pytest.mark.parametrize("durations", [(0.5, 2.0), FREE])
def test_boxes_of_a_proof_are_counted_and_free_durations_end_where_doubles_do(
    boxes: int, says: str, durations: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    boxed = replace(SMALL, durations=durations)

    def found(lower: float) -> LeastTime:
        proof = SplineProof(
            lower_bound=lower, durations=(), holding=(), acceleration_share=0.0, boxes=boxes
        )
        monkeypatch.setattr("repro.robotics.proofs.least_time.prove", lambda _: proof)
        return least_time(boxed)

    among = "" if durations == FREE else " from 0.5 to 2 s"
    within = among or " up to 1e+60 s"
    assert found(math.inf).explanation == f"No durations{within} obey{says}."
    given = "" if durations == FREE else " with durations from 0.5 to 2 s"
    took = f"{says} of durations" if boxes else ""
    assert found(3.0).explanation == (
        f"No motion{given} was found that obeys; one would take 3 s or more{took}."
    )
    assert ("in one box from below" in found(3.0).method) == (boxes == 1)


def test_time_that_stands_still_at_the_ends_is_said() -> None:
    found = least_time(replace(SMALL, time_ends="still"))

    assert found.minimum is None
    assert "time stands still" in found.explanation
