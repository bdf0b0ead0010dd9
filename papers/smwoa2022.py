"""SMWOA: minimum-time motion of a UR5 with a slime mould whale optimisation algorithm."""

from dataclasses import replace
from typing import Any

import numpy as np

from repro.functions import FUNCTIONS, BenchmarkProblem
from repro.model import (
    ZERO_STD, Absolute, Arm, ArmMotion, AverageRank, Between, CellClaim, Contest, ContestPlace,
    Experiment, Firsts, Fitness, Measure, MeanRank, MotionReading, Percent, PercentLower, Printed,
    PublishedTable, PValues, Rank, RankSum, Reduction, Samples, Sentence, SplineMotion, TableCell,
    TextNumber, Tolerance, computed, computed_cells, every_cell, everywhere, prose, ranked,
    row_sums, runs_of, says, says_in_words,
)  # fmt: skip
from repro.optimisers import DE, GSA, PSO, SMA, WOA, SlimeWOA
from repro.robotics import MinimumTimeSpline, dh_rows
from repro.robotics.spline_motion import motion

TEXT = prose(__file__)
TABLE_2 = PublishedTable.read("""
    Table 2, section 3.3
    Functions       || Dimension | Search Space [text] | Optimal Value
    Sphere          || 30        | [-100, 100]         | 0
    Schwefel 2.22   || 30        | [-10, 10]           | 0
    Schwefel 1.12   || 30        | [-100, 100]         | 0
    Schwefel 2.21   || 30        | [-100, 100]         | 0
    Rosenbrock      || 30        | [-30, 30]           | 0
    Rastrigin       || 30        | [-5.12, 5.12]       | 0
    Ackley          || 30        | [-32, 32]           | 0
    Alpine          || –         | [-10, 10]           | 0
    Penalized 1.1   || 30        | [-50, 50]           | 0
    Penalized 1.2   || 30        | [-50, 50]           | 0
    Michalewicz     || 2         | [-65.536, 65.536]   | 1
    Branin          || 2         | [-5, 5]             | 0.398
    Goldstein-Price || 2         | [-2, 2]             | 3
    Hartmann-3D     || 3         | [0, 1]              | -3.86
    Shekel 5        || 4         | [0, 10]             | -10.1532
""")
TABLE_3 = PublishedTable.read("""
    Table 3, section 3.3 (30 runs)
    Functions | Evaluation Indexes || SMWOA | WOA | PSO | GSA | DE | SMA
    F1  | Avg || 0.00×10^0   | 7.91×10^-74 | 3.72×10^0   | 1.23×10^-18 | 1.78×10^-92 | 2.74×10^-108
        | Std || 0.00×10^0   | 4.32×10^-74 | 2.65×10^-15 | 5.62×10^-22 | 0.69×10^-91 | 3.11×10^-112
    F2  | Avg || 3.57×10^-67 | 1.86×10^-49 | 2.05×10^-1  | 6.46×10^-10 | 3.09×10^-1  | 3.75×10^-24
        | Std || 2.51×10^-64 | 2.39×10^-48 | 1.52×10^-1  | 0.00×10^0   | 2.78×10^-1  | 2.89×10^-26
    F3  | Avg || 3.72×10^-82 | 4.31×10^-6  | 3.89×10^-3  | 1.13×10^-3  | 3.74×10^-5  | 2.25×10^-45
        | Std || 6.59×10^-79 | 2.93×10^-5  | 2.67×10^-3  | 2.56×10^-25 | 2.78×10^-4  | 5.68×10^-49
    F4  | Avg || 2.58×10^-16 | 7.25×10^-12 | 4.56×10^-8  | 7.86×10^-10 | 3.72×10^-14 | 2.74×10^-23
        | Std || 3.67×10^-15 | 3.97×10^-12 | 3.28×10^-9  | 3.57×10^-9  | 2.88×10^-13 | 3.11×10^-26
    F5  | Avg || 2.75×10^-33 | 2.79×10^1   | 4.52×10^2   | 2.36×10^1   | 3.74×10^0   | 3.75×10^-24
        | Std || 3.69×10^-31 | 7.63×10^-1  | 1.64×10^2   | 1.04×10^-1  | 2.52×10^0   | 2.89×10^-26
    F6  | Avg || 5.04×10^-29 | 1.06×10^-21 | 1.29×10^2   | 2.32×10^1   | 5.27×10^-3  | 0.00×10^0
        | Std || 6.52×10^-30 | 2.39×10^-21 | 3.64×10^1   | 7.85×10^-18 | 6.43×10^-6  | 0.00×10^0
    F7  | Avg || 6.54×10^-28 | 5.39×10^-15 | 3.77×10^-3  | 6.32×10^-8  | 4.47×10^-4  | 2.74×10^-26
        | Std || 6.17×10^-27 | 2.93×10^-6  | 2.58×10^-4  | 2.24×10^-7  | 3.23×10^-4  | 3.11×10^-24
    F8  | Avg || 6.24×10^-39 | 1.26×10^-2  | 5.79×10^-1  | 3.58×10^0   | 3.78×10^-2  | 3.75×10^-24
        | Std || 2.63×10^-39 | 3.97×10^-1  | 2.35×10^-3  | 2.79×10^-1  | 9.01×10^-1  | 2.89×10^-26
    F9  | Avg || 4.37×10^-15 | 3.05×10^-3  | 5.69×10^0   | 1.32×10^0   | 7.63×10^-1  | 2.25×10^-15
        | Std || 3.62×10^-15 | 7.60×10^-2  | 2.29×10^0   | 1.59×10^-1  | 5.22×10^-2  | 5.61×10^-17
    F10 | Avg || 2.47×10^-10 | 8.97×10^0   | 3.74×10^0   | 5.22×10^-1  | 3.24×10^-1  | 2.74×10^-8
        | Std || 3.64×10^-11 | 6.69×10^0   | 2.28×10^0   | 5.32×10^-1  | 2.56×10^0   | 3.11×10^-9
    F11 | Avg || 1.80×10^0   | 3.76×10^0   | 1.89×10^0   | 4.59×10^0   | 2.58×10^0   | 1.75×10^0
        | Std || 1.08×10^0   | 2.59×10^0   | 1.37×10^0   | 3.26×10^0   | 3.97×10^0   | 2.89×10^-1
    F12 | Avg || 0.42034     | 0.42718     | 0.41581     | 0.40278     | 0.39997     | 0.43669
        | Std || 2.55×10^-3  | 3.97×10^-1  | 2.25×10^-2  | 4.14×10^-3  | 6.32×10^-5  | 5.12×10^0
    F13 | Avg || 3.00007     | 3.001       | 3.0019      | 3.0007      | 3.0022      | 3.00011
        | Std || 1.36×10^-4  | 7.62×10^-1  | 1.39×10^0   | 2.67×10^-2  | 2.63×10^1   | 1.05×10^-3
    F14 | Avg || -3.8563     | -3.8349     | -3.8498     | -3.8462     | -3.8547     | -3.8529
        | Std || 3.23×10^-7  | 5.92×10^-2  | 7.68×10^-6  | 3.29×10^-5  | 6.12×10^-8  | 2.86×10^-6
    F15 | Avg || -10.1337    | -8.2895     | -8.1933     | -8.0774     | -8.1324     | -10.1024
        | Std || 3.24×10^-3  | 2.73×10^0   | 4.63×10^0   | 4.89×10^0   | 5.79×10^1   | 1.41×10^-2
    p/h | – || – | 8.24×10^-6/+ | 4.37×10^-7/+ | 2.16×10^-7/+ | 3.12×10^-6/+ | 1.38×10^-5/+
    Average ranking | – || 1.4000 | 3.9333 | 5.1333 | 4.6000 | 3.8000 | 2.1333
    Total rank | – || 1 | 4 | 6 | 5 | 3 | 2
""")
TABLE_4 = PublishedTable.read("""
    Table 4, section 4.3
    Nodes || θ1 [deg] | θ2 [deg] | θ3 [deg] | θ4 [deg] | θ5 [deg] | θ6 [deg]
    1     || 10       | 15       | 20       | 5        | 10       | 6
    2     || -110     | -115     | 60       | 50       | -30      | 50
    3     || 40       | 95       | -35      | 180      | 75       | 80
    4     || 150      | 120      | 80       | 100      | -50      | 30
    5     || 120      | -45      | -80      | 20       | 80       | -80
    6     || -30      | 20       | 60       | -60      | 50       | 100
""")
TABLE_5 = PublishedTable.read("""
    Table 5, section 4.3
    Parameters      || θ1  | θ2  | θ3  | θ4  | θ5  | θ6
    θmax (°)        || 320 | 250 | 270 | 280 | 200 | 300
    θ̇max ((°)/s)    || 100 | 95  | 122 | 150 | 140 | 120
    θ̈max ((°)/s^2)  || 245 | 245 | 475 | 475 | 500 | 500
""")
TABLE_6 = PublishedTable.read("""
    Table 6, section 4.3
    Algorithms || h1 [s] | h2 [s] | h3 [s] | h4 [s] | h5 [s] | Total Time [s]
    SMA        || 4.429  | 6.276  | 4.332  | 5.098  | 5.602  | 25.737
    WOA        || 4.681  | 6.349  | 4.237  | 5.162  | 5.384  | 25.813
    SMWOA      || 4.227  | 6.103  | 4.319  | 4.937  | 5.049  | 24.635
""")
BEFORE = Printed("39.526", "s")  # time of the path before optimisation, section 4.3, Fig. 3
AFTER = TABLE_6["SMWOA", "Total Time"]  # printed in section 4.3, Fig. 3, too
TIME_SAVED = Printed("37.674", "%")  # abstract and section 4.3
# the paper prints no links, see the assumptions
MAKERS_TABLE = PublishedTable.read("""
    Table C.3, Universal Robots CB3 service manual, appendix Robot Parameter (UR5 series 3)
    joint || a [m]    | α [rad] | d [m]
    1     || 0        | π/2     | 0.089159
    2     || -0.42500 | 0       | 0
    3     || -0.39225 | 0       | 0
    4     || 0        | π/2     | 0.10915
    5     || 0        | -π/2    | 0.09465
    6     || 0        | 0       | 0.08230
""")
DH = dh_rows(a=MAKERS_TABLE.column("a"), alpha=MAKERS_TABLE.column("α"), d=MAKERS_TABLE.column("d"))

