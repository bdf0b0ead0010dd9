"""Liang et al.: minimum-time motion of a FANUC arm with an improved whale optimisation."""

from dataclasses import replace

import numpy as np

from repro.model import (
    WOA_BY_EQUATIONS, Absolute, Arm, ArmMotion, Between, CellClaim, Claim, Computed, Convergence,
    Experiment, FromMinimum, Motion, NamedRobot, Percent, PercentLower, Printed, PrintedPoses,
    PublishedTable, Rank, Reduction, Sentence, TableCell, TextNumber, ToolPath, as_one, computed,
    computed_cells, every_cell, everywhere, lowest_everywhere, not_counted, prose, row_sums,
    runs_of, says, says_in_words,
)  # fmt: skip
from repro.functions import FUNCTIONS
from repro.optimisers import DBO, GWO, PSO, HybridWOA
from repro.robotics import Convention, MinimumTime, dh_rows, peak, quintic
from repro.robotics.kinematics import tool_coordinate
from repro.robotics.rest_to_rest import motion

TEXT = prose(__file__)
TABLE_II = PublishedTable.read("""
    Table II, section III-D (30 runs)
    No. | Index || IWOA          | WOA           | GWO           | PSO          | DBO
    F1  | Best  || 0             | 0             | 0             | 3.472×10^-57 | 2.98×10^-14
        | Worst || 7.294×10^-287 | 7.294×10^-287 | 0             | 9.676×10^-26 | 9.931×10^3
        | Mean  || 0             | 1.495×10^-289 | 9.676×10^-26  | 2.460×10^-28 | 3.187×10^3
        | Std   || 0             | 0             | 0             | 4.465×10^-27 | 2.854×10^3
    F5  | Best  || 1.755×10^-4   | 2.53          | 2.721×10^1    | 9.003×10^4   | 2.196×10^8
        | Worst || 5.596×10^-4   | 2.66          | 2.721×10^1    | 9.003×10^4   | 7.573×10^8
        | Mean  || 2.459×10^-4   | 2.536         | 2.721×10^1    | 9.003×10^4   | 4.754×10^8
        | Std   || 8.641×10^-5   | 2.172×10^-2   | 7.178×10^-15  | 3.325×10^-1  | 1.244×10^8
    F10 | Best  || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 3.856        | 1.474×10
        | Worst || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 2.050×10     | 2.213×10
        | Mean  || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 1.445×10     | 2.088×10
        | Std   || 0             | 0             | 0             | 3.242        | 8.693×10^-1
    F12 | Best  || 2.564×10^-7   | 1.003×10^-3   | 1.969×10^-2   | 8.325×10^-1  | 3.615×10^8
        | Worst || 2.834×10^-7   | 1.009×10^-3   | 1.969×10^-2   | 8.347×10^-1  | 2.389×10^9
        | Mean  || 2.714×10^-7   | 1.003×10^-3   | 1.969×10^-2   | 8.326×10^-1  | 1.146×10^9
        | Std   || 4.241×10^-9   | 1.135×10^-6   | 3.494×10^-18  | 2.626×10^-4  | 4.120×10^8
""")
TABLE_III = PublishedTable.read("""
    Table III, section IV-A
    Joint No. (i) || a_{i-1} [mm] | α_{i-1} [rad] | d_i [mm] | θ_i [text]
    1             || 175          | -π/2          | 490      | θ1
    2             || 1500         | 0             | 0        | θ2
    3             || 1350         | -π/2          | 0        | θ3
    4             || 0            | π/2           | 162      | θ4
    5             || 0            | -π/2          | 0        | θ5
    6             || 0            | 0             | 220      | θ6
""")
TABLE_IV = PublishedTable.read("""
    Table IV, section IV-B
    Waypoint || x [m] | y [m] | z [m]
    X_1      || 0.1   | 0.1   | 0.5
    X_2      || -1.5  | 0.75  | 2.344
    X_3      || 0.5   | 0.5   | 2.0
""")
TABLE_V = PublishedTable.read("""
    Table V, section IV-B
    Joint || X_1 [rad] | X_2 [rad] | X_3 [rad]
    1     || -1.0228   | 2.6619    | 0.5174
    2     || -2.8352   | -1.5037   | -2.1353
    3     || -3.0950   | 0.9949    | 1.7531
    4     || 1.2294    | -0.4553   | 1.3274
    5     || 2.4167    | -0.2435   | 1.0696
    6     || 0         | 0         | 0
""")
TABLE_VI = PublishedTable.read("""
    Table VI, section IV-C (50 runs, averaged)
    Method                 || t1 [s] | t2 [s] | Total Time t [s]
    Fifth-order polynomial || 5      | 5      | 10
    WOA                    || 3.26   | 2.48   | 5.74
    IWOA                   || 2.76   | 1.93   | 4.69
""")
VELOCITY, ACCELERATION = Printed("3", "rad/s"), Printed("3.5", "rad/s^2")  # section IV-B
SEGMENT = Printed("5", "s")  # duration of each segment before optimisation, section IV-B
TIME_SAVED = Printed("18.3", "%")  # abstract, against the motion before optimisation

