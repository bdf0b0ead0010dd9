"""The blocks of a paper's tables, with what is known of the functions behind them."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from types import MappingProxyType

from repro.functions import FUNCTIONS, BenchmarkProblem, Function
from repro.model.claims import CellClaim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.statistics.named import is_count
from repro.tables.blocks import Block, FunctionBounds
from repro.tables.true_numbers import exact, is_scientific

# Functions that add terms of fixed size which cancel at the minimum: near it every value is a
# multiple of the spacing of doubles at the smallest of these terms.
CANCELLING = {"ackley": 2.0**-51, "rastrigin": 2.0**-49}
CONDITIONS = {
    "ackley": "the four terms are computed as doubles and then added, in whatever order: near the "
    "minimum each of them, 20 and e included, is a multiple of this step",
    "rastrigin": "x² is first added to 10 or to −10 cos(2πx), as the formula reads from left to "
    "right and with 10n added at the end: both terms of size 10 are multiples of this step",
}
# Terms that cancel at the minimum, in sum: a value computed in single precision may be below the
# minimum by a few roundings of them. 0: a sum of squares or sizes, rounded or not, is none below 0,
# and no rounding of Griewank's product of cosines is above the 1 that is added.
CANCELLED: Mapping[str, int] = MappingProxyType(
    {
        "ackley": 46,
        "branin": 30,
        "goldstein_price": 1000,
        "foxholes": 4,
        "six_hump_camel": 4,
        **dict.fromkeys(("hartmann_3", "hartmann_6", "shekel_5", "shekel_7", "shekel_10"), 16),
    }
)
ELSE_CANCELLED = 256  # times the minimum, of other functions: a generous guess
ROUNDINGS = Fraction(1, 2**20)  # 16 roundings in single precision
# Functions whose minimum is that of all space, so that no run is below it outside the box either.
LEAST_OF_ALL_SPACE = frozenset(
    {
        *("sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21", "rosenbrock", "rastrigin"),
        *("ackley", "alpine_1", "penalized_1", "penalized_2", "foxholes", "branin"),
        *("goldstein_price", "step", "step_floor", "quartic_noise", "griewank"),
        # the point of the box next to one outside is nearer to every well, in every coordinate
        *("hartmann_3", "hartmann_6", "shekel_5", "shekel_7", "shekel_10"),
        "six_hump_camel",  # above 0 outside, even with -(u² + v²) / 2 in the place of uv
    }
)


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
        "step": lambda n: n * Fraction(1005, 10) ** 2,
        "step_floor": lambda n: Fraction(n * 100**2),
        # the sum of i up to n, and noise below 1
        "quartic_noise": lambda n: Fraction(n * (n + 1), 2) * Fraction(128, 100) ** 4 + 1,
        "schwefel_2_26": lambda n: Fraction(500 * n),  # no sine is above 1
        "griewank": lambda n: n * Fraction(600**2, 4000) + 2,
        "alpine_1": lambda n: Fraction(11 * n),
        "penalized_1": _penalized_1,
        "penalized_2": lambda n: n * 100 * 45**4 + Fraction(1 + 2 * n * 51**2, 10),
        "foxholes": lambda _: Fraction(500),
        # convex in v, so greatest at v = -5 or 15; there below 378 but for v = -5 and u <= -4,
        # where the bowl is at least -22.1875 and cos u at most cos 5
        "branin": lambda _: Fraction(221875, 10000) ** 2 + Fraction(27244, 10000) + 10,
        # Bernstein coefficients of the polynomial on parts of the box are below
        "goldstein_price": lambda _: Fraction(1015691),
        # the cubic in u² has its inner peak, below 3, near u² = 1.46 and is greatest at u² = 25; so
        # is 4 v⁴ - 4 v², which is convex in v²
        "six_hump_camel": lambda _: 100 - Fraction(21, 10) * 625 + Fraction(5**6, 3) + 25 + 2400,
        **dict.fromkeys(
            ("hartmann_3", "hartmann_6", "shekel_5", "shekel_7", "shekel_10"), lambda _: Fraction(0)
        ),
        # kowalik has none: its denominators vanish inside the box
    }
)
# Where a ceiling holds, if on more than the function's own box.
CEILING_BOXES = MappingProxyType({"branin": ((-5.0, 10.0), (-5.0, 15.0))})


def blocks(paper: Paper) -> tuple[Block, ...]:
    """Return the blocks of all tables of the paper, in the order of its claims."""
    experiments = {experiment.name: experiment for experiment in paper.experiments}
    found: dict[tuple[str, ...], dict[str, CellClaim]] = {}
    for claim in paper.claims:
        if not isinstance(claim, CellClaim) or not isinstance(claim.measure, Statistic):
            continue
        if not is_count(claim.measure.statistic):  # a count of runs is no cost
            key = (claim.table.label, *claim.measure.cell, claim.measure.quantity)
            found.setdefault(key, {})[claim.measure.statistic] = claim
    return tuple(
        Block(
            problem_name=problem,
            algorithm=algorithm,
            quantity=quantity,
            n=experiments[experiment].runs,
            cells={name: claim.cell for name, claim in claims.items()},
            scientific=is_scientific(next(iter(claims.values())).table),
            function=_bounds(experiments[experiment].problems.get(problem), quantity),
            maximise=experiments[experiment].maximise and quantity == "cost",
        )
        for (_, experiment, problem, algorithm, quantity), claims in found.items()
    )


def _bounds(problem: object, quantity: str) -> FunctionBounds | None:
    """Return what is known of a problem's costs; None where it is no benchmark function of ours."""
    if not isinstance(problem, BenchmarkProblem) or quantity != "cost":
        return None
    return bounds_of(problem)


def bounds_of(problem: BenchmarkProblem) -> FunctionBounds:
    """Return what no value of the function in so many dimensions is outside of."""
    function = problem.function
    known = function.name if _is_ours(function) else ""
    least = exact(problem.minimum)
    step = Fraction(CANCELLING.get(known, 0))
    return FunctionBounds(
        title=function.title,
        minimum=least,
        floor=least - max(abs(least) / 2**40, 4 * step),
        floor_in_singles=least - _cancelled(problem) * ROUNDINGS,
        only_in_box=known not in LEAST_OF_ALL_SPACE,
        ceiling=_ceiling(problem),
        step=step,
        condition=CONDITIONS.get(known, ""),
        fixed=(function(function.minimiser(problem.dimension)), problem.minimum),
    )


def _is_ours(function: Function) -> bool:
    """Say whether what is known here is known of this very function, and not of its namesake."""
    ours = FUNCTIONS.get(function.name)
    return ours is not None and ours.kernel is function.kernel


def _cancelled(problem: BenchmarkProblem) -> Fraction:
    """Return the size of the terms that cancel at the minimum of the function."""
    if problem.function.name in CANCELLED and _is_ours(problem.function):
        return Fraction(CANCELLED[problem.function.name])
    return abs(exact(problem.minimum)) * ELSE_CANCELLED


def _ceiling(problem: BenchmarkProblem) -> Fraction | None:
    """Return the ceiling, where it is known on the box that the paper gives the function."""
    function = problem.function
    if function.name not in CEILINGS or not _is_ours(function):
        return None
    known = CEILING_BOXES.get(function.name, FUNCTIONS[function.name].box)
    sides = zip(function.box, known, strict=True)
    if not all(least <= low and high <= most for (low, high), (least, most) in sides):
        return None
    ceiling = CEILINGS[function.name](problem.dimension)
    return ceiling + abs(ceiling) / 2**40
