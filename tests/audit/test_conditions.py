"""What a row of the audit takes for granted: said as its condition, or nothing."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from papers.liang2026 import PAPER as LIANG
from papers.smwoa2022 import PAPER as SMWOA
from papers.syji import PAPER as SYJI
from repro.audit import AuditRow, Grade, audit
from repro.audit.blocks import bounds_of
from repro.functions import FUNCTIONS, Known
from repro.model.paper import Paper
from repro.tables.arithmetic import IN_DOUBLES
from tests.small_papers import Bowl
from tests.summaries import audited, condition_of, paper_of, proved, scientific

Singles = NDArray[np.float32]
WHOLE = "no digit of a whole number is rounded away"
ZERO = "a bare 0 stands for what the arithmetic rounds to 0, not for a small number"
UNKNOWN = Bowl()  # a problem of which nothing is known
F = np.float32


def one_by_one(values: Singles) -> np.float32:
    """Return the sum in the order of the runs, rounded at every step."""
    total = F(0)
    for value in values:
        total = F(total + value)
    return total


SUMS: tuple[Callable[[Singles], np.float32], ...] = (
    one_by_one,
    lambda x: one_by_one(x[::-1]),
    lambda x: one_by_one(np.sort(x)),
    lambda x: F(x.sum()),  # in pairs
    lambda x: F(math.fsum(x.tolist())),
)
SINGLES = st.one_of(
    st.floats(-(2.0**20), 2.0**20, width=32),
    st.floats(0, 2.0**50, width=32),
    st.integers(0, 8).map(lambda k: 0.125 + k * 2.0**-26),  # last bits only
    st.sampled_from([0.0, 1e-45, 1e-38, 1e-30, 1e-25, 1e-20, 1e-10]),
)


@given(
    sample=st.lists(SINGLES, min_size=2, max_size=40),
    total=st.sampled_from(SUMS),
    ddof=st.integers(0, 1),
    digits=st.integers(2, 9),
    kept=st.sets(st.sampled_from(["best", "worst", "mean", "std"]), min_size=2),
    cut_off=st.booleans(),
)
def test_no_table_of_runs_in_single_precision_is_impossible_without_a_condition(
    *,
    sample: list[float],
    total: Callable[[Singles], np.float32],
    ddof: int,
    digits: int,
    kept: set[str],
    cut_off: bool,
) -> None:
    runs = np.array(sample, dtype=F)
    n = F(len(runs))
    mean = F(total(runs) / n)
    squares = (runs - mean) ** 2
    values = {
        "best": runs.min(),
        "worst": runs.max(),
        "mean": mean,
        "std": np.sqrt(F(total(squares) / F(n - ddof))),
    }
    assert all(np.isfinite(value) for value in values.values())
    block = {name: scientific(float(values[name]), digits, cut_off=cut_off) for name in kept}

    assert [row.check for row in rows_on(UNKNOWN, block, n=len(runs)) if row.is_proof] == []


def rows_on(problem: object, block: dict[str, str], *, n: int) -> tuple[AuditRow, ...]:
    """Return the audit of one block on a problem."""
    paper = paper_of({"A": block}, n=n)
    experiments = tuple(replace(each, problems={"F": problem}) for each in paper.experiments)
    return audit(replace(paper, experiments=experiments))


def ackley(x: Singles) -> float:
    """Return Ackley's function with every step in single precision."""
    n = F(len(x))
    away, waves = F((x * x).sum()) / n, F(np.cos(F(2 * math.pi) * x).sum()) / n
    return float(-F(20) * np.exp(-F(0.2) * np.sqrt(away)) - np.exp(waves) + F(20) + F(math.e))


def goldstein_price(x: Singles) -> float:
    """Return Goldstein and Price's function with every step in single precision."""
    u, v = x
    first = F(19) - F(14) * u + F(3) * u * u - F(14) * v + F(6) * u * v + F(3) * v * v
    second = F(18) - F(32) * u + F(12) * u * u + F(48) * v - F(36) * u * v + F(27) * v * v
    near, far = u + v + F(1), F(2) * u - F(3) * v
    return float((F(1) + near * near * first) * (F(30) + far * far * second))


@pytest.mark.parametrize("kernel", [ackley, goldstein_price])
@given(seed=st.integers(0, 2**32 - 1), power=st.integers(-9, -1))
def test_no_run_in_single_precision_lies_below_the_floor_for_it(
    kernel: Callable[[Singles], float], seed: int, power: int
) -> None:
    problem = FUNCTIONS[kernel.__name__].problem(None if kernel is goldstein_price else 30)
    best = problem.function.minimiser(problem.dimension)
    x = best + np.random.default_rng(seed).normal(size=problem.dimension) * 10.0**power

    assert kernel(x.astype(F)) >= bounds_of(problem).floor_in_singles


def test_a_spread_that_squares_of_single_precision_flush_to_zero_needs_doubles() -> None:
    block = {"best": "0.00×10^0", "worst": "1.00×10^-25", "std": "0.00×10^0"}
    assert condition_of(block, n=2) == IN_DOUBLES
    assert condition_of(block | {"best": "0"}, n=2) == f"{IN_DOUBLES}, and {ZERO}"
    assert proved(block | {"worst": "1.00×10^-15"}, n=2) == {"zero-std"}


def test_a_mean_that_single_precision_flushes_to_zero_needs_doubles() -> None:
    block = {"best": "0.00×10^0", "mean": "0.00×10^0", "worst": "1.00×10^-39"}
    assert condition_of(block, n=2) == IN_DOUBLES
    assert proved(block | {"worst": "1.00×10^-30"}, n=2) == {"mean-bound"}