IWOA = HybridWOA(
    start="tent",  # Eq. (13)
    control="quadratic",  # Eq. (14)
    coefficients="scalar",  # A and C are called vectors, but r is a number
    spiral=(2.5, 1.0),  # Eq. (15)
    probability="cosine",  # Eq. (16)
    leader="per whale",  # Eqs. (11)-(12)
    spiral_range="symmetric",  # Eq. (10)
    differential=0.5, scale=0.5, crossover=0.9,  # Eqs. (17)-(18), step 5
    genetic=0.5, mutation=0.01,  # Eq. (19), step 6
    disturbance=0.01,  # section III-B 1)
)  # fmt: skip
SWARM = PSO(clip="last particle")  # PSO.m of the toolboxes: the others may leave the box
BENCHMARK = Experiment(
    name="benchmark", where="section III-D", proposed="IWOA",
    problems={"F1": FUNCTIONS["sphere"].problem(40), "F5": FUNCTIONS["rosenbrock"].problem(40),
              "F10": FUNCTIONS["ackley"].problem(40), "F12": FUNCTIONS["penalized_1"].problem(40)},
    algorithms={"IWOA": IWOA, "WOA": WOA_BY_EQUATIONS, "GWO": GWO(), "PSO": SWARM, "DBO": DBO()},
    population=50, iterations=500, runs=30,
)  # fmt: skip
FANUC = MinimumTime(
    waypoints=tuple(TABLE_V.column(name) for name in TABLE_V.column_names),
    law=quintic,  # Eqs. (1)-(4)
    velocity=(VELOCITY.si,) * 6, acceleration=(ACCELERATION.si,) * 6, durations=(0.1, 5.0),
)  # fmt: skip
MOTION = Experiment(
    name="motion", where="section IV-C", proposed="IWOA", problems={"FANUC": FANUC},
    algorithms={"WOA": WOA_BY_EQUATIONS, "IWOA": IWOA}, population=30, iterations=300, runs=50,
)  # fmt: skip
BASELINE = (SEGMENT.si, SEGMENT.si)
DH = dh_rows(
    a=TABLE_III.column("a_{i-1}"), alpha=TABLE_III.column("α_{i-1}"), d=TABLE_III.column("d_i")
)

# The machine that the paper names; no run uses it. Its links are those between the axes of the
# joints of that file, from the floor; axis 2 reads 0 where the arm of Table III stands upright.
MACHINE = NamedRobot(
    name="FANUC R-2000iC/165F",
    axes=PublishedTable.read("""
        github ros-industrial/fanuc, fanuc_r2000ic_support: r2000ic165f_macro.xacro, limits
        axis || least [deg] | greatest [deg] | speed [deg/s]
        J1   || -185        | 185            | 130
        J2   || -60         | 76             | 115
        J3   || -132        | 180            | 125
        J4   || -360        | 360            | 180
        J5   || -125        | 125            | 180
        J6   || -360        | 360            | 260
    """),
    links=PublishedTable.read("""
        github ros-industrial/fanuc, fanuc_r2000ic_support: r2000ic165f_macro.xacro, origins
        joint || a [m] | α [rad] | d [m]
        1     || 0.312 | -π/2    | 0.670
        2     || 1.075 | 0       | 0
        3     || 0.225 | -π/2    | 0
        4     || 0     | π/2     | 1.280
        5     || 0     | -π/2    | 0
        6     || 0     | 0       | 0.215
    """),
    zeros=(None, -np.pi / 2, None, None, None, None),
)

