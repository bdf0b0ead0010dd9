import itertools
import math
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from repro.determinism.compiled import COST, ready
from repro.judge.certificates import Certificate, certify
from repro.model.cells import every_cell
from repro.model.paper import Paper
from repro.model.tolerances import Percent
from repro.optimisers import WOA
from repro.robotics import MinimumTime, cubic, quintic
from repro.tables.published import PublishedTable
from tests.budgets import examples
from tests.robotics.test_rest_to_rest import TWO, problems
from tests.small_papers import EXPERIMENT, PAPER

TIMES = PublishedTable.read("""
    Table 2, p. 5
    algorithm || t1 [s] | t2 [s] | total [s]
    guess     || 2.0    | 2.0    | 4.0
    wide      || 3.0    | 2.5    | 5.5
""")


def moving(problem: MinimumTime) -> Paper:
    """Return a paper that prints times of one motion, as many as it has."""
    motion = replace(EXPERIMENT, name="motion", problems={"arm": problem})
    claims = every_cell(
        TIMES,
        of=motion,
        rows=("algorithm",),
        columns="quantity",
        given={"problem": "arm", "statistic": "mean"},
        names={"t1": "duration 1", "t2": "duration 2"},
        within=Percent(1),
    )
    own = tuple(c for c in claims if c.column == "total" or int(c.column[1]) <= problem.segments)
    results = (TIMES,) if len(own) == len(claims) else ()
    return replace(PAPER, experiments=(EXPERIMENT, motion), results=results, claims=own)


def certificate(problem: MinimumTime) -> Certificate:
    (found,) = certify(moving(problem))
    return found


def test_paper_without_motions_has_no_certificate() -> None:
    assert certify(PAPER) == ()


def test_certificate_names_paper_and_problem() -> None:
    found = certificate(TWO)

    assert (found.paper, found.problem) == ("small2020", "motion/arm")


def test_minimum_is_the_sum_of_the_durations_worked_out_by_hand() -> None:
    each = math.sqrt(10 / math.sqrt(3) * 2 / 3)  # joint 2 moves 2 rad at 3 rad/s² in both segments

    found = certificate(TWO)

    assert found.at == pytest.approx((each, each))
    assert found.minimum == found.attained == pytest.approx(2 * each)
    assert found.lower_bound == pytest.approx(2 * each, rel=1e-14)
    assert found.binding == tuple(
        f"segment {k}: acceleration of joint 2 (limit 3 rad/s²)" for k in (1, 2)
    )


def test_binding_is_the_limit_that_would_have_to_be_raised() -> None:
    found = certificate(
        replace(TWO, velocity=(0.1, 9.0), law=cubic, jerk=(9.0, 1.0), durations=(0.1, 20.0))
    )

    assert found.binding == (
        "segment 1: velocity of joint 1 (limit 0.1 rad/s)",  # 3/2 · 1 / 0.1 = 15 s
        "segment 2: velocity of joint 1 (limit 0.1 rad/s)",  # half of it, 7.5 s
    )
    assert found.at == pytest.approx((15.0, 7.5))


@given(problems())
def test_certificate_is_never_beaten_by_a_grid_of_durations_that_obey(
    problem: MinimumTime,
) -> None:
    found = certificate(problem)
    cost, data = ready(problem.kernel, COST), problem.data
    # one duration on each axis is the certified one; rounding decides on which side it falls
    grids = [np.linspace(0.4, 1.6, 13) * duration for duration in found.at]

    costs = [cost(np.array(point), data) for point in itertools.product(*grids)]

    assert found.minimum is not None
    assert found.minimum * (1 - 1e-12) <= min(costs) <= 1.1 * found.minimum * (1 + 1e-12)


@given(problems())
def test_certified_motion_obeys_as_the_search_counts_it(problem: MinimumTime) -> None:
    found = certificate(problem)
    cost = ready(problem.kernel, COST)

    slower = np.array(found.at) * (1 + 1e-12)

    assert cost(slower, problem.data) == pytest.approx(found.attained, rel=1e-11)


@settings(max_examples=examples(10))
@given(problems(), st.integers(0, 9))
def test_search_never_ends_below_the_certificate(problem: MinimumTime, seed: int) -> None:
    found = certificate(problem)
    near = replace(problem, durations=(min(found.at) / 3, 3 * max(found.at)))

    rng = np.random.default_rng(seed)
    result = WOA().minimise(near, population=30, iterations=300, rng=rng)

    assert found.minimum is not None
    assert result.cost >= found.minimum * (1 - 1e-12)


def test_printed_totals_stand_as_ratios_to_the_minimum() -> None:
    found = certificate(TWO)

    assert found.minimum is not None
    assert [(p.label, p.time) for p in found.printed] == [
        ("Table 2, guess", 4.0),
        ("Table 2, wide", 5.5),
    ]
    assert [p.ratio * found.minimum for p in found.printed] == pytest.approx([4.0, 5.5])


def test_printed_times_of_another_problem_stand_elsewhere() -> None:
    paper = moving(TWO)
    motion = replace(paper.experiments[1], problems={"arm": TWO, "leg": replace(TWO, law=quintic)})

    arm, leg = certify(replace(paper, experiments=(EXPERIMENT, motion)))

    assert (len(arm.printed), len(leg.printed)) == (2, 0)


def test_fields_are_those_of_the_contract() -> None:
    names = {field.name for field in fields(Certificate)}

    assert names >= {
        *("paper", "problem", "minimum", "lower_bound", "attained", "method"),
        *("at", "binding", "printed", "explanation"),
    }