SMWOA = SlimeWOA(
    control="arctanh",  # Eq. (10)
    weight="of the whale",  # Eqs. (11) and (15)
    weights="per dimension",
    logarithm="decimal",
    swing="per dimension",  # v_b of Eqs. (8) and (13)
    coefficients="scalar",  # Eqs. (4) and (15)
    leader="per whale",  # Eqs. (7) and (14)
    spiral_range="symmetric",  # Eq. (5)
)
WOA_BY_EQUATIONS = SlimeWOA(leader="per whale", spiral_range="symmetric")

MEANT = dict(zip(TABLE_2.row_names, (  # the function that a row means (see the errata)
    "sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21", "rosenbrock", "rastrigin", "ackley",
    "alpine_1", "penalized_1", "penalized_2", "foxholes", "branin", "goldstein_price",
    "hartmann_3", "shekel_5",
), strict=True))  # fmt: skip
DIMENSIONS = {row: int(TABLE_2[row, "Dimension"].value) for row in MEANT if row != "Alpine"}
DIMENSIONS["Alpine"] = 30  # none is printed
BOXES = {"Branin": ((-5.0, 5.0), (-5.0, 5.0))}  # the others are the functions' own


def problem_of(row: str) -> BenchmarkProblem:
    """Return the problem of a row of Table 2."""
    function = FUNCTIONS[MEANT[row]]
    return replace(function, box=BOXES.get(row, function.box)).problem(DIMENSIONS[row])


