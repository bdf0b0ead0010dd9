"""The blocks of a paper's tables, with what is known of the functions behind them."""

from fractions import Fraction

from repro.functions import BenchmarkProblem
from repro.model.claims import CellClaim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.statistics.named import is_count
from repro.tables.blocks import Block, FunctionBounds
from repro.tables.true_numbers import exact, is_scientific

ELSE_CANCELLED = 256  # times the minimum, of other functions: a generous guess
ROUNDINGS = Fraction(1, 2**20)  # 16 roundings in single precision


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
    tables = {
        claim.table.label: claim.table for claims in found.values() for claim in claims.values()
    }
    scientific = {label: is_scientific(table) for label, table in tables.items()}
    return tuple(
        Block(
            problem_name=problem,
            algorithm=algorithm,
            quantity=quantity,
            n=experiments[experiment].runs,
            cells={name: claim.cell for name, claim in claims.items()},
            scientific=scientific[label],
            function=_bounds(experiments[experiment].problems.get(problem), quantity),
            maximise=experiments[experiment].maximise and quantity == "cost",
        )
        for (label, experiment, problem, algorithm, quantity), claims in found.items()
    )


def _bounds(problem: object, quantity: str) -> FunctionBounds | None:
    """Return what is known of a problem's costs; None where it is no benchmark function of ours."""
    if not isinstance(problem, BenchmarkProblem) or quantity != "cost":
        return None
    return bounds_of(problem)


def bounds_of(problem: BenchmarkProblem) -> FunctionBounds:
    """Return what no value of the function in so many dimensions is outside of."""
    function = problem.function
    known = function.bounds_known
    most = known.most(function.box, problem.dimension)
    least = exact(problem.minimum)
    step = Fraction(known.step)
    cancelled = abs(least) * ELSE_CANCELLED if known.cancelled is None else known.cancelled
    return FunctionBounds(
        title=function.title,
        minimum=least,
        floor=least - max(abs(least) / 2**40, 4 * step),
        floor_in_singles=least - cancelled * ROUNDINGS,
        only_in_box=not known.least_of_all_space,
        ceiling=None if most is None else most + abs(most) / 2**40,
        step=step,
        condition=known.condition,
        fixed=(function(function.minimiser(problem.dimension)), problem.minimum),
    )
