"""What the words for a printed statistic say: "median", "q1", "q05", "standard error"."""

import re
from fractions import Fraction

SPREADS = ("std", "variance", "standard error")  # all of them say the standard deviation
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
