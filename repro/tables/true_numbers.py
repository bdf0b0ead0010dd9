"""Every true number that can stand behind a printed one, in exact arithmetic."""

import math
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction

from repro.tables.published import Printed, PublishedTable

# A printed 0 can stand for anything that the arithmetic of a table rounds to it. A fitness is 0
# below the smallest normal double; a standard deviation is 0 where the squares of the differences
# underflow, at the square root of the smallest subnormal double.
ZERO_FITNESS = 2.2250738585072014e-308
ZERO_STD = 2.2227587494850775e-162
# An average or a spread of doubles is off by a few units of their 53rd bit, far below what is
# printed; this share of a printed number covers it and spares the bounds its analysis.
DOUBLES = Fraction(1, 2**40)
TINY = Fraction(ZERO_FITNESS)  # below it a double loses digits, or is flushed to 0
# Squares of differences underflow, so a computed standard deviation is off by up to
# sqrt(1.5) times this: 3 roundings of half the smallest subnormal double in the variance.
TINY_STD = 2 * Fraction(ZERO_STD)


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

    def meets(self, other: "Span") -> bool:
        """Say whether one and the same number can stand behind both."""
        return self.low <= other.high and other.low <= self.high


def exact(number: float) -> Fraction:
    """Return the decimal number that a float was read from."""
    return Fraction(repr(float(number)))


def unit(printed: Printed) -> Fraction:
    """Return one unit of the last printed digit, in the printed unit."""
    return 2 * exact(printed.rounding)


def span(printed: Printed) -> Span:
    """Return what can stand behind a number that was rounded or cut off, in the printed unit."""
    value, last = exact(printed.value), unit(printed)
    below = last if value <= 0 else last / 2
    above = last if value >= 0 else last / 2
    slack = DOUBLES * abs(value)
    return Span(value - below - slack, value + above + slack)


def statistic_span(printed: Printed, *, scientific: bool, spread: bool) -> Span:
    """Return what can stand behind a printed statistic of doubles.

    Where a table prints powers of ten (`scientific`), a bare 0 has no last digit: it stands for
    what doubles cannot hold or square. `spread` says that the statistic is a standard deviation.
    """
    tiny = TINY_STD if spread else TINY
    floating = _is_scientific(printed) or (scientific and "." not in printed.text)
    around = Span(Fraction(0), Fraction(0)) if printed.value == 0 and floating else span(printed)
    return Span(around.low - tiny, around.high + tiny)


def is_scientific(table: PublishedTable) -> bool:
    """Say whether any cell of the table is printed with a power of ten."""
    return any(_is_scientific(table[place]) for place in table.places())


def _is_scientific(printed: Printed) -> bool:
    return any(mark in printed.text for mark in "×xeE")


def root(number: Fraction) -> Decimal:
    """Return the square root to 28 digits, also where a float would underflow."""
    with localcontext() as context:
        context.prec = 28
        return (Decimal(number.numerator) / Decimal(number.denominator)).sqrt()


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
