"""How far from a printed number a measured one may lie: the band accepted beforehand."""

from dataclasses import dataclass
from typing import Protocol

from repro.tables.published import Printed
from repro.tables.true_numbers import ZERO_FITNESS

Interval = tuple[float, float]


class Tolerance(Protocol):
    """How far from the printed number a measured one may lie; declared before the runs."""

    def band(self, printed: Printed) -> Interval:
        """Return the accepted band in the printed unit."""

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""


@dataclass(frozen=True, slots=True)
class Percent:
    """Within a share of the printed value, and its rounding."""

    share: float

    def band(self, printed: Printed) -> Interval:
        """Return printed ± share ± rounding."""
        slack = abs(printed.value) * self.share / 100 + printed.rounding
        return printed.value - slack, printed.value + slack

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        return f"within {self.share:g} % and the printed rounding"


@dataclass(frozen=True, slots=True)
class Absolute:
    """Within an amount in the printed unit, and the rounding."""

    amount: float

    def band(self, printed: Printed) -> Interval:
        """Return printed ± amount ± rounding."""
        slack = self.amount + printed.rounding
        return printed.value - slack, printed.value + slack

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        return f"within {self.amount:g} and the printed rounding" if self.amount else "as printed"


@dataclass(frozen=True, slots=True)
class RoundedOrCut:
    """The printed digits, whether they were rounded or whatever follows them was cut off."""

    def band(self, printed: Printed) -> Interval:
        """Return from half a unit of the last digit towards zero to a whole one away from it."""
        noise = 1e-12 * abs(printed.value)  # doubles: a value on the very edge is inside
        near, away = printed.rounding + noise, 2 * printed.rounding + noise
        below = away if printed.value <= 0 else near
        above = away if printed.value >= 0 else near
        return printed.value - below, printed.value + above

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        return "the printed digits, rounded or cut off"


@dataclass(frozen=True, slots=True, kw_only=True)
class Fitness:
    """Near zero within decades, elsewhere within a share; a printed 0 means below `zero`."""

    decades: float
    near_zero: float
    percent: float
    zero: float = ZERO_FITNESS

    def band(self, printed: Printed) -> Interval:
        """Return the accepted band; decades count away from zero on either side of it."""
        if printed.value == 0:
            return 0.0, self.zero
        if abs(printed.value) >= self.near_zero:
            return Percent(self.percent).band(printed)
        factor = 10.0**self.decades
        low, high = printed.value - printed.rounding, printed.value + printed.rounding
        return (low / factor, high * factor) if printed.value > 0 else (low * factor, high / factor)

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        return (
            f"within {self.percent:g} %, below {self.near_zero:g} within a factor "
            f"{10**self.decades:g}; a printed 0 means below {self.zero:.0e}"
        )


@dataclass(frozen=True, slots=True)
class Between:
    """Inside a fixed band: the declared reading of a sentence that prints no number."""

    low: float
    high: float

    def band(self, _printed: Printed) -> Interval:
        """Return the band as declared."""
        return self.low, self.high

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        if self.low == self.high:
            return f"exactly {self.low:g}"
        return f"between {self.low:g} and {self.high:g}"
