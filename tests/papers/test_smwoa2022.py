import math
from collections import Counter
from dataclasses import asdict

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.stats import mannwhitneyu, rankdata

from papers.smwoa2022 import (
    AFTER,
    BEFORE,
    BENCHMARK,
    OF_BOTH,
    PAPER,
    SMWOA,
    TABLE_2,
    TABLE_3,
    TABLE_6,
    TIME_SAVED,
    TRAJECTORY,
    UR5,
    WOA,
    cusps,
    limits,
    printed_durations,
)
from repro.judge.certificates import certify
from repro.model.claims import CellClaim, Sentence
from repro.robotics.spline_motion import motion
from tests.optimisers.test_twins import assert_same

Vector = NDArray[np.float64]
AVERAGES = np.array(
    [
        [TABLE_3[row, column].value for column in TABLE_3.column_names]
        for row in TABLE_3.row_names
        if row.endswith("Avg")
    ]
)
ERRATA = {(erratum.where, erratum.printed[:12]): erratum for erratum in PAPER.errata}


def minimiser(name: str) -> Vector:
    problem = BENCHMARK.problems[name]
    found: Vector = problem.function.minimiser(problem.dimension)
    return found


def test_every_printed_number_of_the_result_tables_is_a_claim() -> None:
    tables = Counter(c.table.label for c in PAPER.claims if isinstance(c, CellClaim))

    assert tables == {"Table 3": 15 * 2 * 6 + 5 + 6 + 6, "Table 6": 3 * 6}


def test_every_gap_of_a_sentence_is_declared() -> None:
    gaps = [c.gap for c in PAPER.claims if isinstance(c, Sentence) and c.gap]

    assert gaps
    assert all(gap in PAPER.gaps for gap in gaps)


@pytest.mark.parametrize("number", range(1, 16))
def test_problem_has_the_printed_dimension_and_box(number: int) -> None:
    row = TABLE_2.row_names[number - 1]
    printed = TABLE_2.cells[number - 1]
    problem = BENCHMARK.problems[f"F{number}"]

    box = [float(end) for end in str(printed[1]).strip("[]").split(",")]
    assert problem.bounds.tolist() == [box] * problem.dimension
    assert problem.dimension == (30 if row == "Alpine" else TABLE_2[row, "Dimension"].value)


@pytest.mark.parametrize("number", [n for n in range(1, 16) if n != 11])
def test_printed_optimum_is_the_minimum_of_the_function(number: int) -> None:
    printed = TABLE_2[TABLE_2.row_names[number - 1], "Optimal Value"]
    function = BENCHMARK.problems[f"F{number}"].function

    assert abs(function.minimum - printed.value) <= printed.rounding * (printed.value != 0)


def test_minimiser_of_branin_lies_in_the_printed_box() -> None:
    assert (abs(minimiser("F12")) <= 5).all()


def test_printed_ackley_is_what_the_erratum_says_at_the_optimum() -> None:
    value = -20 * math.exp(-0.2 * 0 - math.exp(1)) + 20 + math.e

    assert f"{value:.4f}" in ERRATA["Table 2, F7", "20 exp(-0.2 "].because


def test_printed_penalty_function_falls_to_what_the_erratum_says() -> None:
    y = np.linspace(0.0, 3.0, 300001)  # y_1, the other coordinates at their optimum
    least = math.pi / 30 * (10 * np.sin(math.pi * y) + (y - 1) ** 2).min()

    assert f"{least:.4f}" in ERRATA["Table 2, F9", "10 sin(π y_1"].because


def test_printed_penalty_is_zero_at_the_edge_where_the_erratum_says_another_value() -> None:
    def printed_penalty(x: float, p: float, a: float, m: float) -> float:
        return p * (x - a) ** m if x > a else 0.0

    edge = BENCHMARK.problems["F9"].bounds[0, 1]
    meant = printed_penalty(edge, p=100, a=10, m=4)

    assert printed_penalty(edge, 10, 100, 4) == 0
    assert f"{meant / 1e8:.2f}×10^8" in ERRATA["Table 2, F9 and F10", "μ(x_k, p, a,"].because
    corner = np.full(30, -1.0)
    corner[0] = edge
    assert BENCHMARK.problems["F9"].function(corner) == pytest.approx(meant, rel=1e-6)


