"""SMWOA: minimum-time motion of a UR5 with a slime mould whale optimisation algorithm."""

from dataclasses import replace
from functools import partial

import numpy as np

from repro.model import (
    Absolute, Arm, ArmMotion, AverageRank, Between, CellClaim, Contest, ContestPlace, Experiment,
    Firsts, Fitness, FromMinimum, Measure, MeanRank, MotionReading, NamedRobot, Percent,
    PercentLower, Printed, PublishedTable, PValues, Rank, RankSum, Reduction, Samples, Sentence,
    SplineMotion, TableCell, TextNumber, as_one, computed, computed_cells, every_cell, everywhere,
    not_counted, prose, ranked, row_sums, runs_of, says, says_in_words,
)  # fmt: skip
from repro.functions import FUNCTIONS, BenchmarkProblem
from repro.optimisers import DE, GSA, PSO, SMA, SlimeWOA
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
# The paper prints no links: these are of the UR5 as its maker describes it.
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
MACHINE = NamedRobot(
    name="UR5", links=MAKERS_TABLE, zeros=(0.0,) * 6,  # its joint angles are those of its table
    axes=PublishedTable.read("""
        github UniversalRobots/Universal_Robots_ROS2_Description, config/ur5/joint_limits.yaml
        joint         || least [deg] | greatest [deg] | speed [deg/s]
        shoulder pan  || -360        | 360            | 180
        shoulder lift || -360        | 360            | 180
        elbow         || -180        | 180            | 180
        wrist 1       || -360        | 360            | 180
        wrist 2       || -360        | 360            | 180
        wrist 3       || -360        | 360            | 180
    """))  # fmt: skip
DH = dh_rows(a=MAKERS_TABLE.column("a"), alpha=MAKERS_TABLE.column("α"), d=MAKERS_TABLE.column("d"))

WOA = SlimeWOA(
    coefficients="vector",  # r_rand of Eqs. (4) and (7)
    leader="per whale",  # Eq. (7)
    spiral_range="symmetric",  # Eq. (5)
)  # fmt: skip
SMWOA = WOA(
    control="arctanh",  # Eq. (10)
    weight="of the whale",  # Eqs. (11) and (15)
    weights="per whale", logarithm="decimal",  # r of Eq. (11) is not called a vector
    swing="per dimension",  # v_b of Eqs. (8) and (13)
)  # fmt: skip

# The row of Table 2, and the function that it means (see the errata).
FUNCTION_OF = {
    "Sphere": "sphere", "Schwefel 2.22": "schwefel_2_22", "Schwefel 1.12": "schwefel_1_2",
    "Schwefel 2.21": "schwefel_2_21", "Rosenbrock": "rosenbrock", "Rastrigin": "rastrigin",
    "Ackley": "ackley", "Alpine": "alpine_1", "Penalized 1.1": "penalized_1",
    "Penalized 1.2": "penalized_2", "Michalewicz": "foxholes", "Branin": "branin",
    "Goldstein-Price": "goldstein_price", "Hartmann-3D": "hartmann_3", "Shekel 5": "shekel_5",
}  # fmt: skip
F = tuple(f"F{k}" for k in range(1, 16))
UNIMODAL, MULTIMODAL, FIXED = F[:5], F[5:10], F[10:]


def problem(row: str) -> BenchmarkProblem:
    """Return the function of a row of Table 2 in its box and dimension; Alpine's is not printed."""
    function = FUNCTIONS[FUNCTION_OF[row]]
    if row == "Branin":
        function = replace(function, box=((-5.0, 5.0), (-5.0, 5.0)))
    return function.problem(30 if row == "Alpine" else int(TABLE_2[row, "Dimension"].value))


def limits(row: int, unit: str) -> tuple[float, ...]:
    """Return one row of Table 5, whose units stand in the row headings, in SI units."""
    name = TABLE_5.row_names[row]
    return tuple(Printed(TABLE_5[name, j].text, unit).si for j in TABLE_5.column_names)


