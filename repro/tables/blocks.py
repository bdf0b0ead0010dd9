"""The printed statistics of one algorithm on one problem, and what they are statistics of."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from repro.functions import FUNCTIONS, BenchmarkProblem, Function
from repro.model.claims import CellClaim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.tables.published import Printed
from repro.tables.relations import TableCell
from repro.tables.true_numbers import Span, exact, is_scientific, statistic_span

# Functions that add terms of fixed size which cancel at the minimum: near it every value is a
# multiple of the spacing of doubles at the smallest of these terms.
CANCELLING = {"ackley": 2.0**-51, "rastrigin": 2.0**-49}


def _penalized_1(n: int) -> Fraction:
    """Return 355/113 > π over n times the greatest terms, and the penalty at 50."""
    step = Fraction(51, 4) ** 2  # (y - 1)² at x = 50
    return Fraction(355, 113) / n * (10 + step + 11 * (n - 1) * step) + n * 100 * 40**4


# What no value of a function in n dimensions exceeds on its box: each term at its greatest. A run
# that starts inside the box has a best of that at most, wherever it goes later.
CEILINGS: Mapping[str, Callable[[int], Fraction]] = MappingProxyType(
    {
        "sphere": lambda n: Fraction(n * 100**2),
        "schwefel_2_22": lambda n: Fraction(10 * n + 10**n),
        "schwefel_1_2": lambda n: Fraction(100**2 * n * (n + 1) * (2 * n + 1), 6),
        "schwefel_2_21": lambda _: Fraction(100),
        "rosenbrock": lambda n: Fraction((n - 1) * (100 * (30 + 30**2) ** 2 + 31**2)),
        "rastrigin": lambda n: n * (Fraction(512, 100) ** 2 + 20),
        "ackley": lambda _: Fraction(23),  # 20 + e and no less than 0 taken away
        "alpine_1": lambda n: Fraction(11 * n),
        "penalized_1": _penalized_1,
        "penalized_2": lambda n: n * 100 * 45**4 + Fraction(1 + 2 * n * 51**2, 10),
        "foxholes": lambda _: Fraction(500),
        # convex in v, so greatest at v = -5 or 15; there below 378 but for v = -5 and u <= -4,
        # where the bowl is at least -22.1875 and cos u at most cos 5
        "branin": lambda _: Fraction(221875, 10000) ** 2 + Fraction(27244, 10000) + 10,
        # Bernstein coefficients of the polynomial on parts of the box are below
        "goldstein_price": lambda _: Fraction(1015691),
        "hartmann_3": lambda _: Fraction(0),
        "shekel_5": lambda _: Fraction(0),
    }
)
# Where a ceiling holds, if on more than the function's own box.
CEILING_BOXES = MappingProxyType({"branin": ((-5.0, 10.0), (-5.0, 15.0))})


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """Statistics by name ("best", "mean", …) as printed in one table, over `n` runs."""

    problem_name: str
    algorithm: str
    quantity: str
    problem: Any
    n: int
    claims: Mapping[str, CellClaim]
    scientific: bool

    @property
    def function(self) -> Function | None:
        """The benchmark function whose values these are."""
        known = isinstance(self.problem, BenchmarkProblem) and self.quantity == "cost"
        return self.problem.function if known else None

    @property
    def floor(self) -> Fraction | None:
        """A number that no run lies below, in doubles; None where none is known."""
        if self.function is None:
            return None
        least = exact(self.function.minimum)
        slack = max(abs(least) / 2**40, 4 * Fraction(CANCELLING.get(self.function.name, 0)))
        return least - slack

    @property
    def ceiling(self) -> Fraction | None:
        """A number that no run lies above; None where none is known."""
        if self.function is None or not _has_ceiling(self.function):
            return None
        most = CEILINGS[self.function.name](self.problem.dimension)
        return most + abs(most) / 2**40

    def printed(self, statistic: str) -> Printed:
        """Return the number as printed."""
        return self.claims[statistic].printed

    def cell(self, statistic: str) -> TableCell:
        """Return where it stands."""
        claim = self.claims[statistic]
        return TableCell(table=claim.table, row=claim.row, column=claim.column)

    def span(self, statistic: str) -> Span | None:
        """Return what can stand behind it, no lower than the floor; None where not printed."""
        if statistic not in self.claims:
            return None
        spread = statistic == "std"
        whole = statistic_span(self.printed(statistic), scientific=self.scientific, spread=spread)
        if spread or self.floor is None:
            return whole
        return Span(max(whole.low, self.floor), max(whole.high, self.floor))


def _has_ceiling(function: Function) -> bool:
    """Return whether the ceiling of the function is known on the box that the paper gives it."""
    if function.name not in CEILINGS:
        return False
    known = CEILING_BOXES.get(function.name, FUNCTIONS[function.name].box)
    sides = zip(function.box, known, strict=True)
    return all(least <= low and high <= most for (low, high), (least, most) in sides)


def blocks(paper: Paper) -> tuple[Block, ...]:
    """Return the blocks of all tables of the paper, in the order of its claims."""
    experiments = {experiment.name: experiment for experiment in paper.experiments}
    found: dict[tuple[str, ...], dict[str, CellClaim]] = {}
    for claim in paper.claims:
        if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic):
            key = (claim.table.label, *claim.measure.cell, claim.measure.quantity)
            found.setdefault(key, {})[claim.measure.statistic] = claim
    return tuple(
        Block(
            problem_name=problem,
            algorithm=algorithm,
            quantity=quantity,
            problem=experiments[experiment].problems[problem],
            n=experiments[experiment].runs,
            claims=claims,
            scientific=is_scientific(next(iter(claims.values())).table),
        )
        for (_, experiment, problem, algorithm, quantity), claims in found.items()
    )