def limits(row: int, unit: str) -> tuple[float, ...]:
    """Return one row of Table 5, whose units stand in the row headings, in SI units."""
    name = TABLE_5.row_names[row]
    return tuple(Printed(TABLE_5[name, j].text, unit).si for j in TABLE_5.column_names)


BENCHMARK = Experiment(
    name="benchmark", where="section 3.3", proposed="SMWOA", population=30, iterations=500, runs=30,
    problems={f"F{k}": problem_of(row) for k, row in enumerate(TABLE_2.row_names, start=1)},
    algorithms={
        "SMWOA": SMWOA, "WOA": WOA(), "PSO": PSO(), "GSA": GSA(), "DE": DE(), "SMA": SMA(),
    },
)  # fmt: skip
UR5 = MinimumTimeSpline(
    nodes=TABLE_4.points(), velocity=limits(1, "deg/s"), acceleration=limits(2, "deg/s^2"),
    durations=(0.1, 10.0), ends="repeated", time_ends="repeated",  # Eq. (20)
)  # fmt: skip
TRAJECTORY = Experiment(
    name="trajectory", where="section 4.3", proposed="SMWOA", population=100, iterations=100,
    runs=30, problems={"UR5": UR5}, algorithms={"SMA": SMA(), "WOA": WOA(), "SMWOA": SMWOA},
)  # fmt: skip
EXPERIMENTS = (BENCHMARK, TRAJECTORY)
F = tuple(BENCHMARK.problems)
UNIMODAL, MULTIMODAL, FIXED = F[:5], F[5:10], F[10:]

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
# Declared before any run. Printed to 1 ms; 1 % lets the searches of two programs differ a little.
TIME = Percent(1)