ANGLE = limits(0, "deg")
UR5 = MinimumTimeSpline(
    nodes=TABLE_4.points(), velocity=limits(1, "deg/s"), acceleration=limits(2, "deg/s^2"),
    durations=(0.1, 10.0), ends="repeated", time_ends="repeated",  # Eq. (20)
)  # fmt: skip
SWARM = PSO(clip="last particle")  # PSO.m of the toolboxes: the others may leave the box
BENCHMARK = Experiment(
    name="benchmark", where="section 3.3", proposed="SMWOA",
    problems=dict(zip(F, map(problem, TABLE_2.row_names), strict=True)),
    algorithms={"SMWOA": SMWOA, "WOA": WOA, "PSO": SWARM, "GSA": GSA(), "DE": DE(), "SMA": SMA()},
    population=30, iterations=500, runs=30,
)  # fmt: skip
TRAJECTORY = Experiment(
    name="trajectory", where="section 4.3", proposed="SMWOA", problems={"UR5": UR5},
    algorithms={"SMA": SMA(), "WOA": WOA, "SMWOA": SMWOA},
    population=100, iterations=100, runs=30,
)  # fmt: skip
EXPERIMENTS = (BENCHMARK, TRAJECTORY)
ARM = (TRAJECTORY.name, "UR5")
SIX = tuple(BENCHMARK.algorithms)
contest = partial(Contest, experiment=BENCHMARK.name, algorithms=SIX)
rank_sum = partial(RankSum, experiment=BENCHMARK.name, problems=F, algorithm="SMWOA")
AS_SAID = f"{AFTER.text} s"  # what Table 6 and the text count once
SECTION_3_3, SAVING = BENCHMARK.where, "abstract and section 4.3"
FIG_3, FIG_4 = "section 4.3, Fig. 3", "section 4.3, Fig. 4"

# One rule for all papers, set when earlier runs were known and by no number: a table of 30
# heavy-tailed runs moves by decades from one batch to the
# next where the minimum is all but reached, and by less than a quarter of its way elsewhere.
FITNESS = FromMinimum(percent=25)
# A p-value of rank sums moves by decades from one table of 30 runs to the next.
P_VALUE = Fitness(decades=1, near_zero=0.01, percent=25)
# An average rank over 15 functions moves by 1/15 when two algorithms change places once.
MEAN_RANK = Absolute(0.1)
# Declared before any run. Printed to 1 ms; 1 % lets the searches of two programs differ a little.
TIME = Percent(1)


STATISTICS = every_cell(
    TABLE_3, of=BENCHMARK, rows=("problem", "statistic"), columns="algorithm",
    names={"Avg": "mean", "Std": "std"}, within=FITNESS,
    only=tuple(f"{name} {kind}" for name in F for kind in ("Avg", "Std")),
)  # fmt: skip


def probabilities(samples: Samples = "all runs") -> tuple[CellClaim, ...]:
    """Return the claims of the row of p-values, by what the test is taken to compare."""
    return computed_cells(
        TABLE_3, only=("p/h",), within=P_VALUE,
        measure=lambda _row, other: rank_sum(against=other, samples=samples),
    )  # fmt: skip


def ranking(statistic: str = "mean") -> tuple[CellClaim, ...]:
    """Return the claims of the last two rows of Table 3, ranked by a statistic of the runs."""
    of = contest(problems=F, statistic=statistic)
    return (
        *computed_cells(TABLE_3, only=("Average ranking",), within=MEAN_RANK,
                        measure=lambda _row, name: MeanRank(contest=of, algorithm=name)),
        *computed_cells(TABLE_3, only=("Total rank",), within=Absolute(0),
                        measure=lambda _row, name: ContestPlace(contest=of, algorithm=name)),
    )  # fmt: skip


def table_6(statistic: str) -> tuple[CellClaim, ...]:
    """Return the claims on the durations, by which of the runs they are taken to be.

    The total of SMWOA, which the text repeats, counts with its sentence.
    """
    claims = every_cell(
        TABLE_6, of=TRAJECTORY, rows=("algorithm",), columns="quantity", within=TIME,
        names={"Total Time": "total"} | {f"h{k}": f"duration {k}" for k in range(1, 6)},
        given={"problem": "UR5", "statistic": statistic},
    )  # fmt: skip
    return tuple(
        said for claim in claims
        for said in as_one(AS_SAID if claim.printed == AFTER else "", [claim])
    )  # fmt: skip


def places(kind: str, **of: int) -> tuple[Sentence, ...]:
    """Return the claim that SMWOA has these places by average on one kind of functions."""
    return ranked(contest(problems=F), algorithm="SMWOA", where=SECTION_3_3, places=of,
                  claim=f"SMWOA ranked by average on {kind} functions")  # fmt: skip


