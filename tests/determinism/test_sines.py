import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from repro.determinism.sines import LARGEST, cosine_of_turns, squared_sine
from tests.twins import waves as twin

# to 100 digits; doi:10.1090/S0025-5718-1962-0136051-9
PI = Fraction(
    "3.141592653589793238462643383279502884197169399375105820974944592307816406286208998628034825"
    "3421170679"
)
CLOSE = Fraction(4, 10**16)


def cosine(angle: Fraction) -> Fraction:
    """Return the cosine of an angle of at most 4, to 40 digits, by its Taylor series."""
    angle = Fraction(round(angle * 10**50), 10**50)
    term = total = Fraction(1)
    for k in range(1, 60, 2):
        term *= -angle * angle / (k * (k + 1))
        total += term
    return total


def true_squared_sine(angle: float) -> Fraction:
    """Return sin² to 40 digits, however small it is, by the Taylor series of the sine."""
    rest = Fraction(angle) - round(Fraction(angle) / PI) * PI
    if rest == 0:
        return rest
    last_digit = Fraction(10) ** (math.floor(math.log10(abs(rest))) - 50)
    term = total = rest = round(rest / last_digit) * last_digit
    for k in range(2, 60, 2):
        term *= -rest * rest / (k * (k + 1))
        total += term
    return total * total


@given(st.floats(-1e6, 1e6))
def test_cosine_of_turns_is_the_cosine(turns: float) -> None:
    part = Fraction(turns) - round(Fraction(turns))

    assert abs(Fraction(float(cosine_of_turns(turns))) - cosine(2 * part * PI)) <= 2 * CLOSE


@given(st.floats(-8.0, 8.0))
def test_cosine_of_turns_has_the_bits_of_plain_python(turns: float) -> None:
    assert float(cosine_of_turns(turns)) == twin.cosine_of_turns(turns)


@pytest.mark.parametrize("turns", [0.0, 1.0, -32.0, 1e-9, -1e-9, 2.0**52, 5e-324])
def test_cosine_of_turns_is_one_at_whole_turns_and_near_zero(turns: float) -> None:
    assert cosine_of_turns(turns) == 1.0


@given(st.floats(-1000.0, 1000.0))
def test_squared_sine_is_the_square_of_the_sine(angle: float) -> None:
    assert abs(Fraction(float(squared_sine(angle))) - true_squared_sine(angle)) <= CLOSE


@given(st.integers(-150, 150), st.floats(-1e-3, 1e-3))
@example(0, 3.794138036982726e-55)
@example(0, 1e-162)
def test_squared_sine_keeps_its_digits_where_it_is_small(turns: int, away: float) -> None:
    angle = turns * math.pi + away
    true = true_squared_sine(angle)

    underflow = Fraction(2) ** -1073  # below 2^-1022 a double has fewer digits
    bound = 8 * Fraction(1, 2**53) * true + underflow
    assert abs(Fraction(float(squared_sine(angle))) - true) <= bound


def test_squared_sine_at_the_double_next_to_pi_is_that_of_the_difference() -> None:
    # the penalized functions of programs end at 1.57e-32 because of it, not at 0
    assert squared_sine(math.pi) == pytest.approx(1.2246467991473532e-16**2, rel=1e-15)


@pytest.mark.parametrize("angle", [LARGEST * 1.0001, 1e300, -1e300, math.inf])
def test_squared_sine_stands_still_beyond_its_largest_angle(angle: float) -> None:
    assert squared_sine(angle) == squared_sine(LARGEST)


def test_squared_sine_is_right_up_to_its_largest_angle() -> None:
    for angle in np.random.default_rng(1).uniform(-LARGEST, LARGEST, 300).tolist():
        assert abs(Fraction(float(squared_sine(angle))) - true_squared_sine(angle)) <= CLOSE


@pytest.mark.parametrize("wave", [cosine_of_turns, squared_sine])
def test_no_wave_of_what_is_no_number(wave: object) -> None:
    assert math.isnan(wave(math.nan))  # type: ignore[operator]
