"""How far from a printed number a measured one may lie: the band accepted beforehand."""

import math
from dataclasses import dataclass, replace
from typing import Protocol, Self

from repro.functions import BenchmarkProblem
from repro.statistics.named import is_count, is_spread
from repro.tables.published import Printed
from repro.tables.true_numbers import ZERO_FITNESS, ZERO_STD

Interval = tuple[float, float]
STEPS = 10  # of double arithmetic that count as none: sums of 30 terms round by a few


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
    """Near zero within decades, elsewhere within a share; a printed 0 means below `zero`.

    What is printed below `zero` is the same as 0, and by decades what it says itself.
    """

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
        if printed.value < 0:
            low, high = low * factor, high / factor
            return (min(low, -self.zero), 0.0) if -printed.value <= self.zero else (low, high)
        low, high = low / factor, high * factor
        return (0.0, max(high, self.zero)) if printed.value <= self.zero else (low, high)

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        return (
            f"within {self.percent:g} %, below {self.near_zero:g} within a factor "
            f"{10**self.decades:g}; a printed 0 means below {self.zero:.0e}"
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class FromMinimum:
    """Within a share of the distance from the least cost, for a std of itself.

    Below `solved` the distance counts by decades: the CEC competitions count it as 0 (J. J. Liang
    et al., Technical Report 201311, Zhengzhou University, 2013). Values that lie ten steps of
    double arithmetic apart are the same: near its minimum a function can take none between. A 0
    means what doubles cannot hold, or square, and the other way round; another minimum means what
    rounds to it.
    """

    percent: float = 25.0
    decades: float = 1.0
    solved: float = 1e-8
    minimum: float = 0.0
    step: float = 0.0
    zero: float = ZERO_FITNESS

    def on(self, problem: object, statistic: str) -> Self:
        """Return the tolerance for a statistic of the costs of a problem."""
        if not isinstance(problem, BenchmarkProblem):
            return self
        if is_count(statistic):
            return replace(self, minimum=0.0, step=0.0)
        rooted = statistic in ("std", "standard error")
        return replace(
            self,
            minimum=0.0 if is_spread(statistic) else problem.minimum,
            step=problem.step**2 if statistic == "variance" else problem.step,
            zero=ZERO_STD if rooted else ZERO_FITNESS,
        )

    def band(self, printed: Printed) -> Interval:
        """Return the accepted band in the printed unit."""
        distance, steps = printed.value - self.minimum, STEPS * self.step
        if distance == 0:
            slack = printed.rounding + steps if self.minimum else max(steps, self.zero)
            return self.minimum - (slack if self.minimum else steps), self.minimum + slack
        if abs(distance) >= self.solved:
            slack = abs(distance) * self.percent / 100 + printed.rounding + steps
            return printed.value - slack, printed.value + slack
        factor = 10.0**self.decades
        near = max(distance - printed.rounding, 0.0) / factor
        far = (max(distance, 0.0) + printed.rounding) * factor
        if self.minimum == 0 and abs(distance) <= self.zero:
            return 0.0 - steps, max(far + steps, self.zero)  # and not -0.0
        return self.minimum + near - steps, self.minimum + far + steps

    @property
    def words(self) -> str:
        """The tolerance as a phrase."""
        least = f" (minimum {self.minimum:.7g})" if self.minimum else ""
        return (
            f"within {self.percent:g} % of the distance from the minimum{least} and the printed "
            f"rounding, below {self.solved:g} within a factor {10**self.decades:g}"
        )


def rounded(printed: Printed, accepted: Tolerance) -> Interval:
    """Return the number with its rounding; of a cost that is 0, what its tolerance says.

    A 0 without decimals is no number between -0.5 and 0.5. What doubles cannot hold is one too.
    """
    low, high = printed.value - printed.rounding, printed.value + printed.rounding
    minimum = accepted.minimum if isinstance(accepted, FromMinimum) else 0.0
    if isinstance(accepted, Fitness | FromMinimum) and minimum == 0:
        if printed.value == 0:
            return accepted.band(printed)
        if abs(printed.value) <= accepted.zero:
            nothing = accepted.band(Printed("0"))
            return min(low, nothing[0]), max(high, nothing[1])
    return low, high


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
        if math.isinf(self.low) and math.isinf(self.high):
            return "nothing is measured"
        if self.low == self.high:
            return f"exactly {self.low:g}"
        return f"between {self.low:g} and {self.high:g}"
