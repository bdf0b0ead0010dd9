"""Printed spreads of any kind as standard deviations."""

import math

from repro.tables.published import Printed
from repro.tables.relations import PlacedNumber

_DIGITS = 17


def as_std(number: PlacedNumber, kind: str, n: int | None) -> PlacedNumber | None:
    """Return the standard deviation of a printed variance or standard error of `n` runs.

    Its last digit is so coarse that whatever may stand behind the print stands behind it. None
    where it cannot be told: without `n`, or of a negative number.
    """
    if kind == "std":
        return number
    printed = number.printed
    low, high = printed.value - 2 * printed.rounding, printed.value + 2 * printed.rounding
    if printed.value < 0 or (kind == "sem" and n is None):
        return None
    if kind == "sem":
        scale = math.sqrt(n or 1)
        ends = (max(low, 0.0) * scale, high * scale)
    else:
        ends = (math.sqrt(max(low, 0.0)), math.sqrt(high))
    return PlacedNumber(
        printed=Printed(_shortest(*ends)), label=number.label, row=number.row, column=number.column
    )


def _shortest(low: float, high: float) -> str:
    """Return a number whose rounding reaches from `low` to `high`."""
    middle = (low + high) / 2
    if middle == 0:
        return "0"
    for digits in range(_DIGITS, 0, -1):
        text = f"{middle:.{digits - 1}e}"
        printed = Printed(text)
        if printed.value - printed.rounding <= low and high <= printed.value + printed.rounding:
            return text
    return f"0e{math.ceil(math.log10(high)) + 1}"
