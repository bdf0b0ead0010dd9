"""Every true number that can stand behind a printed one, in exact arithmetic."""

import math
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from functools import lru_cache

from repro.tables.published import Printed, PublishedTable

# A printed 0 can stand for anything that the arithmetic of a table rounds to it. A fitness is 0
# below the smallest normal double; a standard deviation is 0 where the squares of the differences
# underflow, at the square root of the smallest subnormal double.
ZERO_FITNESS = 2.2250738585072014e-308
ZERO_STD = 2.2227587494850775e-162
# What a printed number of doubles, or of single precision, is off by beside its rounding: a few
# units of the 53rd or 24th bit of what it was computed from.
DOUBLES = Fraction(1, 2**40)
SINGLES = Fraction(1, 2**20)
# What was rounded before, each time to one digit less, is off by 0.5 + 0.05 + … units at most.
ROUNDED = Fraction(5, 9)
TINY = Fraction(ZERO_FITNESS)  # below it a double loses digits, or is flushed to 0
# Squares of differences underflow or are flushed, so a computed standard deviation is off by up
# to sqrt(2) times the root of the smallest normal double.
TINY_STD = Fraction(1, 2**510)


@dataclass(frozen=True, slots=True)
class Span:
    """From the least to the greatest true number that a print can stand for."""

    low: Fraction
    high: Fraction

    def __sub__(self, other: "Span") -> "Span":
        """Return every difference of a number here and one there."""
        return Span(self.low - other.high, self.high - other.low)

    def __add__(self, other: "Span") -> "Span":
        """Return every sum of a number here and one there."""
        return Span(self.low + other.low, self.high + other.high)

    def __mul__(self, other: "Span") -> "Span":
        """Return from the least to the greatest product."""
        ends = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Span(min(ends), max(ends))

    def __truediv__(self, other: "Span") -> "Span":
        """Return from the least to the greatest quotient; ZeroDivisionError where 0 may divide."""
        if other.low <= 0 <= other.high:
            raise ZeroDivisionError
        return self * Span(1 / other.high, 1 / other.low)

    def meets(self, other: "Span") -> bool:
        """Say whether one and the same number can stand behind both."""
        return self.low <= other.high and other.low <= self.high


@lru_cache(maxsize=1 << 16)
def exact(number: float) -> Fraction:
    """Return the decimal number that a float was read from."""
    return Fraction(repr(float(number)))


def unit(printed: Printed) -> Fraction:
    """Return one unit of the last printed digit, in the printed unit."""
    return 2 * exact(printed.rounding)


def span(printed: Printed, *, last: Fraction | None = None, share: Fraction = DOUBLES) -> Span:
    """Return what can stand behind a number that was rounded or cut off, in the printed unit.

    `last` is the unit that it was rounded to, if not that of its last digit; `share` of the number
    is what its arithmetic may be off by.
    """
    value, step = exact(printed.value), last or unit(printed)
    below = step if value <= 0 else step * ROUNDED
    above = step if value >= 0 else step * ROUNDED
    slack = share * abs(value)
    return Span(value - below - slack, value + above + slack)


def is_scientific(table: PublishedTable) -> bool:
    """Say whether any cell of the table is printed with a power of ten."""
    numbers = (cell for row in table.cells for cell in row if isinstance(cell, Printed))
    return any(map(is_scientific_number, numbers))


def is_scientific_number(printed: Printed) -> bool:
    """Say whether a number is printed with a power of ten."""
    return printed.power is not None


def root(number: Fraction) -> Decimal:
    """Return the square root to 28 digits, also where a float would underflow."""
    with localcontext() as context:
        context.prec = 28
        return (Decimal(number.numerator) / Decimal(number.denominator)).sqrt()


def root_below(number: Fraction) -> Fraction:
    """Return a number just below the square root, exactly: short of it by less than 2^-60 of it."""
    if number <= 0:
        return Fraction(0)
    top, bottom = number.numerator * number.denominator, number.denominator
    shift = max(0, 128 - top.bit_length())
    shift += shift % 2
    return Fraction(math.isqrt(top << shift), bottom << (shift // 2))


def root_above(number: Fraction) -> Fraction:
    """Return a number just above the square root, by less than 2^-50 of it."""
    return root_below(number) * (1 + Fraction(1, 2**50))


def shown(number: Fraction | Decimal | float) -> str:
    """Return the number with five significant digits."""
    return f"{float(number):.5g}"


def times(ratio: float) -> str:
    """Return a factor as it reads in a sentence."""
    return f"{ratio:.2f} times" if ratio < 10 else f"{ratio:.3g} times"


def factor(number: Fraction | Decimal, bound: Fraction | Decimal) -> float:
    """Return number / bound, infinite where the bound is 0."""
    above, below = (Fraction(each) for each in (number, bound))
    return float(above / below) if below else math.inf
