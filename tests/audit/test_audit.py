import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from papers.liang2026 import PAPER, TABLE_II
from repro.audit import AuditRow, Grade, audit
from repro.functions import FUNCTIONS
from repro.judge.certificates import certify
from repro.optimisers import GWO, WOA
from repro.optimisers.search import Optimiser
from repro.tables.extremes import narrowest, widest
from repro.tables.published import Printed
from repro.tables.true_numbers import Span, span
from tests import doe2021
from tests.summaries import audited, fixed, paper_of, printed_tables, samples, scientific, summary

LIANG = audit(PAPER)
SPREAD_OUT = st.lists(st.floats(1.0, 1000.0), min_size=3, max_size=40).map(np.array)


def cells_of(rows: tuple[AuditRow, ...], grade: Grade) -> set[tuple[str | None, str | None, str]]:
    return {(row.row, row.column, row.check) for row in rows if row.grade is grade}


@given(printed_tables())
def test_no_table_of_a_real_sample_is_impossible(table: tuple[dict[str, str], int, str]) -> None:
    block, n, function = table
    assert audited(block, n=n, function=function) == {}


@pytest.mark.parametrize("names", [("mean", "std"), ("best", "worst", "mean", "std")])
@given(sample=SPREAD_OUT)
def test_a_std_pushed_above_every_bound_is_caught(
    names: tuple[str, ...], sample: np.ndarray
) -> None:
    values, n = summary(sample), len(sample)
    low = 0.999 * values["best"] if "best" in names else 0.0  # four digits hide less than 0.1 %
    above = 1.001 * values["worst"] - 0.999 * values["mean"]
    below = 1.001 * values["mean"] - low
    most = n * below**2  # one run high, the others at the lower bound
    if "worst" in names:
        most = min(most, n / (n - 1) * above * below)
    values["std"] = 1.002 * math.sqrt(most)
    assert "std-bound" in audited({name: scientific(values[name]) for name in names}, n=n)


@pytest.mark.parametrize("share", [0.0, 0.98])
@given(sample=SPREAD_OUT)
def test_a_std_pushed_below_what_the_range_needs_is_caught(
    share: float, sample: np.ndarray
) -> None:
    values = summary(sample)
    width = values["worst"] * 0.999 - values["best"] * 1.001  # more than four digits can hide
    assume(width > 0)
    least = width / math.sqrt(2 * len(sample))
    block = {name: scientific(value) for name, value in values.items()}
    block["std"] = scientific(share * least) if share else "0"
    assert {"std-floor", "zero-std"} & audited(block, n=len(sample)).keys()


@pytest.mark.parametrize("side", ["low", "high"])
@given(sample=SPREAD_OUT)
def test_a_mean_pushed_out_of_reach_of_n_runs_is_caught(side: str, sample: np.ndarray) -> None:
    values, n = summary(sample), len(sample)
    best, worst = values["best"], values["worst"]
    low, high = (worst + (n - 1) * best) / n, (best + (n - 1) * worst) / n
    values["mean"] = 0.998 * low if side == "low" else 1.002 * high
    block = {name: scientific(values[name]) for name in ("best", "worst", "mean")}
    assert audited(block, n=n).keys() == {"mean-bound"}


@pytest.mark.parametrize(("name", "factor"), [("best", 1.002), ("worst", 0.998)])
@given(sample=SPREAD_OUT)
def test_an_extreme_pushed_past_the_mean_is_caught(
    name: str, factor: float, sample: np.ndarray
) -> None:
    values = summary(sample)
    values[name] = factor * values["mean"]
    block = {each: scientific(value) for each, value in values.items()}
    assert "mean-bound" in audited(block, n=len(sample))


@given(sample=SPREAD_OUT)
def test_a_best_pushed_past_the_worst_is_caught(sample: np.ndarray) -> None:
    worst = summary(sample)["worst"]
    block = {"best": scientific(1.002 * worst), "worst": scientific(worst)}
    assert audited(block, n=len(sample)).keys() == {"order"}


@given(sample=SPREAD_OUT, name=st.sampled_from(["best", "mean", "worst"]))
def test_a_number_pushed_below_the_minimum_is_caught(sample: np.ndarray, name: str) -> None:
    block = {each: scientific(value) for each, value in summary(sample).items()}
    block[name] = scientific(-summary(sample)[name])
    assert "below-minimum" in audited(block, n=len(sample))


@given(value=st.floats(-1e4, 1e4), decimals=st.integers(0, 4), cut_off=st.booleans())
def test_a_printed_number_spans_what_is_rounded_or_cut_off_to_it(
    *, value: float, decimals: int, cut_off: bool
) -> None:
    around = span(Printed(fixed(value, decimals, cut_off=cut_off)))
    assert around.low <= Fraction(value) <= around.high
    assert around.high - around.low < Fraction(2001, 1000) / 10**decimals