def strengths(lowest: int = 3) -> tuple[Sentence, ...]:
    """Return what the text concludes from each kind, by the lowest place that bears it out."""
    return tuple(
        says_in_words(
            f"{claim} (read by its place among the six by mean rank over {', '.join(functions)})",
            SECTION_3_3, "1 rank",
            ContestPlace(contest=contest(problems=functions), algorithm="SMWOA"),
            within=Between(1, lowest))
        for claim, functions in (
            ("SMWOA has a strong ability to exploit", UNIMODAL),
            ("SMWOA has a strong ability to explore", MULTIMODAL),
            ("SMWOA is able to leave local optima", FIXED))
    )  # fmt: skip


FIRST_PLACES = "9"  # functions that the text says SMWOA is first on
FIRSTS = Firsts(contest=contest(problems=F), algorithm="SMWOA")
ON_FUNCTIONS = (
    says_in_words(
        "SMWOA is clearly more accurate than the other algorithms on the 15 functions (read as: it "
        "is first, or shares that place, on more than half of them)",
        "abstract and section 3.3", FIRST_PLACES, FIRSTS, within=Between(8, 15)),
    *as_one("SMWOA ranked by average on unimodal functions", (
        *places("unimodal", F1=1, F2=1, F3=1, F5=1),
        says_in_words(
            "SMWOA is not first on F4 by average (Table 3: second)", SECTION_3_3, "2 rank",
            Rank(of=runs_of(BENCHMARK, "SMWOA", problem="F4")("cost"), among=SIX),
            within=Between(2, 6)))),
    *places("multimodal", F7=1, F8=1, F10=1, F6=2, F9=2),
    *places("fixed-dimensional", F13=1, F15=1, F11=2, F12=2, F14=2),
    *strengths(),
    says_in_words(
        "SMWOA performs best of the six algorithms over all (read as: the lowest mean rank over "
        "F1 to F15)", SECTION_3_3, "1 rank",
        ContestPlace(contest=contest(problems=F), algorithm="SMWOA"), within=Between(1, 1)),
    says_in_words(
        "some results of SMWOA are not ideal (read as: it is not first on every function)",
        SECTION_3_3, FIRST_PLACES, FIRSTS, within=Between(0, 14)),
    *as_one("the rank-sum test marks SMWOA as better", (
        says_in_words(
            f"the rank-sum test marks SMWOA as better than {other} (+, read as 1: lower costs at "
            "the 5 % level, all runs on all functions together)",
            "Table 3, p/h", "+1", rank_sum(against=other, sign=True), within=Between(1, 1))
        for other in SIX[1:])),
)  # fmt: skip

one_run = runs_of(TRAJECTORY, "SMWOA", "single")
total = one_run("total")
SAVED = Reduction(before=computed("the time before optimisation as printed", lambda: BEFORE.si),
                  after=total)  # fmt: skip
ON_TIMES = (
    says("before optimisation the motion takes 39.526 s", FIG_3, BEFORE,
         TEXT.gap("before"), within=TIME),
    *as_one(AS_SAID, [
        says("after optimisation by SMWOA the motion takes 24.635 s", FIG_3, AFTER, total,
             within=TIME)]),
    says("SMWOA takes 37.674 % less time than the motion before optimisation", SAVING, TIME_SAVED,
         SAVED, within=Absolute(0.5)),
    says_in_words(
        "the efficiency of the joints' motion is improved (read as: SMWOA takes less time than the "
        "39.526 s before)", SAVING, f"{TIME_SAVED.text} %", SAVED, within=Between(0, 100)),
    says_in_words(
        "SMWOA plans the motion better than SMA and WOA (read as: the lowest mean total time)",
        "sections 4.3 and 5, Table 6", "1 rank",
        Rank(of=runs_of(TRAJECTORY, "SMWOA")("total"), among=tuple(TRAJECTORY.algorithms)),
        within=Between(1, 1)),
)  # fmt: skip


def printed_durations(algorithm: str) -> tuple[float, ...]:
    """Return the durations of the five segments that Table 6 prints, in s."""
    return tuple(TABLE_6[algorithm, f"h{k}"].si for k in range(1, 6))


def as_printed(quantity: str, algorithm: str = "SMWOA") -> float:
    """Return a quantity of the printed motion of an algorithm: a share in percent, or rad/s."""
    return float(UR5.quantity(quantity, np.array(printed_durations(algorithm))))