def statistics(functions: tuple[str, ...], within: Tolerance) -> tuple[CellClaim, ...]:
    """Return the claims of Table 3 on averages and standard deviations of these functions."""
    return every_cell(
        TABLE_3, of=BENCHMARK, rows=("problem", "statistic"), columns="algorithm",
        names={"Avg": "mean", "Std": "std"}, within=within, std_within=FITNESS_STD,
        only=tuple(f"{name} {kind}" for name in functions for kind in ("Avg", "Std")),
    )  # fmt: skip


def contest(*problems: str) -> Contest:
    """Return the six algorithms ranked on the problems by the average of their runs."""
    return Contest(
        experiment=BENCHMARK.name, problems=problems, algorithms=tuple(BENCHMARK.algorithms)
    )


def rank_sum(other: str) -> RankSum:
    """Return the rank-sum test of SMWOA against another."""
    return RankSum(experiment=BENCHMARK.name, problems=F, algorithm="SMWOA", against=other)


def probabilities(samples: Samples = "all runs") -> tuple[CellClaim, ...]:
    """Return the claims of the row of p-values, by what the test is taken to compare."""
    return computed_cells(
        TABLE_3, measure=lambda _, other: replace(rank_sum(other), samples=samples),
        within=P_VALUE, only=("p/h",),
    )  # fmt: skip


def ranking(statistic: str = "mean") -> tuple[CellClaim, ...]:
    """Return the claims of the last two rows of Table 3, ranked by a statistic of the runs."""
    of = replace(contest(*F), statistic=statistic)
    return (
        *computed_cells(TABLE_3, measure=lambda _, name: MeanRank(contest=of, algorithm=name),
                        within=MEAN_RANK, only=("Average ranking",)),
        *computed_cells(TABLE_3, measure=lambda _, name: ContestPlace(contest=of, algorithm=name),
                        within=Absolute(0), only=("Total rank",)),
    )  # fmt: skip


def table_6(statistic: str) -> tuple[CellClaim, ...]:
    """Return the claims on the durations, by which of the runs they are taken to be."""
    return every_cell(
        TABLE_6, of=TRAJECTORY, rows=("algorithm",), columns="quantity",
        given={"problem": "UR5", "statistic": statistic}, within=TIME,
        names={"Total Time": "total"} | {f"h{k}": f"duration {k}" for k in range(1, 6)},
    )  # fmt: skip


SECTION, FIGURE_3, FIGURE_4 = "section 3.3", "section 4.3, Fig. 3", "section 4.3, Fig. 4"


def places(printed: dict[str, int]) -> tuple[Sentence, ...]:
    """Return the claims on the place of SMWOA by the average on each function."""
    return ranked(
        contest(*F), algorithm="SMWOA", places=printed, claim="SMWOA ranked by average",
        where=SECTION,
    )  # fmt: skip


