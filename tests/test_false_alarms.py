"""The trial of false alarms in short."""

import pytest

from tests.false_alarms import alarms, power


def test_no_true_table_is_called_impossible_or_inconsistent() -> None:
    count = alarms(300)
    assert (count["tables"], count["impossible"], count["inconsistent"]) == (300, 0, 0)


@pytest.mark.parametrize("kind", ["std × 100", "sign of the mean"])
def test_a_gross_error_in_a_full_row_is_mostly_found(kind: str) -> None:
    assert power(kind, ("best", "mean", "worst", "std"), 40) > 0.8
