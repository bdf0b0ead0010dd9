from dataclasses import replace
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError, InputError
from repro.judge.certificates import certify
from repro.model.experiment import Experiment
from repro.model.paper import MotionReading, Paper
from repro.optimisers import WOA
from repro.robotics import MinimumTime, cubic, septic
from repro.robotics.fixed_penalties import cheapest
from repro.robotics.rest_to_rest import DERIVATIVES, Handling
from tests.small_papers import PAPER

Vector = NDArray[np.float64]
PRICES = (0.1, 0.01, 0.001)
PRICED = MinimumTime(
    waypoints=((0.0, 0.0), (1.0, -2.0), (1.5, 0.0)),
    law=septic,
    velocity=(1.0, 2.0),
    acceleration=(2.0, 3.0),
    jerk=(9.0, 30.0),
    durations=(0.2, 9.0),
    handling="fixed penalties",
    penalties=PRICES,
)
SEARCH = Experiment(
    name="motion",
    where="section 1",
    proposed="WOA",
    problems={"arm": PRICED},
    algorithms={"WOA": WOA()},
    population=20,
    iterations=50,
    runs=1,
)


def cost(problem: MinimumTime, durations: Vector) -> float:
    return float(ready(problem.kernel, COST)(durations, problem.data))


def paper(problem: MinimumTime, *readings: MotionReading) -> Paper:
    experiment = replace(SEARCH, problems={"arm": problem})
    return replace(
        PAPER, experiments=(experiment,), results=(), claims=(), motion_readings=readings
    )


def test_readings_of_the_penalties_count_kinds_joints_or_segments() -> None:
    # in segment 1 joint 1 moves 1 rad and joint 2 moves 2 rad, in segment 2 0.5 rad and 2 rad
    slow = replace(PRICED, velocity=(0.1, 0.1), acceleration=(1e9, 1e9), jerk=(1e9, 1e9))
    prices = {
        handling: cost(replace(slow, handling=handling), np.array([1.0, 2.0])) - 3.0
        for handling in get_args(Handling)
        if handling.startswith("fixed penalties")
    }

    assert prices == pytest.approx(
        {
            "fixed penalties": 0.1,
            "fixed penalties per joint": 0.2,
            "fixed penalties per joint and segment": 0.4,
            "fixed penalties where kept": 0.011,
        }
    )


@pytest.mark.parametrize("broken", [(), (0,), (1,), (2,), (0, 1), (0, 2), (1, 2), (0, 1, 2)])
def test_each_broken_kind_of_limit_is_paid_for_once(broken: tuple[int, ...]) -> None:
    limits = [(1e-3 if kind in broken else 1e9,) * 2 for kind in range(3)]
    problem = replace(PRICED, velocity=limits[0], acceleration=limits[1], jerk=limits[2])

    found = cost(problem, np.array([1.0, 2.0]))

    assert found == pytest.approx(3.0 + sum(PRICES[kind] for kind in broken))


@given(st.lists(st.floats(0.2, 9.0), min_size=2, max_size=2), st.floats(0.0, 3.0))
def test_no_durations_cost_less_than_the_proved_minimum(
    durations: list[float], price: float
) -> None:
    problem = replace(PRICED, penalties=(price, price / 2, price / 3))

    assert cost(problem, np.array(durations)) >= cheapest(problem).cost - 1e-12


@pytest.mark.parametrize("prices", [(0.1, 0.01, 0.01), (9, 0, 0), (0, 9, 0), (0, 0, 9), (9, 9, 9)])
def test_durations_of_the_proved_minimum_cost_that_much(
    prices: tuple[float, float, float],
) -> None:
    problem = replace(PRICED, penalties=prices)
    least = cheapest(problem)
    barely_longer = least.durations * (1 + 1e-12)  # a limit that is met is not broken by rounding

    assert cost(problem, barely_longer) == pytest.approx(least.cost)
    kinds = DERIVATIVES.values()
    paid = sum(price for price, kind in zip(prices, kinds, strict=True) if kind in least.broken)
    assert least.time + paid == pytest.approx(least.cost)