# One rule for all papers, set when earlier runs were known and by no number: a table of 30
# heavy-tailed runs moves by decades from one batch to the
# next where the minimum is all but reached, and by less than a quarter of its way elsewhere.
FITNESS = FromMinimum(percent=25)
# Four decimals of a radian in five joints, 3.5 m from the base, move the tool by 0.9 mm at most.
TOOL = Absolute(0.001)

TABLE_II_CELLS = every_cell(
    TABLE_II, of=BENCHMARK, rows=("problem", "statistic"), columns="algorithm",
    names={"Best": "best", "Worst": "worst", "Mean": "mean", "Std": "std"}, within=FITNESS,
)  # fmt: skip
SECTION_III_D = BENCHMARK.where
FIG_2A, FIG_2B, FIG_2C, FIG_2D = (f"{SECTION_III_D}, Fig. 2{panel}" for panel in "abcd")


def ahead_early(problem: str, where: str, claim: str) -> tuple[Sentence, ...]:
    """Return the claim that IWOA is ahead on one function after a tenth of the iterations."""
    return lowest_everywhere(
        replace(BENCHMARK, problems={problem: BENCHMARK.problems[problem]}), algorithm="IWOA",
        statistic="mean", quantity="cost after 50 iterations", where=where,
        claim=f"{claim} (read as: the lowest mean of the five after a tenth of the iterations)",
    )  # fmt: skip


# Ackley's function has no other minimum below 0.99 in 40 dimensions: three coordinates at 0.84.
TRAP = 0.5
LEFT_AT_F10 = runs_of(BENCHMARK, "IWOA", "worst", problem="F10")("cost after 50 iterations")
F12 = runs_of(BENCHMARK, "IWOA", problem="F12")
ON_FUNCTIONS = (
    *as_one("IWOA's best is close to or reaches 0", (
        says_in_words(f"IWOA's best is close to 0 or reaches it (read as: below 0.01), on {name}",
                      SECTION_III_D, "0", runs_of(BENCHMARK, "IWOA", "best", problem=name)("cost"),
                      within=Between(0, 0.01))
        for name in BENCHMARK.problems)),
    *lowest_everywhere(BENCHMARK, algorithm="IWOA", statistic="mean", where=SECTION_III_D,
                       claim="IWOA has the lowest mean of the five algorithms"),
    *lowest_everywhere(BENCHMARK, algorithm="IWOA", statistic="std", where=SECTION_III_D,
                       claim="IWOA has the smallest standard deviation of the five algorithms"),
    *ahead_early("F1", FIG_2A, "IWOA converges faster early in the search"),
    *ahead_early("F5", FIG_2B, "IWOA falls fast early in the search and the others slowly"),
    says_in_words("IWOA quickly leaves local traps on F10 (read as: after a tenth of the "
                  "iterations none of its 30 runs costs 0.5, half of any other minimum)",
                  FIG_2C, "0", LEFT_AT_F10, within=Between(0, TRAP)),
    *as_one("the other algorithms are prone to stagnation on F10", (
        says_in_words(f"{name} is prone to stagnation on F10 (read as: the worst of its 30 runs "
                      "ends above 0.5, half of any other minimum)", FIG_2C, f"{TRAP}",
                      runs_of(BENCHMARK, name, "worst", problem="F10")("cost"),
                      within=Between(TRAP, 23))  # no value of the function is greater
        for name in ("WOA", "GWO", "PSO", "DBO"))),
    says_in_words("IWOA does not converge too early on F12 (read as: its mean still falls by a "
                  "tenth or more in the second half of the iterations)", FIG_2D, "100 %",
                  Reduction(before=F12("cost after half of the iterations"), after=F12("cost")),
                  within=Between(10, 100)),
)  # fmt: skip


def tool_positions(convention: Convention = "standard") -> tuple[Claim, ...]:
    """Return the claims on Table IV: each position is that which Table V gives by Table III."""

    def coordinate(waypoint: str, axis: str) -> Computed:
        how = f"{axis} of the tool at {waypoint} by Tables III and V, {convention} convention"
        return computed(how, tool_coordinate, DH, TABLE_V.column(waypoint), axis, convention)

    return computed_cells(TABLE_IV, measure=coordinate, within=TOOL)