def test_equal_runs_may_have_the_spread_that_the_rounding_of_their_mean_gives() -> None:
    runs = np.full(30, 0.1, dtype=F)
    away = runs - F(one_by_one(runs) / F(30))
    spread = float(np.sqrt(F((away * away).sum() / F(29))))
    block = {name: scientific(float(runs[0]), 10) for name in ("best", "worst")}
    assert spread > 1e-9
    assert condition_of(block | {"std": scientific(spread)}, n=30) == IN_DOUBLES
    assert condition_of(block | {"std": scientific(1000 * spread)}, n=30) == IN_DOUBLES
    assert proved(block | {"std": "1.000×10^-1"}, n=30) == {"std-bound"}


def test_numbers_that_single_precision_cannot_hold_prove_doubles() -> None:
    block = {"mean": "3.00×10^-60", "std": "3.00×10^-57"}
    assert proved(block, n=30) == {"std-bound"}


def test_a_bare_zero_among_powers_of_ten_may_stand_for_a_small_number() -> None:
    block = {"worst": "7.294×10^-287", "mean": "0"}
    assert condition_of(block | {"best": "0"}, n=30) == ZERO
    assert proved(block | {"mean": "0.000×10^0", "best": "0"}, n=30) == {"mean-bound"}
    assert proved(block | {"mean": "1.000×10^-289", "best": "0"}, n=30) == {"mean-bound"}


def test_the_last_digits_of_a_whole_number_may_be_rounded_away() -> None:
    block = {"best": "12340", "mean": "12350", "worst": "12350", "std": "4.123"}
    assert condition_of(block, n=30) == f"{IN_DOUBLES}, and {WHOLE}"
    assert proved(block | {"std": "412.3"}, n=30) == {"std-bound"}
    assert proved({"best": "100", "worst": "90"}, n=30) == {"order"}
    assert condition_of({"best": "187", "mean": "190", "worst": "188"}, n=30) == WHOLE


def test_a_minimum_of_the_box_alone_binds_no_run_that_may_leave_it() -> None:
    own = replace(FUNCTIONS["shekel_5"], known=Known()).problem()
    inside, everywhere = (
        rows_on(problem, {"best": "-99.0"}, n=30)
        for problem in (own, FUNCTIONS["shekel_5"].problem())
    )
    assert [row.condition for row in inside] == ["every run ends inside the box"]
    assert [row.condition for row in everywhere] == [None]


@pytest.mark.parametrize("function", ["ackley", "rastrigin"])
def test_a_step_between_doubles_holds_for_an_order_of_summing_only(function: str) -> None:
    condition = condition_of({"best": "1.00×10^-20"}, n=30, function=function)
    assert "added" in str(condition)


@pytest.mark.parametrize("table", [{"mean": "-6123.1", "std": "-4087.44"}, {"std": "-1.03163"}])
@pytest.mark.parametrize("n", [1, 30])
def test_a_negative_std_is_impossible_whatever_is_known_of_the_function(
    table: dict[str, str], n: int
) -> None:
    rows = rows_on(UNKNOWN, table, n=n)
    assert [(row.check, row.condition) for row in rows] == [("negative-std", None)]
    assert rows_on(UNKNOWN, {"mean": "-6123.1", "std": "-0.00"}, n=n) == ()


def test_cells_of_a_problem_that_no_experiment_runs_are_audited_all_the_same() -> None:
    paper = paper_of({"A": {"best": "2.0", "mean": "1.0", "std": "-1.0"}}, n=30)
    (experiment,) = paper.experiments
    bare = replace(experiment, problems={}, algorithms={})
    # a paper refuses claims on runs that it does not have, unless something says why
    object.__setattr__(paper, "experiments", (bare,))
    assert [row.check for row in audit(paper)] == ["mean-bound", "negative-std"]


@pytest.mark.parametrize("name", ["best", "mean", "median", "worst"])
def test_a_statistic_below_a_minimum_that_is_negative_is_impossible(name: str) -> None:
    assert proved({name: "-10.1600"}, n=30, function="shekel_5") == {"below-minimum"}
    assert audited({name: "-10.1532"}, n=30, function="shekel_5") == {}
    assert condition_of({name: "-10.153205"}, n=30, function="shekel_5") == IN_DOUBLES


def conditions(paper: Paper) -> dict[str, str]:
    """Return the conditions of what is impossible, by place."""
    rows = [row for row in audit(paper) if row.grade is Grade.IMPOSSIBLE]
    return {f"{row.row} {row.column}": row.condition for row in rows if row.condition}


def test_conditional_rows_of_the_papers_are_these() -> None:
    liang, smwoa = conditions(LIANG), conditions(SMWOA)
    assert liang == {
        **dict.fromkeys(("F1 Mean IWOA", "F1 Mean GWO"), ZERO),
        # in single precision the squares of nearly equal runs cancel
        **dict.fromkeys(("F5 Std WOA", "F12 Std PSO"), IN_DOUBLES),
    }
    doubles = {place for place, condition in smwoa.items() if condition == IN_DOUBLES}
    assert doubles == {"F7 Std WOA", "F13 Std SMA"}
    assert smwoa.keys() - doubles == {
        *("F6 Avg SMWOA", "F6 Avg WOA", "F7 Avg SMWOA", "F7 Avg SMA"),
    }
    assert [row.condition for row in audit(SYJI) if row.grade is Grade.IMPOSSIBLE] == [
        "every joint is at rest at start and end, and keeps the printed limits"
    ]


def test_a_namesake_of_a_known_function_has_none_of_its_bounds() -> None:
    namesake = replace(FUNCTIONS["sphere"], kernel=FUNCTIONS["rosenbrock"].kernel)
    rows = rows_on(namesake.problem(30), {"best": "1.0e+09"}, n=30)
    assert rows == ()
    assert proved({"best": "1.0e+09"}, n=30) == {"above-ceiling"}
