"""SYJI-0035: what Table 2 and the fitness as printed say, worked out a second way."""

import math
from dataclasses import replace

import numpy as np
import pytest

from papers.syji import (
    DURATIONS,
    END,
    FOUND,
    PAPER,
    PRINTED,
    READINGS,
    RESTING,
    SAVED,
    SEVENTH,
    START,
    TABLE_2,
    TABLE_3,
    TABLE_4,
    TOTAL,
    WHOLE,
    share,
    share_on_average,
)
from repro.determinism.compiled import COST, ready
from repro.judge.findings import findings_of
from repro.judge.verdict import Verdict
from repro.model.claims import CellClaim
from repro.optimisers import WOA
from repro.robotics import quintic, septic
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import cheapest
from tests.small_papers import evidence_of

# Greatest |derivative| of s(τ) = 10τ³-15τ⁴+6τ⁵ and 35τ⁴-84τ⁵+70τ⁶-20τ⁷, by hand: s' and s''' turn
# at τ = 1/2, s'' at (1-1/√3)/2 and (1-1/√5)/2; the fifth order's jerk is greatest at the ends.
BY_HAND = {
    "Maximum velocity 5": (15 / 8, 1),
    "Maximum acceleration 5": (10 / math.sqrt(3), 2),
    "Maximum Jerk 5": (60.0, 3),
    "Maximum velocity 7": (35 / 16, 1),
    "Maximum acceleration 7": (84 / (5 * math.sqrt(5)), 2),
    "Maximum Jerk 7": (105 / 2, 3),
}
TRAVEL = {"1": 45, "2": 90, "3": 45, "4": 45, "5": 45, "6": 90}
DIFFERENT = {
    ("1", "Maximum Jerk 7"),
    *((joint, name) for joint in "26" for name in ("Maximum velocity 7", "Maximum Jerk 7")),
    *((joint, "Maximum acceleration 5") for joint in "26"),
}


def text_of(what: str) -> str:
    return next(a.because for a in PAPER.assumptions if a.what == what)


def test_every_cell_of_table_2_has_its_closed_form() -> None:
    findings = [
        f for f in findings_of(PAPER.claims, evidence_of(PAPER, {})) if f.table == "Table 2"
    ]

    assert len(findings) == 36
    for found in findings:
        factor, power = BY_HAND[str(found.column)]
        expected = factor * TRAVEL[str(found.row)] / WHOLE.value**power
        assert found.value == pytest.approx(expected, rel=1e-12)


def test_seven_cells_of_table_2_are_not_their_closed_form() -> None:
    findings = [
        f for f in findings_of(PAPER.claims, evidence_of(PAPER, {})) if f.table == "Table 2"
    ]
    contradicted = {(f.row, f.column) for f in findings if f.verdict != Verdict.REPRODUCED}

    assert contradicted == DIFFERENT
    assert {f.side for f in findings if f.verdict != Verdict.REPRODUCED} == {"higher"}


def test_cells_that_differ_have_the_explanations_of_the_errata() -> None:
    def cell(row: str, column: str) -> float:
        return TABLE_2[row, column].value

    forward = SEVENTH.law.polynomial.deriv(3)(np.linspace(0, 1, 100_001)).max()
    assert cell("1", "Maximum Jerk 7") == pytest.approx(forward * 45 / 5**3, abs=0.005)
    for name in ("Maximum velocity 7", "Maximum Jerk 7"):
        assert cell("2", name) == cell("6", name) == pytest.approx(2 * cell("3", name))
    sampled = 60 * 0.22 - 180 * 0.22**2 + 120 * 0.22**3  # at 1.1 s, the greatest of 0.1 s steps
    assert f"{sampled * 90 / 25:.3f}" == "20.757"
    assert f"{sampled * 45 / 25:.2f}" == "10.38"


def test_limits_are_the_seventh_order_columns_and_lie_below_its_peaks() -> None:
    for kind, name in zip(("Velocity", "Acceleration", "Jerk"), (1, 2, 3), strict=True):
        column = next(c for c in BY_HAND if c.lower() == f"maximum {kind.lower()} 7")
        printed = TABLE_3.column(f"Maximum {kind}")
        assert printed == TABLE_2.column(column)
        assert (SEVENTH.times_to_keep()[0, name - 1] > WHOLE.si).all()


def test_positions_divide_the_way_from_start_to_end_in_four() -> None:
    start, end = (np.array([angle.si for angle in place]) for place in (START, END))
    points = np.array([TABLE_4.column(name) for name in TABLE_4.column_names])

    assert points == pytest.approx(np.linspace(start, end, 5), abs=1e-15)


