"""Liang et al.: minimum-time motion of a FANUC arm with an improved whale optimisation."""

from dataclasses import replace

from repro.model import (
    ZERO_STD, Absolute, Arm, ArmMotion, Between, Claim, Computed, Convergence,
    Experiment, Fitness, Motion, Percent, PercentLower, Printed, PrintedPoses, PublishedTable,
    Reduction, TableCell, TextNumber, ToolPath, computed, computed_cells, every_cell, everywhere,
    lowest_everywhere, prose, row_sums, runs_of, says, says_in_words, woa_readings,
)  # fmt: skip
from repro.functions import FUNCTIONS
from repro.optimisers import DBO, GWO, PSO, WOA, HybridWOA
from repro.robotics import Convention, MinimumTime, dh_rows, peak, quintic
from repro.robotics.kinematics import tool_coordinate

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
    spiral=(2.5, 1.0),  # Eq. (15)
    probability="cosine",  # Eq. (16)
    leader="per whale",  # Eqs. (11)-(12)
    spiral_range="symmetric",  # Eq. (10)
    differential=0.5, scale=0.5, crossover=0.9,  # Eqs. (17)-(18), step 5
    genetic=0.5, mutation=0.01,  # Eq. (19), step 6
    disturbance=0.01,  # section III-B 1)
)  # fmt: skip
BENCHMARK = Experiment(
    name="benchmark", where="section III-D", proposed="IWOA",
    problems={"F1": FUNCTIONS["sphere"].problem(40), "F5": FUNCTIONS["rosenbrock"].problem(40),
              "F10": FUNCTIONS["ackley"].problem(40), "F12": FUNCTIONS["penalized_1"].problem(40)},
    algorithms={"IWOA": IWOA, "WOA": WOA(), "GWO": GWO(), "PSO": PSO(), "DBO": DBO()},
    population=50, iterations=500, runs=30,
)  # fmt: skip
FANUC = MinimumTime(
    waypoints=tuple(TABLE_V.column(name) for name in TABLE_V.column_names),
    law=quintic,  # Eqs. (1)-(4)
    velocity=(VELOCITY.si,) * 6, acceleration=(ACCELERATION.si,) * 6, durations=(0.1, 5.0),
)  # fmt: skip
MOTION = Experiment(
    name="motion", where="section IV-C", proposed="IWOA", problems={"FANUC": FANUC},
    algorithms={"WOA": WOA(), "IWOA": IWOA}, population=30, iterations=300, runs=50,
)  # fmt: skip
BASELINE = (SEGMENT.si, SEGMENT.si)
DH = dh_rows(
    a=TABLE_III.column("a_{i-1}"), alpha=TABLE_III.column("α_{i-1}"), d=TABLE_III.column("d_i")
)

# Declared before any run. A factor of ten near zero, since a table of 30 heavy-tailed runs moves
# by decades from one batch to the next; a quarter of the value elsewhere.
FITNESS = Fitness(decades=1, near_zero=0.01, percent=25)
# Four decimals of a radian in five joints, 3.5 m from the base, move the tool by 0.9 mm at most.
TOOL = Absolute(0.001)

