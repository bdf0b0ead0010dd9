"""The printed statistics of one algorithm on one problem, and what they are statistics of."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from repro.tables.published import Printed
from repro.tables.relations import TableCell
from repro.tables.true_numbers import Span, statistic_span


@dataclass(frozen=True, slots=True, kw_only=True)
class FunctionBounds:
    """What is known of the values of a function, beside its `minimum` in exact arithmetic.

    No run lies below `floor` in doubles, none above `ceiling`, where one is known. Near the minimum
    values stand `step` apart, if the `condition` holds; 0 where nothing of the kind is known.
    `fixed` are values that say nothing of a run, such as the minimum.
    """

    title: str
    minimum: Fraction
    floor: Fraction
    ceiling: Fraction | None = None
    step: Fraction = Fraction(0)
    condition: str = ""
    fixed: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """Statistics by name ("best", "mean", …) as printed in one table, over `n` runs."""

    problem_name: str
    algorithm: str
    quantity: str
    n: int
    cells: Mapping[str, TableCell]
    scientific: bool
    function: FunctionBounds | None = None

    @property
    def floor(self) -> Fraction | None:
        """A number that no run lies below, in doubles; None where none is known."""
        return self.function.floor if self.function else None

    @property
    def ceiling(self) -> Fraction | None:
        """A number that no run lies above; None where none is known."""
        return self.function.ceiling if self.function else None

    def printed(self, statistic: str) -> Printed:
        """Return the number as printed."""
        return self.cells[statistic].printed

    def span(self, statistic: str) -> Span | None:
        """Return what can stand behind it, no lower than the floor; None where not printed."""
        if statistic not in self.cells:
            return None
        spread = statistic == "std"
        whole = statistic_span(self.printed(statistic), scientific=self.scientific, spread=spread)
        if spread or self.floor is None:
            return whole
        return Span(max(whole.low, self.floor), max(whole.high, self.floor))
