"""What the words for a printed statistic say: "median", "q1", "q05", "standard error"."""

import math
import re
from fractions import Fraction

SPREADS = ("std", "variance", "standard error")  # all of them say the standard deviation
RANGE = "iqr"
_QUARTERS = {"q1": Fraction(1, 4), "q2": Fraction(1, 2), "median": Fraction(1, 2)} | {
    "q3": Fraction(3, 4)
}
_PERCENT = re.compile(r"q(\d\d(?:\.\d+)?|\d\.\d+)")


def quantile_share(word: str) -> Fraction | None:
    """Return which share of the runs does not exceed the statistic; None for no quantile."""
    name = word.partition(" by ")[0]
    if name in _QUARTERS:
        return _QUARTERS[name]
    match = _PERCENT.fullmatch(name)
    return Fraction(match[1]) / 100 if match else None


def is_range(word: str) -> bool:
    """Say whether a statistic is an interquartile range, of whichever definition."""
    return word.partition(" by ")[0] == RANGE


def is_width(word: str) -> bool:
    """Say whether a statistic says how far runs lie apart, and so is no value among theirs."""
    return word in SPREADS or is_range(word)


def runs_around(word: str, n: int) -> tuple[int, int]:
    """Return how many of n runs are at a quantile or below, and at it or above, at the least.

    Whichever of the usual definitions is meant.
    """
    share = quantile_share(word) or Fraction(0)
    if word == "median":
        return (n + 1) // 2, (n + 1) // 2
    return math.floor(n * share), n - math.ceil(n * share)