def test_dear_limits_are_kept_and_cheap_ones_are_broken() -> None:
    free = replace(PRICED, penalties=(9.0, 0.0, 9.0))
    least = cheapest(free)
    needed = PRICED.times_to_keep().max(axis=2)

    assert least.broken == ("acceleration",)
    assert least.durations == pytest.approx(needed[:, [0, 2]].max(axis=1))


def test_limit_that_is_broken_in_one_segment_is_named() -> None:
    long_and_short = ((0.0, 0.0), (1.0, -2.0), (1.01, -2.01))
    problem = replace(PRICED, waypoints=long_and_short, durations=(1.0, 9.0))

    assert cheapest(problem).durations.tolist() == [1.0, 1.0]
    assert cheapest(problem).broken == ("velocity", "acceleration", "jerk")


def test_motion_that_must_be_slow_by_its_range_breaks_nothing() -> None:
    slow = replace(PRICED, durations=(8.0, 9.0))

    assert cheapest(slow).broken == ()
    assert cheapest(slow).cost == 16.0


def test_fitness_tends_to_the_price_of_all_limits_as_durations_shrink() -> None:
    assert cheapest(PRICED, shortest=0.0).cost == pytest.approx(sum(PRICES))
    assert cheapest(PRICED, shortest=0.0).time == 0.0


def test_search_under_fixed_penalties_ends_on_the_proved_minimum() -> None:
    rng = np.random.default_rng(3)
    found = WOA().minimise(PRICED, population=20, iterations=50, rng=rng)

    assert found.x == pytest.approx(cheapest(PRICED).durations)
    assert found.cost == pytest.approx(cheapest(PRICED).cost)


def test_times_under_fixed_penalties_are_those_of_the_search() -> None:
    points = np.array([[0.2, 0.3], [0.5, 0.5]])

    assert PRICED.quantity("total", points).tolist() == [0.5, 1.0]
    assert PRICED.quantity("duration 2", points).tolist() == [0.3, 0.5]


def test_other_handling_has_no_cheapest_way_to_break_limits() -> None:
    with pytest.raises(InputError, match="'rejection', not by fixed penalties"):
        cheapest(replace(PRICED, handling="rejection"))


def test_certificate_says_that_breaking_is_cheaper_and_gives_no_minimum() -> None:
    (certificate,) = certify(paper(PRICED))

    assert certificate.minimum is None
    assert certificate.at == (0.2, 0.2)
    assert certificate.lower_bound is not None
    assert certificate.attained == PRICED.shortest().sum()
    assert cheapest(PRICED).cost < certificate.lower_bound < PRICED.shortest().sum()
    assert "velocity, acceleration, jerk" in certificate.explanation
    assert "tends to 0.111 s" in certificate.explanation


def test_penalties_that_deter_are_certified_like_limits() -> None:
    (certificate,) = certify(paper(replace(PRICED, penalties=(99.0, 99.0, 99.0))))

    assert certificate.minimum == pytest.approx(PRICED.shortest().sum())
    assert certificate.explanation == ""


def test_reading_is_certified_beside_the_problem_that_is_run() -> None:
    other = replace(PRICED, law=cubic, handling="feasibility first")
    reading = MotionReading(name="cubic", of=("motion", "arm"), problem=other)

    _, certificate = certify(paper(PRICED, reading))

    assert certificate.problem == "motion/arm, cubic"
    assert certificate.minimum == pytest.approx(other.shortest().sum())


def test_reading_of_a_problem_that_is_not_run_is_refused_by_name() -> None:
    reading = MotionReading(name="cubic", of=("motion", "leg"), problem=PRICED)

    fault = "reading 'cubic': no problem motion/leg; problems: motion/arm"
    with pytest.raises(DeclarationError, match=fault):
        paper(PRICED, reading)