def strength(claim: str, functions: tuple[str, ...]) -> Sentence:
    """Return a claim that is read as: SMWOA has the lowest mean rank over the functions."""
    return says_in_words(
        f"{claim} (read as: the lowest mean rank over {', '.join(functions)})", SECTION, "1 rank",
        ContestPlace(contest=contest(*functions), algorithm="SMWOA"), within=Between(1, 1),
    )  # fmt: skip


FIRSTS = Firsts(contest=contest(*F), algorithm="SMWOA")  # the text says on 9 functions
AVERAGE_ON_F4 = runs_of(BENCHMARK, "SMWOA", problem="F4")("cost")
ON_FUNCTIONS = (
    says_in_words(
        "SMWOA is clearly more accurate than the other algorithms on the 15 functions (read as: it "
        "is first, or shares that place, on more than half of them)", "abstract and section 3.3",
        "9", FIRSTS, within=Between(8, 15)),
    *places({"F1": 1, "F2": 1, "F3": 1, "F5": 1}),
    says_in_words(
        "SMWOA is not first on F4 by average (Table 3: second)", SECTION, "2 rank",
        Rank(of=AVERAGE_ON_F4, among=tuple(BENCHMARK.algorithms)), within=Between(2, 6)),
    *places({"F7": 1, "F8": 1, "F10": 1, "F6": 2, "F9": 2}),
    *places({"F13": 1, "F15": 1, "F11": 2, "F12": 2, "F14": 2}),
    strength("SMWOA exploits strongly", UNIMODAL),
    strength("SMWOA explores strongly", MULTIMODAL),
    strength("SMWOA can leave local optima", FIXED),
    strength("SMWOA performs best of the six algorithms over all", F),
    says_in_words(
        "some results of SMWOA are not ideal (read as: it is not first on every function)",
        SECTION, "9", FIRSTS, within=Between(0, 14)),
    *(
        says_in_words(
            f"the rank-sum test marks SMWOA as better than {other} (+, read as 1: lower costs at "
            "the 5 % level, all runs on all functions together)", "Table 3, p/h", "+1",
            replace(rank_sum(other), sign=True), within=Between(1, 1))
        for other in tuple(BENCHMARK.algorithms)[1:]
    ),
)  # fmt: skip

found = runs_of(TRAJECTORY, "SMWOA", "single")
SAVED = Reduction(
    before=computed("the time before optimisation as printed", lambda: BEFORE.si),
    after=found("total"),
)
TIMES = (
    says("before optimisation the motion takes 39.526 s", FIGURE_3, BEFORE, TEXT.gap("before"),
         within=TIME),
    says("after optimisation by SMWOA the motion takes 24.635 s", FIGURE_3, AFTER, found("total"),
         within=TIME),
    says("SMWOA takes 37.674 % less time than the motion before optimisation",
         "abstract and section 4.3", TIME_SAVED, SAVED, within=Absolute(0.5)),
    says_in_words(
        "the efficiency of the joints' motion is improved (read as: SMWOA takes less time than the "
        "39.526 s before)", "abstract and section 4.3", f"{TIME_SAVED.text} %", SAVED,
        within=Between(0, 100)),
    says_in_words(
        "SMWOA plans the motion better than SMA and WOA (read as: the lowest mean total time)",
        "sections 4.3 and 5, Table 6", "1 rank",
        Rank(of=runs_of(TRAJECTORY, "SMWOA")("total"), among=tuple(TRAJECTORY.algorithms)),
        within=Between(1, 1)),
)  # fmt: skip


def printed_durations(algorithm: str) -> tuple[float, ...]:
    """Return the durations of the five segments that Table 6 prints, in s."""
    return tuple(TABLE_6[algorithm, f"h{k}"].si for k in range(1, 6))


def of_print(quantity: str, algorithm: str = "SMWOA") -> float:
    """Return a quantity of the motion of an algorithm with its printed durations."""
    return float(UR5.quantity(quantity, np.array(printed_durations(algorithm))))


def spikes_of_jerk(joint: int) -> float:
    """Return in how many stretches of SMWOA's printed motion |jerk| exceeds half of its peak."""
    _, jerk = motion(UR5, np.array(printed_durations("SMWOA")), derivative=3, samples=1001)
    size = np.abs(jerk[:, joint - 1])
    high = np.concatenate([[False], size > 0.5 * size.max()])
    return float((~high[:-1] & high[1:]).sum())


