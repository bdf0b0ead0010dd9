"""SMWOA: minimum-time motion of a UR5 with a slime mould whale optimisation algorithm."""

from dataclasses import replace
from typing import Literal

from papers.smwoa2022.experiments import BENCHMARK, SMWOA, TRAJECTORY, UR5, F, contest
from papers.smwoa2022.open_points import ASSUMPTIONS, ERRATA, GAPS
from papers.smwoa2022.printed import TABLE_2, TABLE_3, TABLE_4, TABLE_5, TABLE_6
from papers.smwoa2022.relations import RELATIONS
from papers.smwoa2022.sentences import SENTENCES, TIME, printed_durations
from repro.claims import CellClaim, computed_cells, every_cell
from repro.figures import SplineMotion
from repro.measures import Measure
from repro.model import Paper, Reading, Source
from repro.ranking import MeanRank, Place, RankSum
from repro.verdict import ZERO_STD, Absolute, Fitness, Percent, Tolerance

__all__ = ["PAPER", "SMWOA"]

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


Summary = Literal["p/h", "Average ranking", "Total rank"]


def summary(row: Summary, within: Tolerance) -> tuple[CellClaim, ...]:
    """Return the claims of one of the last three rows of Table 3."""

    def measure(_row: str, column: str) -> Measure:
        if row == "p/h":
            return RankSum(experiment=BENCHMARK.name, problems=F, algorithm="SMWOA", against=column)
        kind = MeanRank if row == "Average ranking" else Place
        return kind(contest=contest(*F), algorithm=column)

    return computed_cells(TABLE_3, measure=measure, within=within, only=(row,))


PAPER = Paper(
    key="smwoa2022",
    read_twice=True,
    source=Source(
        authors="authors not on the copy",
        title="Joints Trajectory Planning of Robot Based on Slime Mould Whale Optimization "
        "Algorithm",
        year=2022,
        journal="Algorithms 15(10), 363",
        doi="10.3390/a15100363",
        note="the copy at hand omits the authors",
    ),
    summary="A whale optimisation with parts of the slime mould algorithm (SMWOA) beats WOA, PSO, "
    "GSA, DE and SMA on fifteen test functions and cuts a motion of a UR5 through six nodes from "
    "39.526 s to 24.635 s.",
    experiments=(BENCHMARK, TRAJECTORY),
    inputs=(TABLE_2, TABLE_4, TABLE_5),
    results=(TABLE_3, TABLE_6),
    claims=(
        *statistics(tuple(name for name in F if name not in ONE_BASIN), FITNESS),
        *statistics(ONE_BASIN, Percent(1)),
        *summary("p/h", P_VALUE),
        *summary("Average ranking", MEAN_RANK),
        *summary("Total rank", Absolute(0)),
        *every_cell(
            TABLE_6,
            of=TRAJECTORY,
            rows=("algorithm",),
            columns="quantity",
            given={"problem": "UR5", "statistic": "single"},
            names={"Total Time": "total"} | {f"h{k}": f"duration {k}" for k in range(1, 6)},
            within=TIME,
        ),
        *SENTENCES,
    ),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=GAPS,
    relations=RELATIONS,
    readings=(
        Reading(
            name="at rest at both ends, Eq. (20) for time",
            of=("trajectory", "UR5"),
            problem=replace(UR5, ends="still"),
        ),
        Reading(
            name="at rest at both ends, natural spline for time",
            of=("trajectory", "UR5"),
            problem=replace(UR5, ends="still", time_ends="natural"),
        ),
    ),
    figures=(
        SplineMotion(
            label="Fig. 3",
            caption="Angle of the base joint with the printed durations, the re-run ones, and "
            "those of the proved optimum",
            problem=UR5,
            durations=printed_durations("SMWOA"),
            experiment="trajectory",
            algorithms=("SMWOA",),
            joints=(1,),
            derivatives=(0,),
        ),
        SplineMotion(
            label="Fig. 4",
            caption="Angle, velocity, acceleration and jerk of the six joints with the printed "
            "durations of SMWOA",
            problem=UR5,
            durations=printed_durations("SMWOA"),
            experiment="trajectory",
            algorithms=("SMWOA",),
            joints=(1, 2, 3, 4, 5, 6),
            derivatives=(0, 1, 2, 3),
        ),
    ),
)
