import math
import sys

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from repro.functions import FUNCTIONS
from repro.model.tolerances import (
    Absolute,
    Between,
    Fitness,
    FromMinimum,
    Percent,
    Tolerance,
    rounded,
)
from repro.tables.published import Printed
from repro.tables.true_numbers import ZERO_FITNESS, ZERO_STD

FITNESS = Fitness(decades=1, near_zero=0.01, percent=25)


@pytest.mark.parametrize("tolerance", [Percent(1), Percent(0), Absolute(0), Absolute(2), FITNESS])
@given(number=st.floats(-1e12, 1e12), digits=st.integers(0, 6))
def test_every_number_that_prints_as_this_one_is_accepted(
    tolerance: Tolerance, number: float, digits: int
) -> None:
    printed = Printed(f"{number:.{digits}e}")
    assume(printed.value != 0 or number == 0)

    low, high = tolerance.band(printed)

    slack = 1e-12 * abs(number)
    assert low <= printed.value <= high
    assert low - slack <= number <= high + slack


@given(st.floats(1e-6, 1e6), st.sampled_from([Percent(3), Absolute(0.1), FITNESS]))
def test_band_of_a_negative_number_is_the_mirrored_one(number: float, tolerance: Tolerance) -> None:
    low, high = tolerance.band(Printed(f"{number:.3e}"))

    assert tolerance.band(Printed(f"-{number:.3e}")) == (-high, -low)


@pytest.mark.parametrize(
    ("tolerance", "text", "band"),
    [
        (Percent(1), "4.69", (4.69 - 0.0519, 4.69 + 0.0519)),
        (Percent(10), "-200", (-220.5, -179.5)),
        (Absolute(0), "1.53", (1.525, 1.535)),
        (Absolute(0.5), "18.3", (17.75, 18.85)),
        (Between(1, 100), "18.3", (1.0, 100.0)),
        (FITNESS, "2.0", (1.45, 2.55)),
        (FITNESS, "0.010", (0.007, 0.013)),
        (FITNESS, "0.009", (0.00085, 0.095)),
        (FITNESS, "7.91×10^-74", (7.905e-75, 7.915e-73)),
    ],
)
def test_band_is_printed_value_with_tolerance_and_rounding(
    tolerance: Tolerance, text: str, band: tuple[float, float]
) -> None:
    assert tolerance.band(Printed(text)) == pytest.approx(band, rel=1e-12)


def test_printed_zero_accepts_what_double_arithmetic_rounds_to_it() -> None:
    spread = Fitness(decades=1, near_zero=0.01, percent=25, zero=ZERO_STD)

    assert FITNESS.band(Printed("0")) == (0.0, sys.float_info.min)
    assert spread.band(Printed("0.00×10^0")) == (0.0, ZERO_STD)


ON_SPHERE = FromMinimum().on(FUNCTIONS["sphere"].problem(30), "mean")
SPREAD_ON_SPHERE = FromMinimum().on(FUNCTIONS["sphere"].problem(30), "std")
ON_ACKLEY = FromMinimum().on(FUNCTIONS["ackley"].problem(30), "mean")
SPREAD = Fitness(decades=1, near_zero=0.01, percent=25, zero=ZERO_STD)
NEAR_ZERO = [FITNESS, SPREAD, ON_SPHERE, SPREAD_ON_SPHERE, ON_ACKLEY]


@pytest.mark.parametrize("tolerance", NEAR_ZERO)
@given(st.floats(0, 15), st.floats(0, 15))
def test_print_and_rerun_near_underflow_may_change_places(
    tolerance: Fitness | FromMinimum, first: float, second: float
) -> None:
    one, other = (f"{tolerance.zero * 10**-power:.17g}" for power in (first, second))

    for printed, measured in ((one, other), (one, "0"), ("0", one)):
        low, high = tolerance.band(Printed(printed))
        assert low <= float(measured) <= high


@pytest.mark.parametrize("tolerance", NEAR_ZERO)
@given(st.floats(-323, -100))
def test_zero_is_held_in_both_directions_or_in_none(
    tolerance: Fitness | FromMinimum, power: float
) -> None:
    tiny = 10**power

    low, high = tolerance.band(Printed(f"{tiny:.17g}"))

    assert (low <= 0.0 <= high) == (tiny <= tolerance.band(Printed("0"))[1])


@pytest.mark.parametrize("tolerance", NEAR_ZERO)
def test_tiny_print_stands_for_all_that_a_printed_zero_stands_for(
    tolerance: Fitness | FromMinimum,
) -> None:
    low, high = rounded(Printed("4.90e-322"), tolerance)

    zero = rounded(Printed("0"), tolerance)
    assert low <= zero[0]
    assert high >= zero[1]
    assert f"{tolerance.band(Printed('4.90e-322'))[0]}" != "-0.0"  # which a page would show


