import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from repro.model.tolerances import RoundedOrCut
from repro.tables.published import Printed


def cut(number: float, decimals: int) -> str:
    return f"{math.trunc(number * 10**decimals) / 10**decimals:.{decimals}f}"


@given(st.floats(-1e4, 1e4), st.integers(0, 4))
def test_both_ways_of_shortening_a_number_are_accepted(number: float, decimals: int) -> None:
    for text in (f"{number:.{decimals}f}", cut(number, decimals)):
        printed = Printed(text)
        assume(printed.value != 0)  # "-0" has lost its sign
        low, high = RoundedOrCut().band(printed)
        assert low <= number <= high


@pytest.mark.parametrize(
    ("text", "band"),
    [
        ("19.68", (19.675, 19.69)),
        ("-19.68", (-19.69, -19.675)),
        ("0.0", (-0.1, 0.1)),
        ("21.6", (21.55, 21.7)),
    ],
)
def test_band_is_half_a_unit_towards_zero_and_a_whole_one_away(
    text: str, band: tuple[float, float]
) -> None:
    assert RoundedOrCut().band(Printed(text)) == pytest.approx(band)


def test_value_on_the_edge_is_inside_whatever_doubles_make_of_it() -> None:
    low, high = RoundedOrCut().band(Printed("16.88"))
    assert low < 16.875 < high

    low, high = RoundedOrCut().band(Printed("18.89"))
    assert low < 18.9 * (1 + 1e-15) < high


def test_tolerance_of_cut_digits_is_said_in_words() -> None:
    assert RoundedOrCut().words == "the printed digits, rounded or cut off"
