from collections.abc import Callable
from statistics import fmean, stdev

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.statistics.effect_size import win_probability
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.statistics.summary import STATISTICS, best, mean, standard_deviation, worst

Vector = NDArray[np.float64]

COSTS = st.lists(st.floats(0.0, 1e6), min_size=2, max_size=12)
# few and many equal values, so that ties are common
SAMPLE = st.lists(st.integers(0, 6), min_size=1, max_size=9)


def test_single_value_is_the_first_of_each_table() -> None:
    assert STATISTICS["single"](np.array([[3.0, 1.0], [2.0, 9.0]])).tolist() == [3.0, 2.0]


@pytest.mark.parametrize("n", [3, 10, 30, 50])
@pytest.mark.parametrize("value", [1.1, 0.1, 4.440892098500626e-16, 7e-290, 1e300, 0.0, -3.3])
def test_equal_values_have_themselves_as_mean_and_no_spread(value: float, n: int) -> None:
    costs = np.full(n, value)

    assert float(mean(costs)) == value
    assert float(standard_deviation(costs)) == 0.0


@given(COSTS)
def test_summary_is_that_of_the_standard_library(costs: list[float]) -> None:
    table = np.array(costs)

    assert float(best(table)) == min(costs)
    assert float(worst(table)) == max(costs)
    assert float(mean(table)) == pytest.approx(fmean(costs), rel=1e-12)
    rounding = 1e-12 * max(costs)
    assert float(standard_deviation(table)) == pytest.approx(stdev(costs), rel=1e-9, abs=rounding)


@pytest.mark.parametrize("statistic", STATISTICS.values(), ids=STATISTICS)
@given(
    costs=st.lists(st.integers(-1000, 1000), min_size=2, max_size=9), power=st.integers(-980, 980)
)
def test_scaling_by_a_power_of_two_is_exact(
    statistic: Callable[[Vector], Vector], costs: list[int], power: int
) -> None:
    table = np.array(costs, dtype=np.float64)

    scaled = statistic(np.ldexp(table, power))

    assert float(scaled) == float(np.ldexp(statistic(table), power))


def test_spread_of_tiny_values_does_not_underflow() -> None:
    # n values 1 to n have the sample variance n (n + 1) / 12
    costs = 1e-301 * np.arange(1.0, 31.0)

    assert float(standard_deviation(costs)) == pytest.approx(
        1e-301 * np.sqrt(30 * 31 / 12), abs=0.0
    )


@pytest.mark.parametrize("lower", [1, 4, 15, 23, 29])
def test_spread_of_values_that_differ_in_the_last_digit_is_exact(lower: int) -> None:
    low = float.fromhex("-0x1.ee6fa53a3b3c8p+1")  # where runs on F14 end, it or the next double
    costs = np.array([low] * lower + [low + 2.0**-51] * (30 - lower))

    exact = 2.0**-51 * (lower * (30 - lower) / (30 * 29)) ** 0.5
    assert float(standard_deviation(costs)) == pytest.approx(exact, rel=1e-9, abs=0.0)


def test_spread_of_huge_values_does_not_overflow() -> None:
    assert float(standard_deviation(np.array([0.0, 1.6e308]))) == pytest.approx(1.6e308 / 2**0.5)
    assert float(mean(np.array([1.6e308, 1.4e308]))) == pytest.approx(1.5e308)


def test_summary_runs_along_the_last_axis() -> None:
    tables = np.array([[1.0, 2.0, 6.0], [5.0, 5.0, 5.0]])

    assert best(tables).tolist() == [1.0, 5.0]
    assert worst(tables).tolist() == [6.0, 5.0]
    assert mean(tables) == pytest.approx([3.0, 5.0])
    assert standard_deviation(tables) == pytest.approx([7.0**0.5, 0.0])


# R's wilcox.test(exact = FALSE) and MATLAB's ranksum print these for two samples without overlap
SEPARATED = {30: 3.019859e-11, 20: 6.795615e-08, 10: 1.826718e-04}
ONE_CONSTANT = {30: 1.211780e-12, 20: 8.006504e-09, 10: 6.386437e-05}
BOTH_CONSTANT = {30: 1.685298e-14}


@pytest.mark.parametrize(("n", "p"), SEPARATED.items())
def test_separated_samples_have_the_p_value_that_papers_print(n: int, p: float) -> None:
    x, y = np.arange(float(n)), 100.0 + np.arange(float(n))

    assert rank_sum_p(x, y) == pytest.approx(p, rel=1e-4, abs=0.0)


@pytest.mark.parametrize(("n", "p"), ONE_CONSTANT.items())
def test_constant_sample_below_another_has_the_p_value_that_papers_print(n: int, p: float) -> None:
    assert rank_sum_p(np.zeros(n), 1.0 + np.arange(float(n))) == pytest.approx(p, rel=1e-4, abs=0.0)


@pytest.mark.parametrize(("n", "p"), BOTH_CONSTANT.items())
def test_two_constant_samples_have_the_p_value_that_papers_print(n: int, p: float) -> None:
    assert rank_sum_p(np.zeros(n), np.ones(n)) == pytest.approx(p, rel=1e-4, abs=0.0)


@given(SAMPLE)
def test_sample_does_not_differ_from_itself(sample: list[int]) -> None:
    x = np.array(sample, dtype=np.float64)

    assert rank_sum_p(x, x) == 1.0
    assert rank_sum_p(x, x[::-1].copy()) == 1.0


@given(SAMPLE, SAMPLE)
def test_rank_sum_looks_at_the_order_alone(first: list[int], second: list[int]) -> None:
    x, y = np.array(first, dtype=np.float64), np.array(second, dtype=np.float64)

    p = rank_sum_p(x, y)

    assert 0.0 < p <= 1.0
    assert rank_sum_p(y, x) == pytest.approx(p, rel=1e-12)
    assert rank_sum_p(np.exp(x), np.exp(y)) == p


def test_holm_is_that_of_the_literature() -> None:
    # R's p.adjust with method "holm" gives these
    assert holm(np.array([0.01, 0.02, 0.04, 0.5])) == pytest.approx([0.04, 0.06, 0.08, 0.5])
    assert holm(np.array([0.5, 0.04, 0.01, 0.02])) == pytest.approx([0.5, 0.08, 0.04, 0.06])


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=10))
def test_holm_lies_between_the_single_and_the_bonferroni_p_value(p_values: list[float]) -> None:
    p = np.array(p_values)

    corrected = holm(p)

    assert (p <= corrected).all()
    assert (corrected <= np.minimum(len(p) * p, 1.0)).all()
    assert float(corrected.min()) == pytest.approx(min(1.0, len(p) * float(p.min())))
    assert (np.diff(corrected[np.argsort(p, kind="stable")]) >= 0.0).all()


@given(SAMPLE, SAMPLE)
def test_win_probability_counts_ties_as_half(first: list[int], second: list[int]) -> None:
    wins = sum((a < b) + 0.5 * (a == b) for a in first for b in second)

    found = win_probability(np.array(first, dtype=float), np.array(second, dtype=float))

    assert found == pytest.approx(wins / (len(first) * len(second)), abs=1e-12)
