from fractions import Fraction

import pytest

from repro.tables.published import Printed
from repro.tables.sums import _rounds_to
from repro.tables.true_numbers import DOUBLES, span

NOISE = 2 * DOUBLES


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("1.5", Fraction(15, 10) - Fraction(5, 90), Fraction(16, 10)),
        ("-1.5", Fraction(-16, 10), Fraction(5, 90) - Fraction(15, 10)),
        ("0.0", Fraction(-1, 10), Fraction(1, 10)),
        ("2.50×10^3", 2500 - Fraction(50, 9), Fraction(2510)),
    ],
)
def test_five_ninths_of_a_unit_towards_zero_and_a_whole_one_away_from_it_stand_behind_a_print(
    text: str, low: Fraction, high: Fraction
) -> None:
    found = span(Printed(text))

    assert abs(found.low - low) <= NOISE * (1 + abs(low))
    assert abs(found.high - high) <= NOISE * (1 + abs(high))


def test_a_number_that_was_rounded_digit_by_digit_stands_behind_its_print() -> None:
    """0.9446 is rounded to 0.945, then to 0.95, then to 1."""
    true = Fraction(9446, 10000)
    rounded = [Printed(text) for text in ("0.945", "0.95", "1")]

    assert all(span(each).low < true for each in rounded)
    assert span(rounded[-1]).low > Fraction(4, 9) - NOISE


@pytest.mark.parametrize(
    ("value", "rounds"), [("1.45", True), ("1.55", True), ("1.44", False), ("1.56", False)]
)
def test_a_slip_explains_a_number_within_half_a_unit_of_its_last_digit(
    value: str, *, rounds: bool
) -> None:
    assert _rounds_to(Fraction(value), Printed("1.5")) is rounds