def spikes_of_jerk(joint: int, percent: float) -> float:
    """Return in how many stretches of SMWOA's printed motion |jerk| exceeds a share of its peak."""
    _, jerk = motion(UR5, np.array(printed_durations("SMWOA")), derivative=3, samples=1001)
    size = np.abs(jerk[:, joint - 1])
    high = np.concatenate([[False], size > percent / 100 * size.max()])
    return float((~high[:-1] & high[1:]).sum())


def cusps(percent: float = 50.0) -> tuple[Sentence, ...]:
    """Return the claims on jerk, a cusp being a stretch above a share of its peak."""
    return as_one("the jerk of joints 1, 2, 4 and 6 has one cusp", (
        says_in_words(
            f"the jerk of joint {joint} has one cusp and is otherwise smooth (read as: it comes "
            "near its peak in one stretch of time only)", FIG_4, "1",
            computed(f"stretches in which the jerk of joint {joint} exceeds {percent:g} % of its "
                     "peak, 1001 instants per segment, durations of SMWOA in Table 6",
                     spikes_of_jerk, joint, percent), within=Between(1, 1))
        for joint in (1, 2, 4, 6)))  # fmt: skip


def along(quantity: str, told: str) -> Measure:
    """Return a quantity of SMWOA's printed motion, which `told` describes."""
    return computed(f"{told}, durations of SMWOA in Table 6", as_printed, quantity)


def ends(speed: Measure) -> tuple[Sentence, ...]:
    """Return what the paper does not state, but Eq. (20) decides: the speed at both ends."""
    return not_counted([says_in_words(
        "the optimised motion starts and ends at rest (no statement of the paper, whose only end "
        "condition is Eq. (20))", "sections 4.1 and 4.3", "0.0 deg/s", speed,
        within=Absolute(0))])  # fmt: skip


def gentle(share: Measure) -> tuple[Sentence, ...]:
    """Return the claim on the course of velocity and acceleration."""
    return (says_in_words(
        "velocity and acceleration are gentle and steady after optimisation (read as: the greatest "
        "acceleration is below half of its limit)", FIG_4, "50 %", share,
        within=Between(0, 50)),)  # fmt: skip


ON_MOTIONS = (
    *as_one("the motions of Table 6 keep the limits of Table 5", (
        says_in_words(
            f"the motion of {algorithm} with its printed durations keeps every {kind} limit of "
            "Table 5, Eq. (28)", "section 4.3, Tables 5 and 6", "100 %",
            computed(f"greatest {kind} of any joint along the B-spline through Table 4 with the "
                     f"durations of {algorithm} in Table 6, in percent of its limit",
                     as_printed, f"{kind} share", algorithm), within=Between(0, 100))
        for algorithm in TABLE_6.row_names for kind in ("velocity", "acceleration"))),
    *ends(along("speed at the ends", "speed of the fastest joint at the ends")),
    *gentle(along("acceleration share",
                  "greatest acceleration of any joint in percent of its limit")),
    *cusps(),
)  # fmt: skip

