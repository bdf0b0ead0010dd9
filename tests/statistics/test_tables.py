from collections.abc import Callable
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.statistics.summary import best, mean, standard_deviation, worst
from repro.statistics.tables import REACH, next_tables, predicted, quantile_interval

Vector = NDArray[np.float64]

COSTS = st.lists(st.floats(0.0, 1e6), min_size=2, max_size=12)
# few and many equal values, and some decades apart
QUANTISED = st.lists(st.sampled_from([-2.0, 0.0, 1.1, 1.2, 700.0]), min_size=2, max_size=9)
FLOOR = -3.86278214782


def tables_of(
    costs: list[float] | Vector, *, seed: int = 1, tables: int = 50, floor: float = -np.inf
) -> Vector:
    """Return tables after one repeat, or after those that an array has."""
    values = np.array(costs, ndmin=2)
    return next_tables(values, tables=tables, rng=np.random.default_rng(seed), ends=(floor, np.inf))


def normal(repeats: int, n: int) -> Vector:
    return np.random.default_rng(2).normal(100.0, 5.0, size=(repeats, n))


def decades(repeats: int, n: int) -> Vector:
    return np.random.default_rng(2).lognormal(0.0, 5.0, size=(repeats, n))


@pytest.mark.parametrize("costs", [normal, decades], ids=["narrow", "decades"])
@pytest.mark.parametrize(("repeats", "n"), [(1, 30), (4, 5), (10, 30), (20, 30)])
def test_new_best_and_worst_lie_beyond_all_stored_runs_by_chance(
    costs: Callable[[int, int], Vector], repeats: int, n: int
) -> None:
    stored, tables = costs(repeats, n), 8000
    found = tables_of(stored, tables=tables)

    # of N + n runs that nothing tells apart the first is one of the n new ones with this chance
    chance = n / (repeats * n + n)
    standard_error = (chance * (1.0 - chance) / tables) ** 0.5
    lower = float((best(found) < stored.min()).mean())
    higher = float((worst(found) > stored.max()).mean())
    assert found.shape == (tables, n)
    assert lower == pytest.approx(chance, abs=5 * standard_error)
    assert higher == pytest.approx(chance, abs=5 * standard_error)


@pytest.mark.parametrize(("repeats", "n"), [(1, 1000), (2, 500), (4, 250)])
def test_mean_varies_by_both_samples(repeats: int, n: int) -> None:
    stored, tables = normal(repeats, n), 4000

    found = predicted(stored, mean, tables=tables, rng=np.random.default_rng(1))

    # the 2 in 1001 runs beyond the stored ones add some 5 %; the standard error is 2.2 %, and a
    # sample that does not count takes 20 % at the least
    expected = float(stored.var(ddof=1)) * (1 / n + 1 / stored.size)
    assert float(found.var()) == pytest.approx(1.05 * expected, rel=0.11)


@given(st.floats(-1e300, 1e300), st.integers(2, 60), st.sampled_from([-np.inf, FLOOR, 0.0]))
def test_equal_runs_give_equal_tables(value: float, n: int, floor: float) -> None:
    assert np.unique(tables_of([value] * n, floor=floor)).tolist() == [value]


@pytest.mark.parametrize(("floor", "low"), [(-np.inf, 0.0), (1.0, 1.0)])
def test_one_run_says_nothing_of_how_far_others_lie(floor: float, low: float) -> None:
    found = tables_of([3.0], tables=200, floor=floor)

    assert np.unique(found).tolist() == [low, np.inf]
    assert quantile_interval(found[:, 0], 0.95) == (low, np.inf)


def test_no_new_run_lies_above_the_ceiling_unless_stored_ones_do() -> None:
    stored = np.logspace(-10.0, 0.0, 30).reshape(1, 30)

    for ceiling, greatest in ((5.0, 5.0), (0.1, 1.0)):
        found = next_tables(stored, tables=500, rng=np.random.default_rng(1), ends=(0.0, ceiling))
        assert found.max() == greatest


@pytest.mark.parametrize("floor", [-np.inf, 0.0])
@given(costs=st.lists(st.sampled_from([1e-300, 1e-9, 0.3, 4.0]), max_size=8))
def test_zeros_stay_zeros(costs: list[float], floor: float) -> None:
    found = tables_of([0.0, 0.0, *costs], floor=floor)

    # nothing lies between 0 and the least run that is not 0
    assert (found >= 0.0).all()
    assert (found[found > 0.0] >= min(costs, default=np.inf)).all()


@given(COSTS, st.integers(0, 99))
def test_no_run_is_below_the_floor(costs: list[float], seed: int) -> None:
    found = tables_of(FLOOR + np.array(costs), seed=seed, floor=FLOOR)

    assert (found >= FLOOR).all()


@given(COSTS)
def test_where_runs_lie_below_the_floor_no_other_lies_lower(costs: list[float]) -> None:
    stored = FLOOR - np.array(costs)

    assert tables_of(stored, floor=FLOOR).min() >= stored.min()


