from statistics import median, quantiles, variance

import numpy as np
import pytest

from repro.errors import InputError
from repro.statistics.named import is_known, is_of_extremes, is_spread, statistic_named
from repro.statistics.quantiles import METHODS

RUNS = [7.0, 1.0, 3.0, 12.0, 4.0, 4.5]
TABLE = np.array([RUNS, [2.0 * run for run in RUNS]])


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("median", median(RUNS)),
        ("q2", median(RUNS)),
        ("q50", median(RUNS)),
        ("q1", quantiles(RUNS, method="inclusive")[0]),
        ("q3", quantiles(RUNS, method="inclusive")[2]),
        ("q25", quantiles(RUNS, method="inclusive")[0]),
        ("q05", 1.0 + 0.25 * (3.0 - 1.0)),  # place 0.05 * 5 after the first
        ("q2.5", 1.0 + 0.125 * (3.0 - 1.0)),
        ("q1 by weibull", quantiles(RUNS)[0]),
        ("iqr by weibull", quantiles(RUNS)[2] - quantiles(RUNS)[0]),
        ("variance", variance(RUNS)),
        ("standard error", (variance(RUNS) / 6) ** 0.5),
        ("successes at 4", 3.0),
        ("success rate at 4", 50.0),
        ("success share at 4e0", 0.5),
    ],
)
def test_word_is_the_statistic_that_tables_print(word: str, value: float) -> None:
    assert float(statistic_named(word)(TABLE)[0]) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    "word",
    ["", "Median", "q4", "q1 by me", "iqr by", "success rate", "success rate at x",
     "successes at nan", "q100.5.", "mean by weibull"],
)  # fmt: skip
def test_unknown_word_is_refused_with_what_there_is(word: str) -> None:
    with pytest.raises(InputError, match=r"there are .*(median|weibull)|finite number"):
        statistic_named(word)

    assert not is_known(word)


@pytest.mark.parametrize("method", METHODS)
def test_every_definition_of_a_quantile_can_be_said(method: str) -> None:
    assert is_known(f"q3 by {method}")


def test_measures_of_spread_are_those_that_are_none_for_equal_runs() -> None:
    equal = np.full(5, 3.25)
    words = ("best", "mean", "std", "median", "variance", "standard error", "iqr by hazen", "q1")

    for word in words:
        assert is_spread(word) == (float(statistic_named(word)(equal)) == 0.0)


def test_quantile_hangs_on_the_last_run_where_few_runs_reach_it() -> None:
    words = ("best", "worst", "q05", "q95", "q1", "median", "mean")

    assert [word for word in words if is_of_extremes(word, 20)] == ["best", "worst", "q05", "q95"]
    assert [word for word in words if is_of_extremes(word, 21)] == ["best", "worst"]
