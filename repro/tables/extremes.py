"""The largest and smallest sum of squared deviations that n values can have.

All in exact arithmetic. Largest: values in an interval with a given mean spread most when all
but one stand at its ends (R. Bhatia, C. Davis, American Mathematical Monthly 107 (2000) 353-357,
sharpened to n values). Smallest: when all but the two extremes are equal.
"""

import math
from dataclasses import dataclass
from fractions import Fraction

from repro.tables.true_numbers import Span, shown


@dataclass(frozen=True, slots=True, kw_only=True)
class Widest:
    """A sample of n values that spreads most: `upper` of them at `high`, one between, rest low."""

    squares: Fraction
    n: int
    low: Fraction
    high: Fraction
    upper: int
    between: Fraction

    @property
    def words(self) -> str:
        """The sample as a phrase."""
        counts = {self.high: self.upper}
        for value, count in ((self.between, 1), (self.low, self.n - self.upper - 1)):
            counts[value] = counts.get(value, 0) + count
        parts = (f"{count} at {shown(value)}" for value, count in counts.items() if count)
        return " and ".join(parts)


def widest(n: int, low: Fraction | None, high: Fraction | None, mean: Span | None) -> Widest | None:
    """Return the widest sample of n values between low and high with a mean inside `mean`.

    None for a bound or mean means unknown. Returns None where nothing is bounded, or nothing
    fits. Where `high` is unknown or out of reach it is the greatest value that the mean allows.
    """
    if mean is not None:
        if low is None and high is not None:
            low, mean = high - n * (high - mean.low), Span(mean.low, mean.low)
        elif high is None and low is not None:
            high, mean = low + n * (mean.high - low), Span(mean.high, mean.high)
    if low is None or high is None or low > high:
        return None
    if low == high:
        return Widest(squares=Fraction(0), n=n, low=low, high=high, upper=0, between=low)
    share = Span(Fraction(0), Fraction(n))
    if mean is not None:
        width = high - low
        share = Span(
            max(share.low, n * (mean.low - low) / width),
            min(share.high, n * (mean.high - low) / width),
        )
    return _best_share(n, low, high, share)


def _best_share(n: int, low: Fraction, high: Fraction, share: Span) -> Widest | None:
    """Return the widest sample whose sum is n·low + t·(high - low) for some t in `share`."""
    if share.low > share.high:
        return None
    ends = (share.low, share.high)
    whole = range(math.ceil(share.low), math.floor(share.high) + 1)
    # between whole numbers the sum of squares is convex in t, so it peaks at an end or at a whole
    # number, of which the one next to n/2 gives most
    middle = [Fraction(min(max(n // 2, whole[0]), whole[-1]))] if whole else []
    width, t = high - low, max((*ends, *middle), key=lambda t: _squares(n, t))
    upper = min(math.floor(t), n - 1)
    return Widest(
        squares=width**2 * _squares(n, t),
        n=n,
        low=low,
        high=high,
        upper=upper,
        between=low + (t - upper) * width,
    )


def _squares(n: int, t: Fraction) -> Fraction:
    """Return the sum of squares about the mean of n numbers: ones, a part of one, and zeros."""
    upper = min(math.floor(t), n - 1)
    return upper + (t - upper) ** 2 - t**2 / n


@dataclass(frozen=True, slots=True, kw_only=True)
class Narrowest:
    """The least sum of squares about the mean, and the formula that gives it."""

    squares: Fraction
    formula: str


def narrowest(n: int, below: Fraction, above: Fraction) -> Narrowest:
    """Return the least spread of n ≥ 2 values of which one lies `below` and one `above` the mean.

    Both distances are least ones: the sample may reach further on either side.
    """
    near, far = sorted((below, above))
    if near <= far / (n - 1):  # the others balance the far one by themselves
        return Narrowest(
            squares=far**2 * Fraction(n, n - 1), formula=f"{shown(far)}² × {n}/{n - 1}"
        )
    if near == far:
        return Narrowest(squares=2 * far**2, formula=f"2 × {shown(far)}²")
    return Narrowest(
        squares=near**2 + far**2 + (far - near) ** 2 / (n - 2),
        formula=f"{shown(near)}² + {shown(far)}² + ({shown(far)} − {shown(near)})²/{n - 2}",
    )