def as_set(_method: str, time: str) -> Computed:
    """Return a time of the motion before optimisation, whose durations are set."""
    seconds = {"t1": BASELINE[0], "t2": BASELINE[1], "Total Time t": sum(BASELINE)}
    return computed(f"{time} as set in section IV-B", float, seconds[time])


def once(claim: CellClaim) -> CellClaim:
    """Return the claim on a time; a total, which the text repeats, counts with its sentences."""
    (found,) = as_one(f"{claim.printed.text} s" if claim.column == "Total Time t" else "", [claim])
    return found


def times_found(statistic: str = "mean") -> tuple[CellClaim, ...]:
    """Return the claims on the times that the searches find, by a statistic of the 50 runs."""
    return tuple(once(claim) for claim in every_cell(
        TABLE_VI, of=MOTION, rows=("algorithm",), columns="quantity", only=("WOA", "IWOA"),
        given={"problem": "FANUC", "statistic": statistic}, within=Percent(1),
        names={"t1": "duration 1", "t2": "duration 2", "Total Time t": "total"},
    ))  # fmt: skip


def times_compared(statistic: str = "mean") -> tuple[Sentence, ...]:
    """Return what the text says of these times, by a statistic of the 50 runs."""
    woa, iwoa = (runs_of(MOTION, name, statistic)("total") for name in ("WOA", "IWOA"))
    before = as_set("Fifth-order polynomial", "Total Time t")
    after, of_woa = (TABLE_VI[name, "Total Time t"] for name in ("IWOA", "WOA"))
    return (
        says("IWOA takes 18.3 % less time than the motion before optimisation", "abstract",
             TIME_SAVED, Reduction(before=before, after=iwoa), within=Absolute(0.5)),
        *as_one(f"{after.text} s", [
            says("IWOA cuts the total time from 10 s to 4.69 s", "section VI", after, iwoa,
                 within=Percent(1))]),
        *as_one(f"{of_woa.text} s", [
            says("WOA reaches a total time of 5.74 s", "section VI", of_woa, woa,
                 within=Percent(1))]),
        says_in_words("IWOA plans a clearly faster motion than WOA (read as: at least 1 % less "
                      "time; the printed times differ by 18.3 %)", "sections IV-C and VI",
                      f"{TIME_SAVED.text} {TIME_SAVED.unit}",
                      Reduction(before=woa, after=iwoa), within=Between(1, 100)),
        says_in_words("both WOA and IWOA shorten the motion of 10 s (read as: the slower of the "
                      "two by 1 % or more)", "section IV-C", "100 %",
                      Reduction(before=before, after=woa), within=Between(1, 100)),
    )  # fmt: skip


ON_MOTION = runs_of(MOTION, "IWOA")
ENHANCED = as_one("IWOA enhances speed of convergence and global optimisation", (
    says_in_words(f"IWOA enhances {what} in planning the motion (read as: a lower mean {of} than "
                  "WOA's)", "section VI", "1 rank",
                  Rank(of=ON_MOTION(quantity), among=tuple(MOTION.algorithms)),
                  within=Between(1, 1))
    for what, of, quantity in (
        ("the speed of convergence", "cost after a tenth of the iterations",
         "cost after 30 iterations"),
        ("global optimisation", "total time", "total"))))  # fmt: skip
PEAK = "closed-form peak of the quintic through Table V"
PEAKS = (
    says("largest joint velocity of the quintic with 5 s per segment", "section IV-B, Fig. 6",
         Printed("1.53", "rad/s"), computed(PEAK, peak, FANUC, BASELINE, 1), within=Absolute(0)),
    says("largest joint acceleration of the quintic with 5 s per segment", "section IV-B, Fig. 6",
         Printed("0.94", "rad/s^2"), computed(PEAK, peak, FANUC, BASELINE, 2), within=Absolute(0)),
)  # fmt: skip
KINDS = ((1, "velocity", VELOCITY), (2, "acceleration", ACCELERATION))
LIMITS = as_one("the motions keep the limits", (
    says_in_words(f"the motion of {method} with its printed times keeps the limit on {kind}",
                  "abstract and section IV-B, Table VI", f"{limit.text} {limit.unit}",
                  computed(f"closed-form peak of the {kind} of the quintics through Table V with "
                           f"the times of {method} in Table VI", peak, FANUC,
                           (TABLE_VI[method, "t1"].si, TABLE_VI[method, "t2"].si), derivative),
                  within=Between(0, limit.value))
    for method in TABLE_VI.row_names for derivative, kind, limit in KINDS))  # fmt: skip


