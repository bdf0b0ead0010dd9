"""What can have made a printed statistic: its precision, its zeros, its rounding, its box.

A check is tried with the least that can be taken for granted first. What more it needs is the
condition of its row.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from repro.tables.published import Printed
from repro.tables.true_numbers import TINY, TINY_STD, Span, is_scientific_number, span

TINY_SINGLE = Fraction(1, 2**126)  # below it a float loses digits, or is flushed to 0
TINY_SINGLE_STD = Fraction(1, 2**62)  # as TINY_STD: twice the root of that
LEAST_SINGLE = Fraction(1, 2**149)  # the smallest float above 0
# Below the root of that, and so below what it can give; a standard error is less by √n, of n below
# 2^20, and a variance has no root.
LEAST_SINGLE_SPREADS = {
    "std": Fraction(1, 2**76),
    "standard error": Fraction(1, 2**86),
    "variance": LEAST_SINGLE,
}
GREATEST_SINGLE = Fraction(2**128)
DIGITS = 2  # digits of a whole number that nobody rounds away
IN_DOUBLES = "runs and statistics are kept in double precision"
CONDITIONS = {
    "doubles": IN_DOUBLES,
    "exact_zeros": "a bare 0 stands for what the arithmetic rounds to 0, not for a small number",
    "whole": "no digit of a whole number is rounded away",
    "in_box": "every run ends inside the box",
    "two_pass": "standard deviations are taken from differences to the mean, not from the mean "
    "of squares less the square of the mean",
}
_AND = ", and "
_WHOLE = re.compile(r"[-+]?0*(\d+)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Arithmetic:
    """What is taken for granted of how a table was made; by default nothing.

    Without `doubles` runs and statistics may be in single precision. Without `exact_zeros` a bare
    0 among powers of ten may stand for any number that rounds to it. Without `whole` the last
    digits of a whole number may be rounded away. Without `in_box` runs may end outside the box.
    Without `two_pass` a variance may be the mean of squares less the square of the mean, which
    cancels where runs are nearly equal. `significant` is how many digits every number was rounded
    to, where that is told: then `whole` is no question.
    """

    doubles: bool = False
    exact_zeros: bool = False
    whole: bool = False
    in_box: bool = False
    two_pass: bool = False
    significant: int | None = None

    def beyond(self, known: "Arithmetic") -> str | None:
        """Return what is taken for granted and not known, as the end of "holds if …"."""
        return joined(
            words
            for name, words in CONDITIONS.items()
            if getattr(self, name) and not getattr(known, name)
        )

    @property
    def roundoff(self) -> Fraction:
        """The relative error of one rounding."""
        return Fraction(1, 2**53 if self.doubles else 2**24)


NARROWEST = Arithmetic(doubles=True, exact_zeros=True, whole=True, in_box=True, two_pass=True)


def joined(conditions: Iterable[str | None]) -> str | None:
    """Return conditions that must all hold as one; None where there is none."""
    return _AND.join(filter(None, conditions)) or None


def parted(condition: str | None) -> list[str]:
    """Return the parts of a condition that `joined` made one."""
    return condition.split(_AND) if condition else []


def both(one: str | None, other: str | None) -> str | None:
    """Return the condition that says what two say, no part of it twice."""
    return joined(dict.fromkeys((*parted(one), *parted(other))))


@lru_cache(maxsize=1 << 16)
def statistic_span(
    printed: Printed, *, scientific: bool, given: Arithmetic, spread: str = ""
) -> Span:
    """Return what can stand behind a printed statistic, but for the rounding of a mean.

    Where a table prints powers of ten (`scientific`), a bare 0 has no last digit. `spread` is
    the name of the statistic where it says a standard deviation.
    """
    if spread:
        in_doubles = given.doubles or 0 < printed.value < LEAST_SINGLE_SPREADS[spread]
        tiny = TINY_STD if in_doubles else TINY_SINGLE_STD
        tiny = tiny**2 if spread == "variance" else tiny
    else:
        tiny = TINY if given.doubles else TINY_SINGLE
    bare = given.exact_zeros and is_bare_zero(printed, scientific=scientific)
    if printed.value == 0 and (bare or is_scientific_number(printed)):
        return Span(-tiny, tiny)
    kept = given.significant
    last = None if given.whole and kept is None else rounded_at(printed, kept or DIGITS)
    around = span(printed, last=last)
    return Span(around.low - tiny, around.high + tiny)


def is_less(one: Printed, other: Printed, *, share: Fraction = Fraction(0)) -> bool:
    """Say whether a number printed as `one` is less than `other` by more than their rounding.

    And by more than a `share` of either.
    """
    given = Arithmetic(doubles=True, exact_zeros=True)
    low, high = (statistic_span(each, scientific=True, given=given) for each in (one, other))
    return low.high + share * abs(low.high) < high.low - share * abs(high.low)


def is_bare_zero(printed: Printed, *, scientific: bool) -> bool:
    """Say whether a 0 has neither decimals nor a power of ten, in a table that has powers."""
    marks = "." in printed.mantissa or is_scientific_number(printed)
    return scientific and printed.value == 0 and not marks


def rounded_at(printed: Printed, digits: int = DIGITS) -> Fraction | None:
    """Return the unit that a whole number may be rounded to; None where it ends in no 0 beyond.

    Its first `digits` are never rounded away.
    """
    match = _WHOLE.fullmatch(printed.mantissa)
    if match is None or printed.power is not None:
        return None
    kept = max(digits, len(match[1].rstrip("0")))
    return Fraction(10 ** (len(match[1]) - kept)) if kept < len(match[1]) else None
