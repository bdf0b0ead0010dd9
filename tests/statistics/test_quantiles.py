import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.statistics.quantiles import (
    METHODS,
    QuantileMethod,
    interquartile_range,
    median,
    quantile,
    successes,
)

RUNS = st.lists(st.integers(-50, 50), min_size=1, max_size=12)
# (alpha, beta): the place (1 .. n) of the quantile p is p (n + 1 - alpha - beta) + alpha, by
# Hyndman and Fan, p. 363; between two runs it is interpolated
PLACES: dict[QuantileMethod, tuple[Fraction, Fraction]] = {
    "interpolated_inverted_cdf": (Fraction(0), Fraction(1)),
    "hazen": (Fraction(1, 2), Fraction(1, 2)),
    "weibull": (Fraction(0), Fraction(0)),
    "linear": (Fraction(1), Fraction(1)),
    "median_unbiased": (Fraction(1, 3), Fraction(1, 3)),
    "normal_unbiased": (Fraction(3, 8), Fraction(3, 8)),
}


def by_definition(runs: list[int], share: Fraction, method: QuantileMethod) -> float:
    """Return the quantile in exact arithmetic."""
    ordered, n = sorted(runs), len(runs)
    if method in PLACES:
        alpha, beta = PLACES[method]
        place = min(max(share * (n + 1 - alpha - beta) + alpha, Fraction(1)), Fraction(n))
        low = math.floor(place)
        above = ordered[min(low, n - 1)]
        return float(ordered[low - 1] + (place - low) * (above - ordered[low - 1]))
    if method == "closest_observation":  # of two as near, the one at an even place
        place = n * share - Fraction(1, 2)
        low = math.floor(place)
        chosen = low if place == low and low % 2 == 0 else low + 1
        return float(ordered[min(max(chosen, 1), n) - 1])
    whole = n * share == math.floor(n * share)
    first = min(max(math.ceil(n * share), 1), n)
    if method == "averaged_inverted_cdf" and whole and 0 < share < 1:
        return (ordered[first - 1] + ordered[first]) / 2
    return float(ordered[first - 1])


@pytest.mark.parametrize("method", METHODS)
@given(runs=RUNS, eighths=st.integers(1, 7))
def test_quantile_is_that_of_its_definition(
    method: QuantileMethod, runs: list[int], eighths: int
) -> None:
    found = float(quantile(np.array(runs, dtype=float), eighths / 8, method))

    assert found == pytest.approx(by_definition(runs, Fraction(eighths, 8), method), abs=1e-9)


def test_median_of_an_even_number_is_the_middle_of_the_two() -> None:
    assert median(np.array([[4.0, 1.0, 3.0, 2.0], [0.0, 0.0, 1e-300, 1.0]])).tolist() == [
        2.5,
        5e-301,
    ]


def test_quantile_with_infinite_runs_is_infinite_only_where_it_rests_on_them() -> None:
    runs = np.array([1.0, 2.0, 3.0, np.inf, np.inf])

    assert [float(quantile(runs, share)) for share in (0.25, 0.5, 0.6, 1.0)] == [
        2,
        3,
        np.inf,
        np.inf,
    ]
    assert float(interquartile_range(runs)) == np.inf


@given(st.lists(st.sampled_from([0.0, 1e-8, 1e-7, 5.0]), min_size=1, max_size=9))
def test_runs_at_the_threshold_are_successes(runs: list[float]) -> None:
    assert float(successes(np.array(runs), 1e-8)) == sum(run <= 1e-8 for run in runs)