def test_printed_durations_miss_the_printed_total_but_for_one_digit() -> None:
    assert sum(d.value for d in DURATIONS) == pytest.approx(2.2504)
    assert sum(FOUND) == pytest.approx(TOTAL.value)
    assert str(FOUND[1]) == DURATIONS[1].text[:3] + "9" + DURATIONS[1].text[3:]
    assert WHOLE.value - TOTAL.value == pytest.approx(SAVED.value)


@pytest.mark.parametrize(
    ("duration", "fitness"), [(3.4, 13.6), (3.0, 12.01), (2.0, 8.02), (1.0, 4.12), (0.1, 0.52)]
)
def test_fitness_as_printed_is_time_and_prices(duration: float, fitness: float) -> None:
    # at rest at each position, jerk needs 3.39 s a segment, acceleration 2.50 s, velocity 1.25 s
    cost = ready(PRINTED.kernel, COST)(np.full(4, duration), PRINTED.data)

    assert cost == pytest.approx(fitness)


@pytest.mark.parametrize("lower_end", [0.01, 0.1, 0.2308, 1.2])
def test_fitness_as_printed_is_least_at_the_shortest_durations(lower_end: float) -> None:
    least = cheapest(replace(PRINTED, durations=(lower_end, WHOLE.si)))

    assert least.durations.tolist() == [lower_end] * 4
    assert least.broken == ("velocity", "acceleration", "jerk")
    assert least.cost == pytest.approx(4 * lower_end + 0.12)


def test_fitness_as_printed_tends_to_the_price_of_all_limits() -> None:
    assert cheapest(PRINTED, shortest=0.0).cost == pytest.approx(0.12)


def test_breaking_all_limits_is_cheaper_than_obeying_under_every_reading() -> None:
    any_curve = max(fastest_joints(RESTING))
    every_joint_and_segment = 0.4 + 0.12 * 6 * 4

    assert cheapest(PRINTED).cost < every_joint_and_segment < any_curve
    assert any_curve < SEVENTH.shortest().sum() < RESTING.shortest().sum()


def test_search_ends_on_the_shortest_durations_whatever_its_seed() -> None:
    for seed in range(5):
        found = WOA(b=1).minimise(
            PRINTED, population=50, iterations=200, rng=np.random.default_rng(seed)
        )
        assert found.x.tolist() == [0.1] * 4


def test_printed_durations_break_every_limit_under_every_reading() -> None:
    shares = [share(motion(), m) for motion in READINGS.values() for m in (1, 2, 3)]

    assert len(shares) == 9
    assert min(shares) > 200


def test_least_times_in_the_assumptions_are_those_that_are_computed() -> None:
    jerk = TABLE_3.column("Maximum Jerk")
    alike = (jerk[2], *jerk[1:])
    words = text_of("greatest jerk allowed of joint 1")

    for limits in (jerk, alike):
        rest, one = (replace(problem, jerk=limits) for problem in (RESTING, SEVENTH))
        times = rest.shortest().sum(), one.shortest().sum(), max(fastest_joints(rest))
        assert "{:.2f}, {:.3f} and {:.3f}".format(*times) in words


def test_every_number_of_the_result_is_claimed() -> None:
    printed = {claim.printed for claim in PAPER.claims if not isinstance(claim, CellClaim)}

    assert {TOTAL, SAVED, *DURATIONS} <= printed


def test_seventh_order_is_smoother_by_two_of_three_readings() -> None:
    findings = [
        f
        for f in findings_of(PAPER.claims, evidence_of(PAPER, {}))
        if "is smoother" in str(f.claim)
    ]

    # greatest jerk 52.5 to 60, jump of jerk 0 to 60, ∫ jerk² of the laws 1120 to 720, by hand
    assert [law.squared(3) for law in (septic, quintic)] == pytest.approx([1120, 720])
    assert [f.value for f in findings] == pytest.approx([87.5, 0.0, 100 * 1120 / 720])
    assert [f.verdict for f in findings] == [
        Verdict.REPRODUCED,
        Verdict.REPRODUCED,
        Verdict.CONTRADICTED,
    ]


def test_positions_are_met_faster_than_the_velocity_limit_whatever_the_curve() -> None:
    average = 11.25 / DURATIONS[0].value

    assert share_on_average() == pytest.approx(100 * average / 19.68)
    assert average / 19.68 > 2