AS_PRINTED = "with the printed durations of SMWOA"
AS_FOUND = "with those that SMWOA finds here"
AT_ENDS: dict[str, Measure] = {
    AS_PRINTED: computed("speed of the fastest joint at the ends, durations of SMWOA in Table 6",
                         of_print, "speed at the ends"),
    AS_FOUND: found("speed at the ends"),
}  # fmt: skip
ACCELERATIONS: dict[str, Measure] = {
    AS_PRINTED: computed("greatest acceleration of any joint in percent of its limit, durations of "
                         "SMWOA in Table 6", of_print, "acceleration share"),
    AS_FOUND: found("acceleration share"),
}  # fmt: skip
ON_MOTIONS = (
    *(
        says_in_words(
            f"the motion of {algorithm} with its printed durations keeps every {kind} limit of "
            "Table 5, Eq. (28)", "section 4.3, Tables 5 and 6", "100 %",
            computed(f"greatest {kind} of any joint along the B-spline through Table 4 with the "
                     f"durations of {algorithm} in Table 6, in percent of its limit",
                     of_print, f"{kind} share", algorithm), within=Between(0, 100))
        for algorithm in TABLE_6.row_names
        for kind in ("velocity", "acceleration")
    ),
    *(
        says_in_words(
            "the optimised motion starts and ends at rest (not stated; a whole motion should, and "
            f"Eq. (20) is its only end condition), {reading}", "sections 4.1 and 4.3", "0.0 deg/s",
            measure, within=Absolute(0))
        for reading, measure in AT_ENDS.items()
    ),
    *(
        says_in_words(
            "velocity and acceleration are gentle and steady after optimisation (read as: the "
            f"greatest acceleration is below half of its limit), {reading}", FIGURE_4, "50 %",
            measure, within=Between(0, 50))
        for reading, measure in ACCELERATIONS.items()
    ),
    *(
        says_in_words(
            f"the jerk of joint {joint} has one cusp and is otherwise smooth (read as: it exceeds "
            "half of its peak in one stretch of time only)", FIGURE_4, "1",
            computed(f"stretches in which the jerk of joint {joint} exceeds half of its peak, 1001 "
                     "instants per segment, durations of SMWOA in Table 6",
                     spikes_of_jerk, joint), within=Between(1, 1))
        for joint in (1, 2, 4, 6)
    ),
)  # fmt: skip

STILL = {
    "Eq. (20) for time": replace(UR5, ends="still"),
    "natural spline for time": replace(UR5, ends="still", time_ends="natural"),
}
OF_ALGORITHMS: dict[str, tuple[str, Any]] = {
    "restart": ("SMWOA", {"restart": 0.03}),
    "one draw for A and D": ("SMWOA", {"shared_draw": True}),
    "vector coefficients": ("SMWOA", {"coefficients": "vector"}),
    "v_b per whale": ("SMWOA", {"swing": "per whale"}),
    "weight of the leader": ("SMWOA", {"weight": "of the leader"}),
    "weight per whale": ("SMWOA", {"weights": "per whale"}),
    "natural logarithm": ("SMWOA", {"logarithm": "natural"}),
    "as WOA's program": ("SMWOA", {"leader": "per dimension", "spiral_range": "shrinking"}),
    "moves at once": ("SMWOA", {"moves": "at once"}),
    "greedy": ("SMWOA", {"greedy": True}),
    "reflection": ("SMWOA", {"bounds": "reflect"}),
    "new places": ("SMWOA", {"bounds": "re-initialise"}),
    "WOA by its equations": ("WOA", WOA_BY_EQUATIONS),
    "WOA by its equations, vectors": ("WOA", replace(WOA_BY_EQUATIONS, coefficients="vector")),
    "SMA with a falling v_c": ("SMA", {"contraction": "falling"}),
    "PSO clipped": ("PSO", {"clip": "every particle"}),
    "GSA clipped": ("GSA", {"bounds": "clip"}),
    "DE with usual constants": ("DE", {"scale": (0.5, 0.5), "crossover": 0.9}),
}
OF_PROBLEMS: dict[str, dict[tuple[str, str], Any]] = {
    "F8 of two dimensions": {("benchmark", "F8"): FUNCTIONS["alpine_1"].problem(2)},
    "usual box of F12": {("benchmark", "F12"): FUNCTIONS["branin"].problem()},
    "durations to 20 s": {("trajectory", "UR5"): {"durations": (0.1, 20.0)}},
    "durations from 1 s": {("trajectory", "UR5"): {"durations": (1.0, 10.0)}},
    "time scaling": {("trajectory", "UR5"): {"handling": "time scaling"}},
    "at rest": {("trajectory", "UR5"): {"ends": "still"}},
    "at rest, natural time": {("trajectory", "UR5"): {"ends": "still", "time_ends": "natural"}},
}
CHANGES: dict[str, dict[str, Any]] = {
    **{name: {"algorithms": everywhere(EXPERIMENTS, *own)} for name, own in OF_ALGORITHMS.items()},
    **{name: {"problems": own} for name, own in OF_PROBLEMS.items()},
    "mean of p-values": {"claims": probabilities("each problem")},
    "test of averages": {"claims": probabilities("averages")},
    "ranked by deviation": {"claims": ranking("std")},
    "best of the runs": {"claims": table_6("best")},
    "mean of the runs": {"claims": table_6("mean")},
}