@given(COSTS, st.randoms(use_true_random=False), st.integers(0, 99))
def test_order_of_the_stored_runs_does_not_matter(
    costs: list[float], shuffling: Random, seed: int
) -> None:
    other = list(costs)
    shuffling.shuffle(other)

    assert tables_of(other, seed=seed).tolist() == tables_of(costs, seed=seed).tolist()


def test_repeats_are_all_the_same_to_new_runs() -> None:
    stored = normal(3, 4)

    assert tables_of(stored[::-1]).tolist() == tables_of(stored).tolist()


def test_equal_state_gives_equal_tables_and_another_state_others() -> None:
    stored = normal(2, 5)

    assert tables_of(stored, seed=1).tolist() == tables_of(stored, seed=1).tolist()
    assert tables_of(stored, seed=1).tolist() != tables_of(stored, seed=2).tolist()


@given(QUANTISED, st.integers(0, 99))
def test_between_stored_runs_only_their_values_come_again(costs: list[float], seed: int) -> None:
    found = tables_of(costs, seed=seed)

    inside = found[(found >= min(costs)) & (found <= max(costs))]
    assert set(inside.tolist()) <= set(costs)


def test_stored_runs_come_equally_often_and_the_last_half_as_often() -> None:
    stored = np.arange(100.0, 120.0)
    found = tables_of(stored.reshape(4, 5), tables=20_000)

    # each takes half of the gaps on either side, and half of those at the ends is beyond them all;
    # runs of one table share their chances, so that a share varies by 0.0007 or so
    shares = [(found == value).mean() for value in stored]
    assert shares == pytest.approx([0.5 / 21, *[1 / 21] * 18, 0.5 / 21], abs=0.004)


@pytest.mark.parametrize("size", [30, 600])
def test_worst_goes_beyond_the_stored_by_the_reach_of_mean_excesses(size: int) -> None:
    stored = np.linspace(11.0, 12.0, size)  # half of them lie above the median, by 1/4 on average
    found = tables_of(stored, tables=4000)

    over, under = found[found > 12.0] - 12.0, 11.0 - found[found < 11.0]
    for beyond in (over, under):
        assert float(beyond.mean()) == pytest.approx(2 * REACH / 4, rel=6 / beyond.size**0.5)


def test_more_stored_runs_reach_less_far() -> None:
    once, often = np.linspace(11.0, 12.0, 30), np.linspace(11.0, 12.0, 300).reshape(10, 30)

    reach = [
        float((found[found > 12.0] - 12.0).mean())
        for found in (tables_of(stored, tables=4000) for stored in (once, often))
    ]

    assert reach[0] / reach[1] == pytest.approx(2.0 / 1.1, rel=0.1)


def test_costs_over_decades_go_beyond_by_their_logarithm() -> None:
    stored = np.logspace(-10.0, 0.0, 100)  # half of them lie 2.5 decades above the median
    found = tables_of(stored, tables=4000, floor=0.0)

    over, under = np.log10(found[found > 1.0]), -10.0 - np.log10(found[found < 1e-10])
    for beyond in (over, under):
        assert float(beyond.mean()) == pytest.approx(2 * REACH * 2.5, rel=6 / beyond.size**0.5)


def test_spread_of_tables_beyond_any_double_is_a_number() -> None:
    stored = np.logspace(-300.0, 0.0, 30).reshape(1, 30)

    found = predicted(
        stored, standard_deviation, tables=500, rng=np.random.default_rng(1), ends=(0.0, np.inf)
    )

    assert np.isfinite(found).all()
    assert found.max() > 1e300


@given(QUANTISED, st.integers(-300, 300), st.integers(0, 99))
def test_costs_in_another_unit_give_the_same_tables_in_it(
    costs: list[float], power: int, seed: int
) -> None:
    found = tables_of(np.ldexp(np.array(costs), power), seed=seed)

    assert found == pytest.approx(np.ldexp(tables_of(costs, seed=seed), power), rel=1e-9, abs=0.0)


@given(COSTS, st.integers(0, 99))
def test_distances_from_the_minimum_decide_and_not_where_it_lies(
    costs: list[float], seed: int
) -> None:
    whole = np.round(costs)  # so that moving them is exact
    moved = tables_of(whole + 1024.0, seed=seed, floor=1024.0)

    expected = tables_of(whole, seed=seed, floor=0.0) + 1024.0
    assert moved == pytest.approx(expected, rel=1e-9)


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=200), st.floats(0.01, 0.99))
def test_quantile_interval_has_drawn_ends_and_holds_its_level(
    values: list[float], level: float
) -> None:
    low, high = quantile_interval(np.array(values), level)

    assert {low, high} <= set(values)
    held = sum(low <= value <= high for value in values)
    assert held >= level * len(values) - 1e-9


def test_quantile_interval_leaves_out_the_tails() -> None:
    assert quantile_interval(np.arange(1001.0), 0.95) == (25.0, 975.0)
