"""SMWOA: what is measured for the cells of Table 3, and how near it must come."""

from dataclasses import replace

from papers.smwoa2022.experiments import BENCHMARK, F, contest
from papers.smwoa2022.printed import TABLE_3
from repro.model.claims import CellClaim, computed_cells, every_cell
from repro.model.measures.measure import Measure
from repro.model.measures.ranks import ContestPlace, MeanRank, RankSum, Samples
from repro.model.tolerances import Absolute, Fitness, Percent, Tolerance
from repro.tables.true_numbers import ZERO_STD

# Declared before any run. A factor of ten near zero, since a table of 30 heavy-tailed runs moves
# by decades from one batch to the next; a quarter of the value elsewhere, but 1 % for the averages
# on F12 to F14, where every run that finds the deepest basin agrees in three digits.
FITNESS = Fitness(decades=1, near_zero=0.01, percent=25)
FITNESS_STD = replace(FITNESS, zero=ZERO_STD)
ONE_BASIN = ("F12", "F13", "F14")
# A p-value of rank sums moves by decades from one table of 30 runs to the next.
P_VALUE = Fitness(decades=1, near_zero=0.01, percent=25)
# An average rank over 15 functions moves by 1/15 when two algorithms change places once.
MEAN_RANK = Absolute(0.1)


def statistics(functions: tuple[str, ...], within: Tolerance) -> tuple[CellClaim, ...]:
    """Return the claims of Table 3 on averages and standard deviations of these functions."""
    return every_cell(
        TABLE_3,
        of=BENCHMARK,
        rows=("problem", "statistic"),
        columns="algorithm",
        names={"Avg": "mean", "Std": "std"},
        within=within,
        std_within=FITNESS_STD,
        only=tuple(f"{name} {kind}" for name in functions for kind in ("Avg", "Std")),
    )


def probabilities(samples: Samples = "all runs") -> tuple[CellClaim, ...]:
    """Return the claims of the row of p-values, by what the test is taken to compare."""

    def measure(_row: str, column: str) -> Measure:
        return RankSum(
            experiment=BENCHMARK.name,
            problems=F,
            algorithm="SMWOA",
            against=column,
            samples=samples,
        )

    return computed_cells(TABLE_3, measure=measure, within=P_VALUE, only=("p/h",))


def ranking(statistic: str = "mean") -> tuple[CellClaim, ...]:
    """Return the claims of the last two rows of Table 3, ranked by a statistic of the runs."""
    of = replace(contest(*F), statistic=statistic)

    def mean_rank(_row: str, column: str) -> Measure:
        return MeanRank(contest=of, algorithm=column)

    def place(_row: str, column: str) -> Measure:
        return ContestPlace(contest=of, algorithm=column)

    return (
        *computed_cells(TABLE_3, measure=mean_rank, within=MEAN_RANK, only=("Average ranking",)),
        *computed_cells(TABLE_3, measure=place, within=Absolute(0), only=("Total rank",)),
    )


TABLE_3_CLAIMS = (
    *statistics(tuple(name for name in F if name not in ONE_BASIN), FITNESS),
    *statistics(ONE_BASIN, Percent(1)),
    *probabilities(),
    *ranking(),
)