def test_what_doubles_flush_to_zero_is_not_held_against_a_table() -> None:
    flushed = {"best": "0", "worst": "1.000×10^-310", "mean": "0", "std": "0"}
    assert audited(flushed, n=2) == {}
    assert "mean-bound" in audited({**flushed, "worst": "1.000×10^-300"}, n=2)


def test_a_value_one_step_below_the_minimum_of_ackley_is_possible() -> None:
    # where exp(1) is rounded up, the four terms can cancel to less than 0
    assert audited({"best": scientific(-(2.0**-51))}, n=30, function="ackley") == {}
    assert audited({"best": scientific(-(2.0**-40))}, n=30, function="ackley") != {}


@given(samples())
def test_no_sample_spreads_more_than_the_widest(sample: np.ndarray) -> None:
    exact = [Fraction(float(value)) for value in sample]
    mean = sum(exact, Fraction(0)) / len(exact)
    squares = sum((value - mean) ** 2 for value in exact)
    bounds = [widest(len(exact), min(exact), high, Span(mean, mean)) for high in (max(exact), None)]
    assert all(bound is not None and squares <= bound.squares for bound in bounds)


@given(samples())
def test_no_sample_spreads_less_than_the_narrowest(sample: np.ndarray) -> None:
    exact = [Fraction(float(value)) for value in sample]
    mean = sum(exact, Fraction(0)) / len(exact)
    squares = sum((value - mean) ** 2 for value in exact)
    assert squares >= narrowest(len(exact), mean - min(exact), max(exact) - mean).squares


@given(st.integers(2, 40), st.fractions(0, 1), st.fractions(1, 2))
def test_the_widest_sample_has_the_spread_and_mean_that_it_says(
    n: int, low: Fraction, high: Fraction
) -> None:
    mean = low + (high - low) / 3
    sample = widest(n, low, high, Span(mean, mean))
    assert sample is not None
    values = [high] * sample.upper + [sample.between] + [low] * (n - sample.upper - 1)
    assert sum(values) == n * mean
    assert sum((value - mean) ** 2 for value in values) == sample.squares


@given(
    x=st.lists(st.floats(-1e-7, 1e-7), min_size=2, max_size=5).map(np.array),
    order=st.permutations(range(4)),
    in_pairs=st.booleans(),
)
def test_ackley_takes_no_value_between_its_steps_in_any_order_of_addition(
    *, x: np.ndarray, order: list[int], in_pairs: bool
) -> None:
    terms = (
        -20.0 * math.exp(-0.2 * math.sqrt(sum(x * x) / len(x))),
        -math.exp(sum(np.cos(2 * np.pi * x)) / len(x)),
        20.0,
        math.e,
    )
    a, b, c, d = (terms[i] for i in order)
    value = (a + b) + (c + d) if in_pairs else ((a + b) + c) + d
    block = {"best": scientific(abs(value)), "worst": scientific(abs(value))}
    assert audited(block, n=30, function="ackley") == {}


@pytest.mark.parametrize("name", ["sphere", "ackley", "rastrigin", "penalized_1", "shekel_5"])
@pytest.mark.parametrize("optimiser", [WOA(), GWO()])
def test_no_table_of_our_own_runs_is_impossible(name: str, optimiser: Optimiser) -> None:
    function = FUNCTIONS[name]
    problem = function.problem(None if function.fixed_dimension else 3)
    for seed in range(20):
        rng = np.random.default_rng(seed)
        costs = [
            optimiser.minimise(problem, population=6, iterations=10 * (seed + 1), rng=rng).cost
            for _ in range(10)
        ]
        block = {each: scientific(value) for each, value in summary(np.array(costs)).items()}
        assert audited(block, n=10, function=name) == {}


@pytest.mark.parametrize(("function", "step"), [("ackley", 2.0**-51), ("rastrigin", 2.0**-49)])
def test_a_mean_between_zero_and_one_step_of_one_run_is_impossible(
    function: str, step: float
) -> None:
    at = {"mean": scientific(1.01 * step / 30)}
    below = {"mean": scientific(0.9 * step / 30)}
    assert audited(at, n=30, function=function) == {}
    assert audited(below, n=30, function=function).keys() == {"double-step"}
    assert audited(below, n=30, function="sphere") == {}


def test_the_impossible_cells_of_liang_are_these() -> None:
    assert cells_of(LIANG, Grade.IMPOSSIBLE) == {
        *(("F1 Mean", name, "mean-bound") for name in ("IWOA", "WOA", "GWO", "PSO")),
        ("F1 Std", "PSO", "std-bound"),
        ("F1 Std", "PSO", "std-floor"),
        ("F5 Std", "WOA", "std-floor"),
        ("F10 Std", "DBO", "std-floor"),
        ("F12 Std", "PSO", "std-floor"),
    }


