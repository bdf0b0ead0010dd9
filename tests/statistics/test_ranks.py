"""The tests of difference, against values that R, MATLAB and the literature give."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.stats import bootstrap, mannwhitneyu

from repro.errors import InputError
from repro.statistics.effect_size import win_interval, win_probability
from repro.statistics.friedman import critical_difference, friedman, not_told_apart
from repro.statistics.rank_sum import rank_sum_p, rank_sums
from repro.statistics.signed_rank import signed_rank_p

Vector = NDArray[np.float64]
SAMPLE = st.lists(st.integers(0, 6), min_size=1, max_size=9)

# Hollander and Wolfe (1973), the examples on the help pages of R's wilcox.test and friedman.test
PERMEABILITY = (
    np.array([0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46]),
    np.array([1.15, 0.88, 0.90, 0.74, 1.21]),
)
DEPRESSION = (
    np.array([1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30]),
    np.array([0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29]),
)
ROUNDING_TIMES = np.array(
    [
        [5.40, 5.50, 5.55], [5.85, 5.70, 5.75], [5.20, 5.60, 5.50], [5.55, 5.50, 5.40],
        [5.90, 5.85, 5.70], [5.45, 5.55, 5.60], [5.40, 5.40, 5.35], [5.45, 5.50, 5.35],
        [5.25, 5.15, 5.00], [5.85, 5.80, 5.70], [5.25, 5.20, 5.10], [5.65, 5.55, 5.45],
        [5.60, 5.35, 5.45], [5.05, 5.00, 4.95], [5.50, 5.50, 5.40], [5.45, 5.55, 5.50],
        [5.55, 5.55, 5.35], [5.45, 5.50, 5.55], [5.50, 5.45, 5.25], [5.65, 5.60, 5.40],
        [5.70, 5.65, 5.55], [6.30, 6.30, 6.25],
    ]
)  # fmt: skip


def test_rank_sum_of_few_untied_values_is_exact() -> None:
    # R prints p = 0.1272 for one side, and doubles it: 764 / 3003 of the orders of 10 and 5
    assert rank_sum_p(*PERMEABILITY) == pytest.approx(764 / 3003, rel=1e-12)


@pytest.mark.parametrize(
    ("n", "m", "p"),
    [
        (9, 9, 2 / 48620),  # exact: 2 of the 18! / (9! 9!) orders
        (4, 15, 2 / 3876),
        (10, 10, 1.826718e-04),  # 20 values: R's wilcox.test(exact = FALSE)
    ],
)
def test_rank_sum_is_exact_below_twenty_values_as_ranksum_is(n: int, m: int, p: float) -> None:
    assert rank_sum_p(np.arange(float(n)), np.arange(50.0, 50.0 + m)) == pytest.approx(p, rel=1e-4)


def test_rank_sum_of_few_tied_values_is_approximate() -> None:
    # by hand: U = 0.5 about 2, z = (1.5 - 0.5) / sqrt(4 / 12 · (5 - 6 / 12))
    x, y = np.array([1.0, 2.0]), np.array([2.0, 3.0])

    assert rank_sum_p(x, y) == pytest.approx(0.41421618, rel=1e-6)


def test_signed_rank_of_few_pairs_is_that_of_r() -> None:
    x, y = DEPRESSION

    assert signed_rank_p(x - y) == 0.01953125  # R prints 0.01953; 10 of 512 signs


def test_signed_rank_of_many_pairs_that_all_rise_is_that_of_r() -> None:
    # z = (915 - 0.5) / sqrt(60 · 61 · 121 / 24), as wilcox.test(1:60, alternative = "greater")
    assert signed_rank_p(np.arange(1.0, 61.0)) == pytest.approx(8.35664e-12, rel=1e-5, abs=0.0)


@pytest.mark.parametrize("zeros", [0, 3, 40])
def test_pairs_without_a_difference_are_left_out(zeros: int) -> None:
    differences = np.concatenate([np.zeros(zeros), np.ones(30)])

    # z = (232.5 - 0.5) / sqrt(30 · 31 · 61 / 24 - 30 · 899 / 48)
    assert signed_rank_p(differences) == pytest.approx(2.30871e-08, rel=1e-5, abs=0.0)


def test_pairs_that_are_all_equal_do_not_differ() -> None:
    assert signed_rank_p(np.zeros(30)) == 1.0


@given(st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=60))
def test_signed_rank_looks_to_one_side(values: list[float]) -> None:
    differences = np.array(values)
    up, down = signed_rank_p(differences), signed_rank_p(-differences)

    assert 0.0 < up <= 1.0
    assert up + down >= 1.0


def interval(x: Vector, y: Vector, seed: int = 1) -> tuple[float, float]:
    return win_interval(x, y, rng=np.random.default_rng(seed))


def test_win_interval_is_that_of_scipys_bootstrap() -> None:
    rng = np.random.default_rng(8)
    x, y = rng.normal(size=30), rng.normal(0.6, 1.0, size=25)

    def wins(a: Vector, b: Vector, axis: int) -> Vector:  # noqa: ARG001 (scipy passes the axis)
        return np.asarray((a[..., :, None] < b[..., None, :]).mean(axis=(-1, -2)))

    expected = bootstrap(
        (x, y), wins, n_resamples=20_000, method="percentile", rng=np.random.default_rng(2)
    ).confidence_interval

    # a 2.5 % quantile of 1000 draws has a standard error of about 0.012 where their SD is 0.07
    assert interval(x, y) == pytest.approx(tuple(expected), abs=0.04)


@given(SAMPLE, SAMPLE)
def test_win_interval_looks_at_the_order_alone(first: list[int], second: list[int]) -> None:
    x, y = np.array(first, dtype=np.float64), np.array(second, dtype=np.float64)
    low, high = interval(x, y)

    assert interval(np.exp(x), np.exp(y)) == (low, high)
    assert 0.0 <= low <= high <= 1.0


@given(SAMPLE, SAMPLE)
def test_win_interval_holds_the_win_probability(first: list[int], second: list[int]) -> None:
    x, y = np.array(first, dtype=np.float64), np.array(second, dtype=np.float64)
    low, high = interval(x, y)

    assert low - 1e-12 <= win_probability(x, y) <= high + 1e-12


def test_equal_state_gives_an_equal_interval_and_another_state_another() -> None:
    x, y = np.random.default_rng(5).normal(size=(2, 30))

    assert interval(x, y) == interval(x, y)
    assert interval(x, y) != interval(x, y, seed=2)


@pytest.mark.parametrize(
    ("x", "y", "expected"), [(0.0, 1.0, (1, 1)), (1.0, 0.0, (0, 0)), (0.0, 0.0, (0.5, 0.5))]
)
def test_constant_samples_have_an_interval_of_one_point(
    x: float, y: float, expected: tuple[float, float]
) -> None:
    assert interval(np.full(30, x), np.full(30, y)) == expected


def test_friedman_is_that_of_r() -> None:
    found = friedman(ROUNDING_TIMES)

    assert found.p == pytest.approx(0.003805, abs=5e-7)  # R prints 0.003805
    assert found.ranks == pytest.approx((53 / 22, 47 / 22, 32 / 22))


def test_friedman_of_problems_on_which_all_tie_finds_nothing() -> None:
    found = friedman(np.zeros((5, 4)))

    assert found.ranks == (2.5, 2.5, 2.5, 2.5)
    assert found.p == 1.0


@pytest.mark.parametrize("shape", [(1, 3), (5, 2)])
def test_friedman_refuses_what_has_no_such_test(shape: tuple[int, int]) -> None:
    with pytest.raises(InputError, match="2 problems and 3 algorithms"):
        friedman(np.zeros(shape))


# Demšar (2006), Table 5 (a): q for alpha = 0.05, rounded or cut off in the third decimal
@pytest.mark.parametrize(
    ("algorithms", "q"),
    [(2, 1.960), (3, 2.343), (4, 2.569), (5, 2.728), (6, 2.850), (7, 2.949), (10, 3.164)],
)
def test_critical_difference_is_that_of_demsar(algorithms: int, q: float) -> None:
    expected = q * (algorithms * (algorithms + 1) / (6 * 15)) ** 0.5

    assert critical_difference(algorithms, 15) == pytest.approx(expected, rel=5e-4)


def test_critical_difference_shrinks_with_the_number_of_problems() -> None:
    assert friedman(ROUNDING_TIMES).critical_difference == pytest.approx(
        critical_difference(3, 1) / 22**0.5
    )


def test_ranks_nearer_than_the_critical_difference_are_one_group() -> None:
    ranks = (3.0, 1.0, 1.8, 5.0, 3.5)

    assert not_told_apart(ranks, 1.5) == ((1, 2), (2, 0), (0, 4))
    assert not_told_apart(ranks, 1.8) == ((1, 2), (2, 0, 4), (4, 3))
    assert not_told_apart(ranks, 0.1) == ()


@given(st.lists(st.floats(1.0, 6.0), min_size=2, max_size=7), st.floats(0.1, 4.0))
def test_two_algorithms_share_a_group_where_they_are_near(
    values: list[float], difference: float
) -> None:
    ranks = tuple(values)
    groups = not_told_apart(ranks, difference)

    for a in range(len(ranks)):
        for b in range(a):
            together = any({a, b} <= set(group) for group in groups)
            low, high = sorted((ranks[a], ranks[b]))
            assert together == (high - low < difference)


@pytest.mark.parametrize("ends", [(0.0, 1.0), (-np.inf, np.inf)])
def test_rank_sums_of_rows_are_those_of_scipy_to_the_last_bit(ends: tuple[float, float]) -> None:
    rng = np.random.default_rng(7)
    for n, m, kinds in ((1, 1, 2), (3, 40, 5), (30, 30, 4), (60, 45, 90)):
        values = np.append(rng.lognormal(0.0, 3.0, kinds), ends)
        x, y = rng.choice(values, (50, n)), rng.choice(values, (50, m))
        x[0], y[0] = 1.0, 1.0
        with np.errstate(invalid="ignore", divide="ignore"):
            expected = mannwhitneyu(x, y, method="asymptotic", axis=-1)
        p, lower = rank_sums(x, y)
        assert p.tolist() == np.where(np.isnan(expected.pvalue), 1.0, expected.pvalue).tolist()
        assert lower.tolist() == (expected.statistic < 0.5 * n * m).tolist()
