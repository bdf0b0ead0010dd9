"""What a table prints beside the statistics of runs: tallies, successes, tests and rankings."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from repro.tables.blocks import Block
from repro.tables.relations import Cell, RankTest

Ties = Literal["any", "least", "greatest", "mean", "dense", "order"]
"""Which rank equal values get: the best of their places, the worst, the mean, as if there were no
places between (dense), or one each in some order. "any" leaves it open."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WinsAndLosses:
    """How often an algorithm wins, ties and loses on so many `problems`; None where not known.

    A column that is not printed is None. Where the number `is_told` it is that of a caption, else
    that of the lines of the table, which may show a part, or more than is counted.
    """

    wins: Cell | None
    ties: Cell | None
    losses: Cell | None
    problems: int | None = None
    is_told: bool = True

    @property
    def cells(self) -> tuple[Cell, ...]:
        """The counts that are printed."""
        return tuple(cell for cell in (self.wins, self.ties, self.losses) if cell is not None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Success:
    """A share of n runs that end at `threshold` or below; in percent, or out of 1.

    `block` holds the statistics of the same runs. Where the runs maximise, a success ends at the
    threshold or above. Where the number of runs is not told, it is at most `runs`. `condition` is
    what a contradiction to the threshold needs to be one.
    """

    rate: Cell
    runs: int
    percent: bool = True
    threshold: Fraction | None = None
    block: Block | None = None
    is_told: bool = True
    condition: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Decision:
    """What is printed of one test: p, z, r = z/√N, and whether the hypothesis is rejected.

    `decided` is the cell that says so, if it is not p itself. `n` is the size of each sample, or
    the number of pairs; `sides` those of p, and None where that is not told. `tally` holds the
    wins and losses of a sign test.
    """

    p: Cell
    z: Cell | None = None
    r: Cell | None = None
    rejects: bool | None = None
    decided: Cell | None = None
    alpha: Fraction = Fraction(1, 20)
    sides: Literal[1, 2] | None = None
    test: RankTest | None = None
    n: int | None = None
    tally: WinsAndLosses | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RankedRows:
    """Columns that are ranked row by row, with the sums or means of their ranks.

    `values` has a mapping from column to cell for every row that is ranked, and `ranks` one with
    the printed ranks; either may be empty. `places` ranks the sums or means. Rank 1 is the least
    value, or the greatest where `greatest_first`.
    """

    values: tuple[Mapping[str, Cell], ...] = ()
    ranks: tuple[Mapping[str, Cell], ...] = ()
    sums: Mapping[str, Cell] | None = None
    means: Mapping[str, Cell] | None = None
    places: Mapping[str, Cell] | None = None
    ties: Ties = "any"
    greatest_first: bool = False


Fact = WinsAndLosses | Success | Decision | RankedRows