def test_printed_foxholes_are_what_the_erratum_says_at_their_minimiser() -> None:
    grid = (-32, -16, 0, 16, 32)
    x = minimiser("F11")
    total = 1 / 500 + sum(
        1 / (j + 1 + (x[0] - grid[j % 5]) + (x[1] - grid[j // 5])) for j in range(25)
    )

    assert f"{1 / total:.3f}" in ERRATA["Table 2, F11", "Michalewicz,"].because


def test_printed_shekel_function_is_what_the_erratum_says_at_the_minimiser() -> None:
    wells = [(4, 4, 4, 4), (1, 1, 1, 1), (8, 8, 8, 8), (6, 6, 6, 6), (3, 7, 3, 7)]
    depths = (0.1, 0.2, 0.2, 0.4, 0.4)
    x = minimiser("F15")
    value = -sum(
        1 / (((x - np.array(well)) ** 2).sum() * c) for well, c in zip(wells, depths, strict=True)
    )

    assert f"{value / 1e8:.1f}×10^8" in ERRATA["Table 2, F15", "[(X - a_k)(X"].because


def test_printed_averages_give_the_mean_ranks_that_the_erratum_says() -> None:
    ranks = [f"{rank:.4f}" for rank in np.mean([rankdata(row) for row in AVERAGES], axis=0)]
    printed = [TABLE_3["Average ranking", name].text for name in TABLE_3.column_names]
    erratum = ERRATA["Table 3, average ranking", "1.4000 for S"]

    differ = [k for k in range(6) if ranks[k] != printed[k]]

    assert [TABLE_3.column_names[k] for k in differ] == ["SMWOA", "PSO"]
    assert all(ranks[k] in erratum.because for k in differ)
    assert all(printed[k] in erratum.printed for k in differ)


def test_p_values_of_the_printed_averages_are_as_the_assumption_says() -> None:
    p = [
        mannwhitneyu(AVERAGES[:, 0], AVERAGES[:, k], method="asymptotic").pvalue
        for k in range(1, 6)
    ]
    said = next(a for a in PAPER.assumptions if "p-value" in a.what).because

    assert f"{min(p):.3f} to {max(p):.1f}" in said


def test_angles_of_the_path_stay_inside_their_limits_as_the_assumption_says() -> None:
    _, angles = motion(UR5, np.array(printed_durations("SMWOA")), derivative=0, samples=2001)
    shares = [f"{100 * share:.0f} %" for share in abs(angles).max(axis=0) / limits(0, "deg")]
    said = next(a for a in PAPER.assumptions if a.what == "angle limits").because

    assert f"{shares[2]} (joint 3) to {shares[3]} (joint 4)" in said
    assert min(shares) == shares[2]
    assert max(shares) == shares[3]


def test_printed_reduction_follows_from_the_printed_times() -> None:
    reduction = 100 * (1 - AFTER.value / BEFORE.value)

    assert abs(reduction - TIME_SAVED.value) <= TIME_SAVED.rounding


def test_search_of_durations_may_find_the_optimum_and_the_printed_ones() -> None:
    low, high = UR5.durations
    optimum = certify(PAPER)[0].at

    for durations in (optimum, *map(printed_durations, TABLE_6.row_names)):
        assert low < min(durations)
        assert max(durations) < high


def test_certified_minimum_is_proved_to_a_microsecond_and_half_of_the_printed_times() -> None:
    proved = certify(PAPER)[0]

    assert proved.problem == "trajectory/UR5"
    assert proved.lower_bound is not None
    assert proved.minimum is not None
    assert 0 < proved.minimum - proved.lower_bound < 1e-5
    assert [time.label for time in proved.printed] == [
        "Table 6, SMA", "Table 6, WOA", "Table 6, SMWOA",
    ]  # fmt: skip
    assert all(2 < time.ratio < 2.3 for time in proved.printed)


def test_readings_at_rest_are_proved_whether_or_not_accelerations_bind() -> None:
    bent, straight = certify(PAPER)[1:]

    for proved in (bent, straight):
        assert proved.minimum is not None
        assert proved.lower_bound is not None
        assert 0 < proved.minimum - proved.lower_bound < 5e-5
    assert "branch and bound" in bent.method
    assert any("acceleration" in limit for limit in bent.binding)
    assert "branch and bound" not in straight.method
    assert not any("acceleration" in limit for limit in straight.binding)


@pytest.mark.parametrize("name", TRAJECTORY.algorithms)
def test_no_run_beats_the_certificate(name: str) -> None:
    bound = certify(PAPER)[0].lower_bound

    for seed in range(3):
        found = TRAJECTORY.algorithms[name].minimise(
            UR5, population=100, iterations=100, rng=np.random.default_rng(seed)
        )
        assert bound is not None
        assert UR5.quantity("total", found.x) >= bound


def test_printed_motions_are_as_far_from_limits_and_optimum_as_the_erratum_says() -> None:
    shares = [UR5.peak_shares(np.array(printed_durations(name))) for name in TABLE_6.row_names]
    fast, hard = (
        sorted(f"{100 * share:.0f} %" for share in kind) for kind in zip(*shares, strict=True)
    )
    ratios = sorted(f"{time.ratio:.1f}" for time in certify(PAPER)[0].printed)
    said = ERRATA["Table 6 against Tables 4 and 5", "totals of 25"].because

    assert f"velocity is {fast[0]} to {fast[-1]} of its limit" in said
    assert set(hard) == {"9 %"}
    assert "acceleration 9 % of its" in said
    assert f"{ratios[0]} to {ratios[-1]} times the proved optimum" in said


def test_the_compared_whale_differs_from_smwoa_in_what_smwoa_adds_and_in_nothing_else() -> None:
    added = {"control", "weight", "weights", "swing"}
    readings = {each.name: each for own in PAPER.assumptions for each in own.alternatives}

    assert {n for n, v in asdict(SMWOA).items() if v != asdict(WOA)[n]} == added
    for experiment in (BENCHMARK, TRAJECTORY):
        assert experiment.algorithms["WOA"] is WOA
        for name, fields in OF_BOTH.items():
            for column in ("SMWOA", "WOA"):
                assert readings[name].algorithms[experiment.name, column] == fields


@pytest.mark.parametrize(("percent", "stretches"), [(50, [1, 1, 2, 2]), (90, [1, 1, 1, 1])])
def test_how_many_cusps_the_jerk_has_hangs_on_what_a_cusp_is(
    percent: float, stretches: list[int]
) -> None:
    found = [claim.measure.measure(None).value for claim in cusps(percent)]  # type: ignore[union-attr,arg-type]

    assert found == stretches


def test_what_the_paper_does_not_state_is_not_counted() -> None:
    (rest,) = [c for c in PAPER.claims if isinstance(c, Sentence) and "at rest" in c.claim]

    assert not rest.counts


def test_the_total_of_smwoa_counts_once_in_table_and_text() -> None:
    said = [c for c in PAPER.claims if c.printed == AFTER]

    assert len(said) == 2
    assert {c.group for c in said} == {"24.635 s"}


@pytest.mark.parametrize("name", ["rosenbrock", "steps", "slope"])
def test_smwoa_as_declared_is_its_twin(name: str) -> None:
    assert_same(
        SMWOA,
        name,
        population=30,
        control="arctanh",  # Eq. (10)
        coefficients="vector",  # Eqs. (4) and (15): r_rand is a vector
        weight="of the whale",  # Eq. (15)
        weights="per whale",  # Eq. (11)
        swing="per dimension",  # Eq. (13)
        leader="per whale",  # Eq. (14)
        spiral_range="symmetric",  # Eq. (5)
    )


def test_smwoa_closes_in_on_the_minimum_of_the_sphere_in_30_times_500_evaluations() -> None:
    found = SMWOA.minimise(
        BENCHMARK.problems["F1"], population=30, iterations=500, rng=np.random.default_rng(1)
    )

    assert found.cost < 1e-20
    assert found.evaluations == 30 * 500
