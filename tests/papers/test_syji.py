"""SYJI-0035: what Table 2 and the fitness as printed say, worked out a second way."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import pytest

from papers.syji import (
    ANY_CURVE,
    AT_REST,
    DURATIONS,
    END,
    FOUND,
    MOTION,
    ONE,
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
    between,
    saved_under_limits,
    share,
    share_on_average,
)
from repro.determinism.compiled import COST, ready
from repro.judge.findings import Finding, findings_of
from repro.judge.verdict import Verdict
from repro.model import WOA_BY_VECTORS, Alternative, CellClaim, Claim, Sentence, TableCell
from repro.robotics import quintic, septic
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import cheapest
from repro.robotics.polynomials import RestToRestLaw
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


def changed(name: str) -> Alternative:
    every = (each for own in PAPER.assumptions for each in own.alternatives)
    return next(each for each in every if each.name == name)


def judged(claims: Sequence[Claim]) -> dict[str, Finding]:
    """Return the finding of each sentence, of which none needs a run here."""
    return {str(found.claim): found for found in findings_of(claims, evidence_of(PAPER, {}))}


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

    assert isinstance(SEVENTH.law, RestToRestLaw)
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


def one_slip_away(text: str) -> Iterator[str]:
    """Yield a number with one decimal changed, lost or added, or two exchanged."""
    whole, _, decimals = text.partition(".")
    places, digits = range(len(decimals)), "0123456789"
    for i in places:
        yield from (f"{whole}.{decimals[:i]}{d}{decimals[i + 1 :]}" for d in digits)
        yield f"{whole}.{decimals[:i]}{decimals[i + 1 :]}"
        for j in range(i):
            swapped = [*decimals]
            swapped[i], swapped[j] = swapped[j], swapped[i]
            yield f"{whole}.{''.join(swapped)}"
    for i in range(len(decimals) + 1):
        yield from (f"{whole}.{decimals[:i]}{d}{decimals[i:]}" for d in digits)


def test_three_single_slips_close_the_printed_sum_and_each_is_judged() -> None:
    off = TOTAL.value - sum(d.value for d in DURATIONS)
    closing = {
        (printed.text, meant)
        for sign, numbers in ((1, DURATIONS), (-1, (TOTAL,)))
        for printed in numbers
        for meant in one_slip_away(printed.text)
        if abs(sign * (float(meant) - printed.value) - off) < 1e-9
    }

    assert closing == {("0.845", "0.8945"), ("0.2308", "0.2803"), ("0.9166", "0.9661")}
    assert FOUND == (0.2308, 0.8945, 0.9166, 0.258)
    assert changed("0.2803 s for segment 1").claims
    assert changed("0.9661 s for segment 3").claims
    assert WHOLE.value - TOTAL.value == pytest.approx(SAVED.value)


def test_printed_durations_judged_with_another_slip_sum_to_the_printed_total() -> None:
    for name in ("0.2803 s for segment 1", "0.9661 s for segment 3"):
        told = [c.measure.words for c in changed(name).claims if c.measure]
        durations = told[-1].rpartition("with ")[2].removesuffix(" s").split(", ")

        assert sum(map(float, durations)) == pytest.approx(TOTAL.value)


@pytest.mark.parametrize(
    ("duration", "fitness"), [(3.4, 13.6), (3.0, 12.01), (2.0, 8.02), (1.0, 4.12), (0.1, 0.52)]
)
def test_fitness_as_printed_is_time_and_prices(duration: float, fitness: float) -> None:
    # at rest at each position, jerk needs 3.39 s a segment, acceleration 2.50 s, velocity 1.25 s
    cost = ready(PRINTED.kernel, COST)(np.full(4, duration), PRINTED.data)

    assert cost == pytest.approx(fitness)


@pytest.mark.parametrize("lower_end", [0.01, 0.1, 0.2308, 0.5, 1.0, 1.2])
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
        found = WOA_BY_VECTORS.minimise(
            PRINTED, population=50, iterations=200, rng=np.random.default_rng(seed)
        )
        assert found.x.tolist() == [0.1] * 4
    assert MOTION.algorithms == {"WOA": WOA_BY_VECTORS}


def test_printed_durations_break_every_limit_under_every_reading() -> None:
    shares = [share(motion(FOUND), m, PRINTED) for motion in READINGS.values() for m in (1, 2, 3)]

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
    (default,) = (c for c in PAPER.claims if "is smoother" in getattr(c, "claim", ""))
    others = ("jump of jerk at start and end", "integral of squared jerk")
    claims = (default, *(changed(name).claims[0] for name in others))
    findings = [next(iter(judged([claim]).values())) for claim in claims]

    # greatest jerk 52.5 to 60, jump of jerk 0 to 60, ∫ jerk² of the laws 1120 to 720, by hand
    assert [law.squared(3) for law in (septic, quintic)] == pytest.approx([1120, 720])
    assert [f.value for f in findings] == pytest.approx([87.5, 0.0, 100 * 1120 / 720])
    assert [f.verdict for f in findings] == [
        Verdict.REPRODUCED,
        Verdict.REPRODUCED,
        Verdict.CONTRADICTED,
    ]


def test_limits_are_broken_under_every_reading_of_what_the_arm_does_and_every_slip() -> None:
    names = (
        "passing through",
        "one polynomial",
        "any curve",
        "0.2803 s for segment 1",
        "0.9661 s for segment 3",
    )
    for claims in (between(AT_REST), *(changed(name).claims for name in names)):
        found = judged(claims)
        limits = [f.verdict for claim, f in found.items() if "limits are satisfied" in claim]

        assert limits
        assert set(limits) == {Verdict.CONTRADICTED}


def test_time_is_saved_under_the_limits_by_no_reading() -> None:
    for how in (AT_REST, ONE, ANY_CURVE):
        (found,) = judged([saved_under_limits(how)]).values()
        assert found.verdict is Verdict.CONTRADICTED
        assert found.side == "lower"


def test_range_of_durations_has_its_points_in_order_and_moves_the_least_time() -> None:
    (own,) = (a for a in PAPER.assumptions if a.open)
    tried = [each for each in own.alternatives if each.at is not None]

    assert (own.at, [each.at for each in tried]) == (0.1, [0.01, 0.5, 1.0])
    for each in tried:
        (found,) = judged(each.claims).values()
        assert found.value == pytest.approx(4 * (each.at or 0))
        assert each.problems["motion", "SYJI-0035"]["durations"][0] == each.at


def test_one_sentence_one_result_and_one_slip_count_once() -> None:
    groups = Counter(claim.group for claim in PAPER.claims if claim.counts and claim.group)
    cells = {name: n for name, n in groups.items() if name.startswith("Table 2")}
    single = [c for c in PAPER.claims if c.counts and not c.group]

    assert groups["the constraints are satisfied"] == 3
    assert groups["the time found"] == 7  # total, four durations, difference, shortest
    assert sum(cells.values()) == 36
    assert cells["Table 2, doubled after cutting"] == 4
    assert cells["Table 2, jerk of joint 1"] == 1
    assert len(cells) == 12
    assert len(single) == 5  # smoother, servo drive, shaking, reduced, saved under limits
    assert sum(not claim.counts for claim in PAPER.claims) == 3


def test_every_reading_that_runs_anything_runs_as_often_as_the_protocol() -> None:
    depths = {
        each.name: each.full_depth
        for own in PAPER.assumptions
        for each in own.alternatives
        if each.problems or each.algorithms or each.protocol
    }

    assert len(depths) == 13
    assert all(depths.values())


def test_a_reading_brings_its_claims_into_the_same_groups() -> None:
    own = {identity(claim): claim.group for claim in PAPER.claims}
    for assumption in PAPER.assumptions:
        for alternative in assumption.alternatives:
            for claim in alternative.claims:
                assert own[identity(claim)] == claim.group


def identity(claim: Claim) -> TableCell | str:
    return claim.claim if isinstance(claim, Sentence) else claim.cell


def test_positions_are_met_faster_than_the_velocity_limit_whatever_the_curve() -> None:
    average = 11.25 / DURATIONS[0].value

    assert share_on_average() == pytest.approx(100 * average / 19.68)
    assert average / 19.68 > 2