def greatest_jump(derivative: int) -> float:
    """Return the greatest jump of a derivative at a waypoint on IWOA's printed motion, SI units."""
    durations = np.array([TABLE_VI["IWOA", name].si for name in ("t1", "t2")])
    _, values = motion(FANUC, durations, derivative=derivative, samples=2)
    at_rest = np.zeros_like(values[:1])
    before, after = np.vstack([at_rest, values[1::2]]), np.vstack([values[::2], at_rest])
    return float(np.abs(after - before).max())


SMOOTH = as_one("velocity and acceleration without abrupt changes", not_counted(
    says_in_words(f"the {kind} has no abrupt change (true by Eq. (2), for any times)",
                  "sections II-A and IV-C, Figs. 6 and 7", f"0 {limit.unit}",
                  computed(f"greatest jump of the {kind} of any joint at a waypoint, times of IWOA "
                           "in Table VI", greatest_jump, derivative), within=Between(0, 1e-9))
    for derivative, kind, limit in KINDS))  # fmt: skip
ROBOGUIDE = TEXT.gap("times in the RoboGuide simulation (18 % less)")
PHYSICAL_ARM = TEXT.gap("times on the physical arm (16.4 % less)")
TOOL_ERROR = TEXT.gap("position error of the physical arm (within 2 mm)")
ELSEWHERE = (
    says("IWOA takes 18 % less time than the motion before optimisation in RoboGuide",
         ROBOGUIDE.where, Printed("18", "%"), ROBOGUIDE, within=Absolute(0.5)),
    says("IWOA takes 16.4 % less time than the motion before optimisation on the arm",
         PHYSICAL_ARM.where, Printed("16.4", "%"), PHYSICAL_ARM, within=Absolute(0.5)),
    says("the end position of the physical arm errs by no more than 2 mm",
         TOOL_ERROR.where, Printed("2", "mm"), TOOL_ERROR, within=Between(0, 2)),
)  # fmt: skip

EXPERIMENTS = (BENCHMARK, MOTION)
IWOA_READINGS: dict[str, dict[str, object]] = {
    "Tent chain per whale": {"start": "tent across"},
    "one Tent chain": {"start": "tent chain"},
    "p_t selects the spiral": {"probability_selects": "spiral"},
    "evolution of any half": {"evolves": "any"},
    "evolution of all": {"differential": 1.0},
    "least F and CR": {"scale": 0.4, "crossover": 0.6},
    "greatest F and CR": {"scale": 0.9, "crossover": 0.95},
    "crossover of all": {"genetic": 1.0},
    "crossover with the best": {"partner": "best"},
    "small perturbation": {"mutation": 0.001},
    "large perturbation": {"mutation": 0.1},
    "perturbed in proportion": {"perturbs": "in proportion"},
    "perturbed by its own size": {"perturbs": "in proportion", "mutation": 1.0},
    "not greedy": {"greedy": False},
    "small disturbance": {"disturbance": 0.001},
    "large disturbance": {"disturbance": 0.1},
    "Tent orbit that goes on": {"chain": "going on"},
}
# What the text leaves open, or says with two tongues, of the equations that WOA and IWOA share.
SHARED_READINGS: dict[str, dict[str, object]] = {
    "WOA's program": {"leader": "per dimension", "spiral_range": "shrinking"},
    "vector coefficients": {"coefficients": "vector"},
    "one draw": {"shared_draw": True},
    "reflection": {"bounds": "reflect"},
    "new places": {"bounds": "re-initialise"},
}
CHANGES: dict[str, dict[str, object]] = {
    "modified D-H": {"claims": tool_positions("modified")},
    "PSO clipped": {"algorithms": {("benchmark", "PSO"): {"clip": "every particle"}}},
    "DBO in proportion": {"algorithms": {("benchmark", "DBO"): {"groups": "proportional"}}},
    **{name: {"algorithms": everywhere(EXPERIMENTS, "IWOA", fields)}
       for name, fields in IWOA_READINGS.items()},
    "equal evaluations": {"protocol": {e.name: {"evaluations": e.population * e.iterations}
                                       for e in EXPERIMENTS}},
    **{name: {"algorithms": everywhere(EXPERIMENTS, "IWOA", fields)
              | everywhere(EXPERIMENTS, "WOA", fields)}
       for name, fields in SHARED_READINGS.items()},
    "F5 in 30 dimensions": {
        "problems": {("benchmark", "F5"): FUNCTIONS["rosenbrock"].problem(30)}},
    "best of 50 runs": {"claims": (*times_found("best"), *times_compared("best"))},
    "durations to 10 s": {"problems": {("motion", "FANUC"): {"durations": (0.1, 10.0)}}},
    "durations to 20 s": {"problems": {("motion", "FANUC"): {"durations": (0.1, 20.0)}}},
    "durations from 1 s": {"problems": {("motion", "FANUC"): {"durations": (1.0, 5.0)}}},
    "penalty for excess": {"problems": {("motion", "FANUC"): {"handling": "penalty"}}},
    "flat cost": {"problems": {("motion", "FANUC"): {"handling": "rejection"}}},
}  # fmt: skip