@pytest.mark.parametrize("algorithm", ["IWOA", "WOA", "PSO"])
def test_one_worst_run_in_thirty_exceeds_the_f1_means_of_liang(algorithm: str) -> None:
    worst, mean = TABLE_II["F1 Worst", algorithm], TABLE_II["F1 Mean", algorithm]
    # all other runs are at 0 or above, and 10 units of the last digit are more than rounding
    share = (worst.value - worst.rounding) / 30
    assert share > mean.value + 20 * (mean.rounding if mean.value else 0.0)
    assert ("F1 Mean", algorithm, "mean-bound") in cells_of(LIANG, Grade.IMPOSSIBLE)


@pytest.mark.parametrize(
    ("problem", "algorithm", "extreme"), [("F5", "WOA", "Worst"), ("F12", "PSO", "Worst"),
                                          ("F10", "DBO", "Best")],
)  # fmt: skip
def test_one_extreme_run_alone_exceeds_these_stds_of_liang(
    problem: str, algorithm: str, extreme: str
) -> None:
    far, mean, std = (TABLE_II[f"{problem} {name}", algorithm] for name in (extreme, "Mean", "Std"))
    distance = abs(far.value - mean.value) - far.rounding - 2 * mean.rounding
    # one value at this distance, 29 that balance it: distance² · 30/29, over 30
    assert distance / math.sqrt(29) > std.value + 2 * std.rounding


def test_the_f1_std_of_pso_in_liang_is_too_small_for_its_range_and_too_large_for_its_mean() -> None:
    best, worst, mean, std = (
        TABLE_II[f"F1 {name}", "PSO"] for name in ("Best", "Worst", "Mean", "Std")
    )
    assert std.value < 0.5 * (worst.value - best.value) / math.sqrt(2 * 30)
    assert std.value > 3 * math.sqrt(30) * mean.value


def test_a_mean_that_best_and_worst_forbid_is_not_held_against_the_std() -> None:
    # best, worst and spread of GWO on F1 are 0 and agree; only its mean is out of place
    rows = [row for row in LIANG if row.column == "GWO" and str(row.row).startswith("F1 ")]
    assert [row.check for row in rows] == ["mean-bound"]


def test_the_inconsistent_places_of_liang_are_these() -> None:
    rows = [row for row in LIANG if row.grade is Grade.INCONSISTENT]
    assert [(row.check, row.table) for row in rows] == [
        ("arm-links", "Table III"),
        ("rank-in-text", "Table II"),
        ("rank-in-text", "Table II"),
        ("percentage", "Table VI"),
        ("poses", "Table IV"),
    ]


def test_numbers_that_recur_in_liang_are_noted_but_not_the_least_double_of_ackley() -> None:
    repeats = {row.explanation.split()[0] for row in LIANG if row.check == "repeat"}
    assert repeats == {TABLE_II["F1 Worst", "WOA"].text, TABLE_II["F1 Mean", "GWO"].text}


def test_a_spread_of_rounding_names_the_number_of_runs_that_gives_it() -> None:
    value = 27.25
    off = value + 2 * math.ulp(value)
    std = math.sqrt(20 * (off - value) ** 2 / 19)
    block = {"mean": scientific(value), "std": scientific(std)}
    (row,) = audit(paper_of({"A": block}, n=30))
    assert (row.check, row.grade) == ("std-at-rounding", Grade.NOTED)
    assert "k = 2 and n = 20" in row.explanation


def test_digits_that_recur_with_other_powers_are_noted_for_whole_blocks() -> None:
    blocks = {"A": {"mean": "3.71×10^-4", "std": "2.83×10^-5"}}
    blocks["B"] = {"mean": "3.71×10^-7", "std": "2.83×10^-9"}
    (row,) = audit(paper_of(blocks, n=30))
    assert (row.check, row.row, len(row.cells)) == ("repeat-digits", None, 4)


def test_a_value_that_the_function_has_at_its_minimiser_may_recur() -> None:
    least = scientific(FUNCTIONS["ackley"](np.zeros(30)))
    blocks = {name: {"best": least, "mean": least} for name in ("A", "B")}
    assert audit(paper_of(blocks, n=30, function="ackley")) == ()


def test_only_a_printed_time_below_the_certificate_is_impossible() -> None:
    (certificate,) = certify(doe2021.PAPER)
    assert certificate.minimum is not None
    rows = [row.column or row.row for row in audit(doe2021.PAPER) if row.check == "time-bound"]
    below = [p.label for p in certificate.printed if p.time + 0.1 < certificate.minimum]
    assert len(below) == len(rows) == 1