def test_bands_of_numbers_that_doubles_hold_are_as_they_were() -> None:
    assert ON_SPHERE.band(Printed("3.00e-308"))[0] > 0.0
    assert FITNESS.band(Printed("3.00e-308")) == pytest.approx((2.995e-309, 3.005e-307), rel=1e-9)
    assert rounded(Printed("3.00e-308"), FITNESS)[0] > 2.9e-308


def test_zeros_are_the_limits_of_double_arithmetic() -> None:
    assert sys.float_info.min == ZERO_FITNESS
    assert math.sqrt(math.ulp(0.0)) == ZERO_STD
    assert (0.7 * ZERO_STD) ** 2 == 0.0  # below the square root by more than the rounding
    assert ZERO_STD**2 > 0.0


@pytest.mark.parametrize(
    ("tolerance", "words"),
    [
        (Percent(1), "within 1 % and the printed rounding"),
        (Absolute(0.5), "within 0.5 and the printed rounding"),
        (Absolute(0), "as printed"),
        (Between(0, 2), "between 0 and 2"),
        (Between(1, 1), "exactly 1"),
        (FITNESS, "within 25 %, below 0.01 within a factor 10; a printed 0 means below 2e-308"),
    ],
)
def test_tolerance_is_said_in_words(tolerance: Tolerance, words: str) -> None:
    assert tolerance.words == words


ACKLEY = FUNCTIONS["ackley"].problem(30)
HARTMANN = FUNCTIONS["hartmann_3"].problem()


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("-3.8563", -3.858, -3.8546),  # 0.00648 from the minimum: a quarter of it, and rounding
        ("-3.86278", -3.862786, -3.862774),  # the minimum as far as it is printed
    ],
)
def test_distance_from_the_minimum_is_what_counts(text: str, low: float, high: float) -> None:
    tolerance = FromMinimum(percent=25).on(HARTMANN, "mean")

    assert tolerance.band(Printed(text)) == pytest.approx((low, high), abs=1e-4)
    assert tolerance.band(Printed("-3.8563"))[1] < -3.853  # what random search has


@pytest.mark.parametrize("statistic", ["best", "worst", "mean", "std"])
def test_quantised_costs_a_step_apart_are_the_same_by_one_rule(statistic: str) -> None:
    tolerance = FromMinimum(percent=25).on(ACKLEY, statistic)

    for printed in ("4.441×10^-16", "0"):
        low, high = tolerance.band(Printed(printed))
        assert low < 0.0
        assert 4.0e-15 < high < 1e-13


def test_solved_distances_count_by_decades() -> None:
    sphere = FromMinimum(percent=25).on(FUNCTIONS["sphere"].problem(30), "mean")

    assert sphere.band(Printed("2.00E-74")) == pytest.approx((1.995e-75, 2.005e-73))
    assert sphere.band(Printed("2.00E-08")) == pytest.approx((1.495e-8, 2.505e-8))


def test_minimum_that_is_printed_is_as_good_as_its_rounding() -> None:
    goldstein_price = FUNCTIONS["goldstein_price"].problem()
    tolerance = FromMinimum(percent=25).on(goldstein_price, "mean")

    assert tolerance.band(Printed("3")) == pytest.approx((2.5, 3.5))
    assert tolerance.band(Printed("3.000")) == pytest.approx((2.9995, 3.0005))


def test_standard_deviation_counts_from_zero_whatever_the_minimum() -> None:
    assert FromMinimum(percent=25).on(HARTMANN, "std").minimum == 0.0
    assert FromMinimum(percent=25).on(HARTMANN, "mean").minimum == HARTMANN.minimum


@pytest.mark.parametrize(
    ("tolerance", "text", "widest"),
    [
        (FromMinimum(percent=25), "0", 1e-300),
        (Fitness(decades=1, near_zero=0.01, percent=25), "0", 1e-300),
        (FromMinimum(percent=25).on(FUNCTIONS["goldstein_price"].problem(), "mean"), "3", 1.0),
        (FromMinimum(percent=25), "2", 1.0),
        (Percent(25), "0", 1.0),
    ],
)
def test_bare_zero_of_a_cost_is_no_rounded_number(
    tolerance: Tolerance, text: str, widest: float
) -> None:
    low, high = rounded(Printed(text), tolerance)

    assert 0.0 <= high - low <= widest
    assert high - low > widest / 1e10


def test_share_of_successes_has_no_minimum_and_no_step() -> None:
    on_hartmann = FromMinimum(percent=25).on(HARTMANN, "success rate at -3.86")

    assert (on_hartmann.minimum, on_hartmann.step) == (0.0, 0.0)


@pytest.mark.parametrize("word", ["std", "standard error", "variance", "iqr by hazen"])
def test_every_measure_of_spread_counts_from_zero(word: str) -> None:
    assert FromMinimum(percent=25).on(HARTMANN, word).minimum == 0.0