FIGURES = (
    Convergence(label="Fig. 2", caption="Best cost over the iterations of the five algorithms",
                experiment="benchmark"),
    ToolPath(label="Fig. 5", caption="Path of the tool through the three waypoints", problem=FANUC,
             dh=DH, convention="standard", printed_waypoints=TABLE_IV.points()),
    Motion(label="Fig. 6", caption="Angle, velocity and acceleration of the six joints, 5 s per "
           "segment", problem=FANUC, durations=BASELINE),
    Motion(label="Fig. 7", caption="Angle, velocity and acceleration of the six joints after "
           "optimisation", problem=FANUC, experiment="motion", algorithms=("WOA", "IWOA")),
    Arm(label="Arm", caption="The arm of Table III on its way through Table V, with the times that "
        "Table VI prints for IWOA and with those of the certified optimum",
        dh=DH, convention="standard", table=TABLE_III, robot=MACHINE, limits_at="section IV-B",
        motions=(ArmMotion(name="certified optimum", problem=FANUC),
                 ArmMotion(name="IWOA as printed", problem=FANUC,
                           durations=(TABLE_VI["IWOA", "t1"].si, TABLE_VI["IWOA", "t2"].si))),
        assumed=("Denavit-Hartenberg convention",
                 "unit of lengths in Table III and of positions in Table IV")),
)  # fmt: skip
RELATIONS = (
    *row_sums(TABLE_VI, total="Total Time t", addends=("t1", "t2")),
    PercentLower(
        printed=TextNumber(printed=TIME_SAVED, where="abstract"),
        before=TableCell(table=TABLE_VI, row="Fifth-order polynomial", column="Total Time t"),
        after=TableCell(table=TABLE_VI, row="IWOA", column="Total Time t"),
    ),
    PrintedPoses(
        dh=TABLE_III, a="a_{i-1}", alpha="α_{i-1}", d="d_i", joints=TABLE_V, positions=TABLE_IV
    ),
)

PAPER = TEXT.paper(
    read_twice=True,
    experiments=EXPERIMENTS,
    inputs=(TABLE_III, TABLE_V),
    results=(TABLE_II, TABLE_IV, TABLE_VI),
    claims=(
        *TABLE_II_CELLS, *tool_positions(),
        *not_counted(computed_cells(TABLE_VI, measure=as_set, within=Absolute(0),
                                    only=("Fifth-order polynomial",))),
        *times_found(), *ON_FUNCTIONS, *PEAKS, *LIMITS, *SMOOTH, *times_compared(), *ENHANCED,
        *ELSEWHERE,
    ),
    changes=CHANGES,
    figures=FIGURES,
    relations=RELATIONS,
)  # fmt: skip
