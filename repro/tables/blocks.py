"""The printed statistics of one algorithm on one problem, and what they are statistics of."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from repro.tables.arithmetic import DIGITS, NARROWEST, Arithmetic, significant, statistic_span
from repro.tables.published import Printed
from repro.tables.relations import Cell
from repro.tables.true_numbers import Span


@dataclass(frozen=True, slots=True, kw_only=True)
class FunctionBounds:
    """What is known of the values of a function, beside its `minimum` in exact arithmetic.

    No run lies below `floor` in doubles, or `floor_in_singles` in single precision; where the
    minimum is one of the box alone (`only_in_box`), none that ends in the box. No run lies above
    `ceiling`, where one is known. Near the minimum values stand `step` apart, if the `condition`
    holds; 0 where nothing of the kind is known. `fixed` are values that say nothing of a run, such
    as the minimum.
    """

    title: str
    minimum: Fraction
    floor: Fraction
    floor_in_singles: Fraction
    only_in_box: bool = False
    ceiling: Fraction | None = None
    step: Fraction = Fraction(0)
    condition: str = ""
    fixed: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """Statistics by name ("best", "mean", …) as printed in one table, over `n` runs.

    `given` is what is taken for granted of how they were made.
    """

    problem_name: str
    algorithm: str
    quantity: str
    n: int
    cells: Mapping[str, Cell]
    scientific: bool
    function: FunctionBounds | None = None
    given: Arithmetic = NARROWEST

    @property
    def floor(self) -> Fraction | None:
        """A number that no run lies below; None where none is known."""
        function = self.function
        if function is None or (function.only_in_box and not self.given.in_box):
            return None
        return function.floor if self.given.doubles else function.floor_in_singles

    @property
    def ceiling(self) -> Fraction | None:
        """A number that no run lies above; None where none is known."""
        if self.function is None or self.function.ceiling is None:
            return None
        # a value so large is a sum or product of far fewer than 2^10 roundings
        return self.function.ceiling + abs(self.function.ceiling) * self.given.roundoff * 2**10

    @property
    def mean_error(self) -> Fraction:
        """How far a computed mean may be from the true one, in whatever order it is summed."""
        return 2 * (self.n + 2) * self.given.roundoff * self._size()

    @property
    def digits(self) -> int:
        """Significant digits that every whole number of the block is sure to have."""
        return max(DIGITS, *(significant(cell.printed) for cell in self.cells.values()))

    def printed(self, statistic: str) -> Printed:
        """Return the number as printed."""
        return self.cells[statistic].printed

    def own_span(self, statistic: str) -> Span:
        """Return what can stand behind a printed statistic, whatever the function is."""
        around = self._print_span(statistic)
        if statistic == "mean":
            error = self.mean_error
        elif statistic == "median":  # of an even number: half the sum of two runs
            error = 2 * self.given.roundoff * _reach(around)
        else:
            return around
        return Span(around.low - error, around.high + error)

    def span(self, statistic: str) -> Span | None:
        """Return what can stand behind it, no lower than the floor; None where not printed."""
        if statistic not in self.cells:
            return None
        whole, floor = self.own_span(statistic), self.floor
        if statistic == "std" or floor is None:
            return whole
        return Span(max(whole.low, floor), max(whole.high, floor))

    def _print_span(self, statistic: str) -> Span:
        return statistic_span(
            self.printed(statistic),
            scientific=self.scientific,
            spread=statistic == "std",
            given=self.given,
            digits=self.digits,
        )

    def _size(self) -> Fraction:
        """Return what the mean of the absolute values of the runs is at most."""
        low = self._print_span("best").low if "best" in self.cells else self.floor
        high = self._print_span("worst").high if "worst" in self.cells else self.ceiling
        ends = [] if low is None or high is None else [_reach(Span(low, high))]
        if "mean" not in self.cells:
            return min(ends, default=Fraction(0))
        mean = _reach(self._print_span("mean"))
        if low is not None:
            ends.append(mean + 2 * max(Fraction(0), -low))
        if high is not None:
            ends.append(mean + 2 * max(Fraction(0), high))
        return min(ends, default=mean)


def _reach(around: Span) -> Fraction:
    return max(abs(around.low), abs(around.high))
