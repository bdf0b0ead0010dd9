"""The printed statistics of one algorithm on one problem, and what they are statistics of."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from repro.tables.arithmetic import NARROWEST, Arithmetic, statistic_span
from repro.tables.published import Printed
from repro.tables.relations import Cell
from repro.tables.statistic_words import SPREADS, is_width, quantile_share
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
    fixed: tuple[float | Fraction, ...] = ()


_ENDS = {"best": "worst", "worst": "best"}


def known_minimum(title: str, minimum: Fraction) -> FunctionBounds:
    """Return the bounds of values of which no more is known than that none lies below `minimum`.

    `title` names them in a sentence, such as "an error". Runs may be below by some roundings.
    """
    return FunctionBounds(
        title=title,
        minimum=minimum,
        floor=minimum - abs(minimum) / 2**40,
        floor_in_singles=minimum - abs(minimum) / 2**12,
        fixed=(float(minimum),),
    )


@dataclass(frozen=True, kw_only=True)  # no slots: what follows from the fields is kept
class Block:
    """Statistics by name ("best", "mean", …) as printed in one table, over `n` runs.

    The best run is the least one, or the greatest where the runs `maximise`; a block that is
    `turned` names the least one "best" whatever the print calls it, as all checks expect. `given`
    is what is taken for granted of how the numbers were made. Runs that are `whole_numbers` are
    counts, or costs of which each is whole.
    """

    problem_name: str
    algorithm: str
    quantity: str
    n: int
    cells: Mapping[str, Cell]
    scientific: bool
    function: FunctionBounds | None = None
    given: Arithmetic = NARROWEST
    maximise: bool = False
    whole_numbers: bool = False
    turned: bool = False

    @cached_property
    def floor(self) -> Fraction | None:
        """A number that no run lies below; None where none is known."""
        function = self.function
        if function is None or (function.only_in_box and not self.given.in_box):
            return None
        if not self.given.doubles:
            return function.floor_in_singles
        return max(function.floor, function.floor_in_singles)  # doubles lose no more than singles

    @cached_property
    def ceiling(self) -> Fraction | None:
        """A number that no run lies above; None where none is known."""
        if self.function is None or self.function.ceiling is None:
            return None
        # a value so large is a sum or product of far fewer than 2^10 roundings
        return self.function.ceiling + abs(self.function.ceiling) * self.given.roundoff * 2**10

    @cached_property
    def mean_error(self) -> Fraction:
        """How far a computed mean may be from the true one, in whatever order it is summed."""
        return 2 * (self.n + 2) * self.given.roundoff * self.size

    @cached_property
    def greatest_mean(self) -> Fraction:
        """How large the mean can be, its sign aside."""
        return _reach(self.own_span("mean")) if "mean" in self.cells else self.size

    @cached_property
    def spread(self) -> str | None:
        """The statistic that says the standard deviation; None where none does."""
        return next((name for name in SPREADS if name in self.cells), None)

    def word(self, statistic: str) -> str:
        """Return what the print calls a statistic."""
        return _ENDS.get(statistic, statistic) if self.turned else statistic

    def named(self, statistic: str) -> str:
        """Return what the print calls a statistic, and the number."""
        return f"{self.word(statistic)} {self.printed(statistic).text}"

    def printed(self, statistic: str) -> Printed:
        """Return the number as printed."""
        return self.cells[statistic].printed

    def own_span(self, statistic: str) -> Span:
        """Return what can stand behind a printed statistic, whatever the function is."""
        if statistic not in self._own_spans:
            self._own_spans[statistic] = self._own_span(statistic)
        return self._own_spans[statistic]

    @cached_property
    def _own_spans(self) -> dict[str, Span]:
        return {}

    def _own_span(self, statistic: str) -> Span:
        around = self._print_span(statistic)
        if statistic == "mean":
            error = self.mean_error
        elif quantile_share(statistic) is not None:  # half the sum of two runs, or near it
            error = 2 * self.given.roundoff * _reach(around)
        else:
            return around
        return Span(around.low - error, around.high + error)

    def span(self, statistic: str) -> Span | None:
        """Return what can stand behind it, no lower than the floor; None where not printed."""
        if statistic not in self.cells:
            return None
        whole, floor = self.own_span(statistic), self.floor
        if is_width(statistic) or floor is None:
            return whole
        return Span(max(whole.low, floor), max(whole.high, floor))

    def variances(self, statistic: str) -> Span | None:
        """Return what can be the square of the standard deviation that a spread says."""
        around = self.own_span(statistic)
        if around.high < 0:
            return None
        low, high = max(around.low, Fraction(0)), around.high
        if statistic == "variance":
            return Span(low, high)
        runs = self.n if statistic == "standard error" else 1
        return Span(low**2 * runs, high**2 * runs)

    def _print_span(self, statistic: str) -> Span:
        return statistic_span(
            self.printed(statistic),
            scientific=self.scientific,
            spread=statistic if statistic in SPREADS else "",
            given=self.given,
        )

    @cached_property
    def size(self) -> Fraction:
        """What the mean of the absolute values of the runs is at most."""
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


def turned(block: Block) -> Block:
    """Return the block with the least run named "best", whichever the print calls so."""
    if not block.maximise or block.turned:
        return block
    cells = {_ENDS.get(name, name): cell for name, cell in block.cells.items()}
    return replace(block, cells=cells, turned=True)


def _reach(around: Span) -> Fraction:
    return max(abs(around.low), abs(around.high))