OF_ALGORITHMS: tuple[tuple[str, str, object], ...] = (
    ("restart", "SMWOA", {"restart": 0.03}),
    ("v_b per whale", "SMWOA", {"swing": "per whale"}),
    ("weight of the leader", "SMWOA", {"weight": "of the leader"}),
    ("weight per coordinate", "SMWOA", {"weights": "per dimension"}),
    ("natural logarithm", "SMWOA", {"logarithm": "natural"}),
    ("moves at once", "SMWOA", {"moves": "at once"}),
    ("greedy", "SMWOA", {"greedy": True}),
    ("SMA with a falling v_c", "SMA", {"contraction": "falling"}),
    ("PSO clipped", "PSO", {"clip": "every particle"}),
    ("GSA clipped", "GSA", {"bounds": "clip"}),
    ("DE with usual constants", "DE", {"scale": (0.5, 0.5), "crossover": 0.9}),
)
# Of the equations that SMWOA and WOA share.
OF_BOTH: dict[str, dict[str, object]] = {
    "numbers for A and D": {"coefficients": "scalar"},
    "one draw for A and D": {"shared_draw": True},
    "WOA's program": {"coefficients": "scalar", "leader": "per dimension",
                      "spiral_range": "shrinking"},
    "reflection": {"bounds": "reflect"},
    "new places": {"bounds": "re-initialise"},
}  # fmt: skip
OF_PROBLEMS: tuple[tuple[str, tuple[str, str], object], ...] = (
    ("F8 of two dimensions", ("benchmark", "F8"), FUNCTIONS["alpine_1"].problem(2)),
    ("usual box of F12", ("benchmark", "F12"), FUNCTIONS["branin"].problem()),
    ("durations to 20 s", ARM, {"durations": (0.1, 20.0)}),
    ("durations to 40 s", ARM, {"durations": (0.1, 40.0)}),
    ("durations from 1 s", ARM, {"durations": (1.0, 10.0)}),
    ("time scaling", ARM, {"handling": "time scaling"}),
    ("at rest", ARM, {"ends": "still"}),
    ("at rest, natural time", ARM, {"ends": "still", "time_ends": "natural"}),
)
CHANGES: dict[str, dict[str, object]] = {
    **{name: {"algorithms": everywhere(EXPERIMENTS, algorithm, change)}
       for name, algorithm, change in OF_ALGORITHMS},
    **{name: {"algorithms": everywhere(EXPERIMENTS, "SMWOA", fields)
              | everywhere(EXPERIMENTS, "WOA", fields)} for name, fields in OF_BOTH.items()},
    **{name: {"problems": {place: change}} for name, place, change in OF_PROBLEMS},
    "strong as first": {"claims": strengths(1)},
    "cusp at 60 %": {"claims": cusps(60.0)},
    "cusp at 90 %": {"claims": cusps(90.0)},
    "durations as found": {"claims": (*ends(one_run("speed at the ends")),
                                      *gentle(one_run("acceleration share")))},
    "mean of p-values": {"claims": probabilities("each problem")},
    "test of averages": {"claims": probabilities("averages")},
    "ranked by deviation": {"claims": ranking("std")},
    "best of the runs": {"claims": table_6("best")},
    "mean of the runs": {"claims": table_6("mean")},
}  # fmt: skip

RELATIONS = (
    AverageRank(
        table=TABLE_3, columns=TABLE_3.column_names, average="Average ranking", total="Total rank",
        rows=tuple(name for name in TABLE_3.row_names if name.endswith("Avg"))),
    PValues(
        numbers=tuple(TableCell(table=TABLE_3, row="p/h", column=name) for name in SIX[1:]),
        test="rank-sum", n=30),
    *row_sums(TABLE_6, total="Total Time", addends=("h1", "h2", "h3", "h4", "h5")),
    PercentLower(
        printed=TextNumber(printed=TIME_SAVED, where=SAVING),
        before=TextNumber(printed=BEFORE, where=FIG_3),
        after=TableCell(table=TABLE_6, row="SMWOA", column="Total Time")),
)  # fmt: skip

spline = partial(SplineMotion, problem=UR5, durations=printed_durations("SMWOA"),
                 experiment=TRAJECTORY.name, algorithms=("SMWOA",))  # fmt: skip
PAPER = TEXT.paper(
    changes=CHANGES, experiments=EXPERIMENTS, relations=RELATIONS, read_twice=True,
    inputs=(TABLE_2, TABLE_4, TABLE_5), results=(TABLE_3, TABLE_6),
    claims=(
        *STATISTICS, *probabilities(), *ranking(), *table_6("single"), *ON_FUNCTIONS, *ON_TIMES,
        *ON_MOTIONS,
    ),
    motion_readings=(
        MotionReading(name="at rest at both ends, Eq. (20) for time", of=ARM,
                      problem=replace(UR5, ends="still")),
        MotionReading(name="at rest at both ends, natural spline for time", of=ARM,
                      problem=replace(UR5, ends="still", time_ends="natural")),
    ),
    figures=(
        spline(label="Fig. 3", caption="Angle of the base joint with the printed durations, the "
               "re-run ones, and those of the proved optimum", joints=(1,), derivatives=(0,)),
        spline(label="Fig. 4", caption="Angle, velocity, acceleration and jerk of the six joints "
               "with the printed durations of SMWOA",
               joints=(1, 2, 3, 4, 5, 6), derivatives=(0, 1, 2, 3)),
        Arm(
            label="Arm", caption="A UR5 on its way through the nodes of Table 4, with the "
            "durations that Table 6 prints for SMWOA and with those of the certified optimum",
            dh=DH, convention="standard", robot=MACHINE, limits_at="Table 5, section 4.3",
            motions=(ArmMotion(name="certified optimum", problem=UR5),
                     ArmMotion(name="SMWOA as printed", problem=UR5,
                               durations=printed_durations("SMWOA"))),
            assumed=("links of the UR5 and zero of its joint angles",)),
    ),
)  # fmt: skip