TABLE_II_CELLS = every_cell(
    TABLE_II, of=BENCHMARK, rows=("problem", "statistic"), columns="algorithm",
    names={"Best": "best", "Worst": "worst", "Mean": "mean", "Std": "std"},
    within=FITNESS, std_within=replace(FITNESS, zero=ZERO_STD),
)  # fmt: skip
# of F12 the text says only that the curve is smooth and does not converge early
EARLY = replace(BENCHMARK, problems={f: BENCHMARK.problems[f] for f in ("F1", "F5", "F10")})
LOWEST = (
    *lowest_everywhere(BENCHMARK, algorithm="IWOA", statistic="mean", where="section III-D",
                       claim="IWOA has the lowest mean of the five algorithms"),
    *lowest_everywhere(BENCHMARK, algorithm="IWOA", statistic="std", where="section III-D",
                       claim="IWOA has the smallest standard deviation of the five algorithms"),
    *lowest_everywhere(EARLY, algorithm="IWOA", statistic="mean", where="section III-D, Fig. 2",
                       claim="IWOA is ahead early in the search (read as: lowest mean after a "
                       "tenth of the iterations)", quantity="cost after 50 iterations"),
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


def times_found(statistic: str = "mean") -> tuple[Claim, ...]:
    """Return the claims on the times that the searches find, by a statistic of the 50 runs."""
    return every_cell(
        TABLE_VI, of=MOTION, rows=("algorithm",), columns="quantity", only=("WOA", "IWOA"),
        given={"problem": "FANUC", "statistic": statistic}, within=Percent(1),
        names={"t1": "duration 1", "t2": "duration 2", "Total Time t": "total"},
    )  # fmt: skip


def times_compared(statistic: str = "mean") -> tuple[Claim, ...]:
    """Return what the text says of these times, by a statistic of the 50 runs."""
    woa, iwoa = (runs_of(MOTION, name, statistic)("total") for name in ("WOA", "IWOA"))
    before = as_set("Fifth-order polynomial", "Total Time t")
    return (
        says("IWOA takes 18.3 % less time than the motion before optimisation", "abstract",
             TIME_SAVED, Reduction(before=before, after=iwoa), within=Absolute(0.5)),
        says("IWOA cuts the total time from 10 s to 4.69 s", "section VI",
             TABLE_VI["IWOA", "Total Time t"], iwoa, within=Percent(1)),
        says("WOA reaches a total time of 5.74 s", "section VI",
             TABLE_VI["WOA", "Total Time t"], woa, within=Percent(1)),
        says_in_words("IWOA plans a clearly faster motion than WOA (read as: at least 1 % less "
                      "time; the printed times differ by 18.3 %)", "sections IV-C and VI",
                      f"{TIME_SAVED.text} {TIME_SAVED.unit}",
                      Reduction(before=woa, after=iwoa), within=Between(1, 100)),
    )  # fmt: skip


PEAK = "closed-form peak of the quintic through Table V"
PEAKS = (
    says("largest joint velocity of the quintic with 5 s per segment", "section IV-B, Fig. 6",
         Printed("1.53", "rad/s"), computed(PEAK, peak, FANUC, BASELINE, 1), within=Absolute(0)),
    says("largest joint acceleration of the quintic with 5 s per segment", "section IV-B, Fig. 6",
         Printed("0.94", "rad/s^2"), computed(PEAK, peak, FANUC, BASELINE, 2), within=Absolute(0)),
)  # fmt: skip
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
    "vector coefficients": {"coefficients": "vector"},
    "IWOA with one draw": {"shared_draw": True},
    "as WOA's program": {"leader": "per dimension", "spiral_range": "shrinking"},
    "evolution of any half": {"evolves": "any"},
    "evolution of all": {"differential": 1.0},
    "least F and CR": {"scale": 0.4, "crossover": 0.6},
    "greatest F and CR": {"scale": 0.9, "crossover": 0.95},
    "crossover of all": {"genetic": 1.0},
    "crossover with the best": {"partner": "best"},
    "small perturbation": {"mutation": 0.001},
    "large perturbation": {"mutation": 0.1},
    "not greedy": {"greedy": False},
    "small disturbance": {"disturbance": 0.001},
    "large disturbance": {"disturbance": 0.1},
}
CHANGES: dict[str, dict[str, object]] = {
    "modified D-H": {"claims": tool_positions("modified")},
    **woa_readings(EXPERIMENTS, "WOA by its equations, numbers", "WOA by its equations, vectors",
                   "WOA with one draw"),
    "PSO clipped": {"algorithms": {("benchmark", "PSO"): {"clip": "every particle"}}},
    "DBO in proportion": {"algorithms": {("benchmark", "DBO"): {"groups": "proportional"}}},
    **{name: {"algorithms": everywhere(EXPERIMENTS, "IWOA", fields)}
       for name, fields in IWOA_READINGS.items()},
    "equal evaluations": {"protocol": {e.name: {"evaluations": e.population * e.iterations}
                                       for e in EXPERIMENTS}},
    **{name: {"algorithms": everywhere(EXPERIMENTS, "IWOA", {"bounds": bounds})
              | woa_readings(EXPERIMENTS, name)[name]["algorithms"]}
       for name, bounds in (("reflection", "reflect"), ("new places", "re-initialise"))},
    "best of 50 runs": {"claims": (*times_found("best"), *times_compared("best"))},
    "durations to 10 s": {"problems": {("motion", "FANUC"): {"durations": (0.1, 10.0)}}},
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
        dh=DH, convention="standard",
        motions=(ArmMotion(name="IWOA as printed", problem=FANUC,
                           durations=(TABLE_VI["IWOA", "t1"].si, TABLE_VI["IWOA", "t2"].si)),
                 ArmMotion(name="certified optimum", problem=FANUC)),
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
        *TABLE_II_CELLS,
        *tool_positions(),
        *computed_cells(TABLE_VI, measure=as_set, within=Absolute(0),
                        only=("Fifth-order polynomial",)),
        *times_found(), *LOWEST, *PEAKS, *times_compared(), *ELSEWHERE,
    ),
    changes=CHANGES,
    figures=FIGURES,
    relations=RELATIONS,
)  # fmt: skip
