"""The trial of false alarms in short."""

import pytest

from tests.planted import power
from tests.planted_beside import power_beside
from tests.trial import BATCH, KINDS, alarms


def test_no_true_table_is_accused_under_no_condition_or_under_one_that_it_meets() -> None:
    count = alarms(400)

    assert sum(count[kind, "tables"] for kind in KINDS) == 400
    for kind in KINDS:
        # of means alone, as some stand beside tallies, nothing follows
        least = 0.3 if kind == "tallies" else 0.9
        assert count[kind, "checked"] > least * count[kind, "numbers"] > 0
        outcomes = ("impossible", "inconsistent", "condition met")
        assert [count[kind, outcome] for outcome in outcomes] == [0, 0, 0]


def test_the_trial_is_the_same_for_any_number_of_processes() -> None:
    assert alarms(BATCH + 20, "two") == alarms(BATCH + 20, "two", workers=2)


@pytest.mark.parametrize("kind", ["std × 100", "sign of the mean"])
def test_a_gross_error_in_a_full_row_is_mostly_found(kind: str) -> None:
    proved, found = power(kind, ("best", "mean", "worst", "std"), 40)

    assert found >= proved > 0.8


@pytest.mark.parametrize(
    "kind",
    ["a sum of ranks one off", "a win, tie or loss too many", "first and last place exchanged"],
)
def test_an_error_beside_statistics_is_mostly_found(kind: str) -> None:
    assert power_beside(kind, 20) > 0.8