RELATIONS = (
    AverageRank(
        table=TABLE_3, columns=TABLE_3.column_names, average="Average ranking", total="Total rank",
        rows=tuple(name for name in TABLE_3.row_names if name.endswith("Avg")),
    ),
    PValues(test="rank-sum", n=30, numbers=tuple(
        TableCell(table=TABLE_3, row="p/h", column=name) for name in TABLE_3.column_names[1:])),
    *row_sums(TABLE_6, total="Total Time", addends=("h1", "h2", "h3", "h4", "h5")),
    PercentLower(
        printed=TextNumber(printed=TIME_SAVED, where="abstract and section 4.3"),
        before=TextNumber(printed=BEFORE, where="section 4.3, Fig. 3"),
        after=TableCell(table=TABLE_6, row="SMWOA", column="Total Time"),
    ),
)  # fmt: skip
FIGURES = (
    *(
        SplineMotion(
            label=label, caption=caption, problem=UR5, durations=printed_durations("SMWOA"),
            experiment="trajectory", algorithms=("SMWOA",), joints=joints, derivatives=derivatives,
        )
        for label, caption, joints, derivatives in (
            ("Fig. 3", ("Angle of the base joint with the printed durations, the re-run ones, and "
                        "those of the proved optimum"), (1,), (0,)),
            ("Fig. 4", ("Angle, velocity, acceleration and jerk of the six joints with the "
                        "printed durations of SMWOA"), (1, 2, 3, 4, 5, 6), (0, 1, 2, 3)),
        )
    ),
    Arm(
        label="Arm", caption="A UR5 on its way through the nodes of Table 4, with the durations "
        "that Table 6 prints for SMWOA and with those of the certified optimum",
        dh=DH, convention="standard",
        motions=(
            ArmMotion(name="SMWOA as printed", problem=UR5, durations=printed_durations("SMWOA")),
            ArmMotion(name="certified optimum", problem=UR5),
        ),
        assumed=("links of the UR5 and zero of its joint angles",),
    ),
)  # fmt: skip

PAPER = TEXT.paper(
    read_twice=True,
    experiments=EXPERIMENTS,
    inputs=(TABLE_2, TABLE_4, TABLE_5),
    results=(TABLE_3, TABLE_6),
    claims=(
        *statistics(tuple(name for name in F if name not in ONE_BASIN), FITNESS),
        *statistics(ONE_BASIN, Percent(1)),
        *probabilities(),
        *ranking(),
        *table_6("single"),
        *ON_FUNCTIONS,
        *TIMES,
        *ON_MOTIONS,
    ),
    changes=CHANGES,
    relations=RELATIONS,
    motion_readings=tuple(
        MotionReading(name=f"at rest at both ends, {time}", of=("trajectory", "UR5"), problem=still)
        for time, still in STILL.items()
    ),
    figures=FIGURES,
)
