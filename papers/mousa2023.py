"""Mousa et al.: polynomials, WOA and GA for point-to-point motion of a KUKA KR4 R600."""

import math
from dataclasses import replace
from itertools import chain

import numpy as np

from repro.model import (
    Arm, ArmMotion, Between, Combination, Convergence, Effort, Experiment, JointCurves, Measure,
    Percent, PlaceAmong, Printed, PublishedTable, Reduction, Sensitivity, Sentence, Together,
    computed, everywhere, planned, prose, says, says_in_words, woa_readings,
)  # fmt: skip
from repro.optimisers import GA, WOA, Optimiser, SteadyStateGA
from repro.robotics import PathFitting, RestToRestLaw, cubic, dh_rows, freedoms, quintic, septic

TEXT = prose(__file__)
TABLE_IV = PublishedTable.read("""
    Table IV, section IV (the second table of this number)
    links || a [m] | α [rad] | d [m] | θ [text]
    1     || 0     | 1.57    | 0.330 | q_1
    2     || 0.29  | 0       | 0     | q_1
    3     || 0.02  | 1.57    | 0     | q_1
    4     || 0     | -1.57   | 0.310 | q_1
    5     || 0     | 1.57    | 0     | q_1
    6     || 0     | 0       | 0.075 | q_1
""")
ANGLES = PublishedTable.read("""
    Eqs. (10) and (11), section IV (no unit is printed)
    joint || start angles [rad] | end angles [rad]
    1     || -1.856             | -0.388
    2     || -1.73              | -1.74
    3     || -0.009             | 0.248
    4     || 3.1                | 1.50
    5     || -1.8               | -1.30
    6     || -0.30              | 1.7
""")
EQUATIONS = {  # a_0 is q_start, the others multiply (q_end - q_start) / t^j
    "cubic": ("1", "0", "3", "-2"),  # Eq. (4)
    "quintic": ("1", "0", "0", "10", "-15", "6"),  # Eq. (9)
}
CROSSOVER, MUTATION = (Printed(text, "%").value / 100 for text in ("80", "1"))  # section III-B
REACH = Printed("600", "mm")  # the R600 of the arm's name, keywords and section IV
FREEDOMS = Printed("6")  # title and section IV

# The real arm's axes are compared with the joints of Table IV by the poses of the flange: the
# chain of the description file and the standard convention agree in every posture when the joint
# angles are -A1, -A2, 90° - A3, -A4, -A5 and 180° - A6.
REAL_ARM = PublishedTable.read("""
    KUKA KR4 R600, github kroshu/kuka_robot_descriptions, kuka_agilus_support: kr4_r600_macro.xacro
    axis || least [deg] | greatest [deg] | speed [rad/s] | acceleration [rad/s^2]
    A1   || -170        | 170            | 5.864         | 29.22
    A2   || -195        | 40             | 5.864         | 9.951
    A3   || -115        | 150            | 8.508         | 19.95
    A4   || -185        | 185            | 10.472        | 30.07
    A5   || -120        | 120            | 9.235         | 35.24
    A6   || -350        | 350            | 13.963        | 76.66
""")
DH = dh_rows(a=TABLE_IV.column("a"), alpha=TABLE_IV.column("α"), d=TABLE_IV.column("d"))
START, END = ANGLES.column("start angles"), ANGLES.column("end angles")
AT_ZERO = (0.0, 0.0, math.pi / 2, 0.0, 0.0, math.pi)  # joint angles of Table IV where A1…A6 are 0

# None of these is printed; each is an Assumption.
DURATION = 2.0  # s
INTERVALS = 100  # M
COEFFICIENT = 50.0  # rad: |a_j| T^j is at most this
SHIFT = 0.01  # rad: a slightly varied start


def axis_angles(joints: tuple[float, ...]) -> tuple[float, ...]:
    """Return A1…A6 of the real arm for joint angles θ of Table IV, or θ for A1…A6, in rad."""
    return tuple(zero - angle for zero, angle in zip(AT_ZERO, joints, strict=True))


def axes_out_of_range(*postures: tuple[float, ...]) -> float:
    """Return how many axes of the real arm lie outside their range in any of the postures."""
    ranges = REAL_ARM.column("least"), REAL_ARM.column("greatest")
    return float(sum(
        any(not low <= angle <= high for angle in angles)
        for low, high, *angles in zip(*ranges, *postures, strict=True)
    ))  # fmt: skip


def reach() -> float:
    """Return how far the wrist centre of Table IV gets from the axis of joint 1, in m."""
    (_, _, _), (a2, _, _), (a3, _, _), (_, _, d4), *_ = DH
    return a2 + math.hypot(a3, d4)


def paths(
    law: RestToRestLaw, starts: tuple[float, ...] = START, ends: tuple[float, ...] = END
) -> dict[str, PathFitting]:
    """Return one fit per joint to the path by `law` between some angles in rad."""
    box = ((-COEFFICIENT, COEFFICIENT),) * 6  # a_0 to a_5, Table III
    return {
        f"joint {joint}": PathFitting(start=start, end=end, law=law, duration=DURATION,
                                      intervals=INTERVALS, box=box)
        for joint, (start, end) in enumerate(zip(starts, ends, strict=True), 1)
    }  # fmt: skip


AS_TOLD: dict[str, Optimiser] = {
    "WOA": WOA(),
    "GA": SteadyStateGA(crossover=CROSSOVER, mutation=MUTATION),  # section III-B
}
ALGORITHMS = {**AS_TOLD, "GA by generations": GA(crossover=CROSSOVER, mutation=MUTATION)}
FIT = Experiment(
    name="quintic path", where="section IV, Tables III and IV", proposed="WOA",
    problems=paths(quintic), algorithms=ALGORITHMS, population=30, iterations=500, runs=30,
)  # fmt: skip
OTHER_PATH = replace(FIT, algorithms=AS_TOLD)
CUBIC_FIT = replace(OTHER_PATH, name="cubic path", problems=paths(cubic))
SEPTIC_FIT = replace(OTHER_PATH, name="septic path", problems=paths(septic))
SHIFTED_START = tuple(angle + SHIFT for angle in START)
SHIFTED_FIT = replace(OTHER_PATH, name="shifted start", problems=paths(quintic, SHIFTED_START))
EXPERIMENTS = (FIT, CUBIC_FIT, SEPTIC_FIT, SHIFTED_FIT)
JOINTS = tuple(FIT.problems)
QUINTIC, CUBIC, SEPTIC, SHIFTED = (tuple(fit.problems.values()) for fit in EXPERIMENTS)
PATHS = {"cubic": CUBIC, "quintic": QUINTIC}
CONVERTED = axis_angles(START), axis_angles(END)  # zero less an angle, both ways
ARM_CUBIC, ARM_QUINTIC = (tuple(paths(law, *CONVERTED).values()) for law in (cubic, quintic))

# What the text says of the cubic, the quintic and the arm; nothing here is run.
NONE = Between(0, 1e-9)  # rounding of doubles leaves about 1e-15
SMOOTHNESS: dict[str, tuple[str, Combination]] = {
    "jump of acceleration at the start": ("start acceleration", "norm"),
    "greatest jerk between the ends": ("peak jerk", "largest"),
    "integrated squared jerk between the ends": ("squared jerk", "sum"),
}


def lower(claim: str, where: str, best: Measure, *others: Measure) -> Sentence:
    """Return the claim that one measure is lower than the others."""
    place = PlaceAmong(of=best, others=others)
    return says_in_words(claim, where, "1 rank", place, within=Between(1, 1))


def printed_curve(name: str, path: PathFitting) -> np.ndarray:
    """Return the coefficients a_0, a_1, … that Eq. (4) or (9) prints, for the ends of a path."""
    multipliers = np.array([float(text) for text in EQUATIONS[name]])
    moved = multipliers * (path.end - path.start) / path.duration ** np.arange(len(multipliers))
    moved[0] = path.start
    return moved


def greatest(name: str, *quantities: str) -> float:
    """Return the greatest of some quantities over the joints, by the printed coefficients."""
    curves = [(path, printed_curve(name, path)) for path in PATHS[name]]
    return max(float(path.quantity(q, curve)) for path, curve in curves for q in quantities)


def zero_at_ends(claim: str, where: str, name: str, quantity: str, unit: str) -> Sentence:
    """Return the claim that a quantity of a polynomial is 0 at both ends."""
    how = f"greatest {quantity} of the six joints at either end by the printed coefficients"
    measure = computed(how, greatest, name, f"start {quantity}", f"end {quantity}")
    return says_in_words(claim, where, f"0 {unit}", measure, within=NONE)


def least_norm(fits: tuple[PathFitting, ...]) -> float:
    """Return the least norm of any six coefficients per joint."""
    return math.hypot(*(path.least_cost() for path in fits))


def norm_of_cubic() -> float:
    """Return the norm of the difference between the cubic and the quintic."""
    pairs = zip(QUINTIC, CUBIC, strict=True)
    errors = [float(fit.quantity("rms error", path.coefficients)) for fit, path in pairs]
    return math.hypot(*(error * math.sqrt(INTERVALS + 1) for error in errors))


def passed_on() -> float:
    """Return the greatest change of the quintic over that of its start."""
    pairs = zip(QUINTIC, SHIFTED, strict=True)
    return float(max(np.abs(moved.desired - path.desired).max() for path, moved in pairs) / SHIFT)


PASSED_ON = computed(
    f"greatest change of the quintic over the {SHIFT:g} rad by which its start changes", passed_on
)
JERK_RANGE = {
    law: computed(f"greatest less least jerk of the {law}, any joint", greatest, law, "jerk range")
    for law in PATHS
}
POLYNOMIAL_CLAIMS = (
    *(zero_at_ends(f"the {law} leads from the start to the end angles", where, law, "error", "rad")
      for law, where in (("cubic", "Eq. (4)"), ("quintic", "Eq. (9)"))),
    zero_at_ends("the cubic has zero velocity at both ends, as at rest before and after",
                 "section IV, Eqs. (2)-(4)", "cubic", "velocity", "rad/s"),
    zero_at_ends("the quintic has zero velocity at both ends, as at rest before and after",
                 "section IV, Eqs. (6)-(9)", "quintic", "velocity", "rad/s"),
    zero_at_ends("the quintic has zero acceleration at both ends, as at rest before and after",
                 "section IV, Eqs. (6)-(9)", "quintic", "acceleration", "rad/s^2"),
    *(lower(f"the quintic is smoother than the cubic (read as: lower {what})", "section IV, Fig. 3",
            *(computed(f"{what} of the {law}", planned(PATHS[law], quantity, combination))
              for law in ("quintic", "cubic")))
      for what, (quantity, combination) in SMOOTHNESS.items()),
    says_in_words("the acceleration of the cubic is a straight line (its jerk does not vary)",
                  "section IV, Fig. 3", "0 rad/s^3", JERK_RANGE["cubic"], within=NONE),
    says_in_words(
        "the acceleration of the quintic is curved (its jerk varies more than the cubic's)",
        "section IV, Fig. 3", "2 rank",
        PlaceAmong(of=JERK_RANGE["quintic"], others=(JERK_RANGE["cubic"],)), within=Between(2, 2)),
    says_in_words("a polynomial is efficient on a well-defined path (read as: the coefficients of "
                  "Eq. (9) follow the desired path without any search)", "abstract and section V",
                  "0 rad", computed("greatest norm of a joint by the printed coefficients",
                                    greatest, "quintic", "rms error"), within=NONE),
    says_in_words("a polynomial is sensitive to its initial conditions (read as: it makes a "
                  "change of the start angles at least 5 % larger)", "section V", "1",
                  PASSED_ON, within=Between(1.05, 100)),
    says("the arm has six degrees of freedom (at the start and the end angles)",
         "title and Table IV", FREEDOMS, computed(
             "rank of the Jacobian of Table IV in the standard convention, the lower of the two",
             lambda: float(min(freedoms(DH, START), freedoms(DH, END)))), within=Between(6, 6)),
    says("Table IV is the arm R600, whose name gives its reach in mm", "Table IV", REACH,
         computed("farthest place of the wrist centre from the axis of joint 1", reach),
         within=Percent(1)),  # names are round numbers
    *(says_in_words(f"the start and end angles suit the movement limits of the six joints ({read})",
                    "section IV, Eqs. (10) and (11)", "0",
                    computed("axes of the real arm out of range at the start or the end",
                             axes_out_of_range, *angles), within=Between(0, 0))
      for read, angles in (("read as angles A1 to A6 of the real arm", (START, END)),
                           ("read as joint angles θ of Table IV", CONVERTED))),
)  # fmt: skip

# What the text says of WOA and GA, with a reading declared before any run. Where WOA is compared
# with GA, it is compared with both lineages of GA, in a claim each.
LINEAGES = {"GA": "GA as told", "GA by generations": "GA by generations"}
RESOLUTION = 0.001  # rad: the last digit in which most angles of Eqs. (10) and (11) are printed
FOLLOWED = Between(0, 0.01 * math.dist(START, END))  # 1 % of the way that the joints go together


def arm(algorithm: str, statistic: str, quantity: str = "cost",
        combination: Combination = "norm", of: Experiment = FIT) -> Together:  # fmt: skip
    """Return a statistic, over the runs, of a quantity of the whole arm."""
    return Together(experiment=of.name, problems=JOINTS, algorithm=algorithm, quantity=quantity,
                    combination=combination, statistic=statistic)  # fmt: skip


def follows(algorithm: str, of: Experiment, where: str, usual: str) -> Sentence:
    """Return the claim that an algorithm follows the path of an experiment."""
    return says_in_words(
        f"{LINEAGES.get(algorithm, algorithm)} suits a {of.name} (read as: the error of the six "
        "joints together is at most 1 % of their way)", where, "0 rad",
        arm(algorithm, usual, "rms error", of=of), within=FOLLOWED)  # fmt: skip


def overall(usual: str) -> tuple[Sentence, ...]:
    """Return the claims on WOA against all other methods, and on a start that varies."""
    paths_told = "abstract and section VI"
    return (
        lower("WOA plans the better path of all methods (read as: lowest median norm of WOA, GA, "
              "cubic and quintic)", "abstract and section V",
              *(arm(algorithm, usual) for algorithm in ALGORITHMS),
              computed("norm of the cubic", norm_of_cubic),
              computed("norm of the quintic", least_norm, QUINTIC)),
        says_in_words(
            "WOA avoids local optima and finds the global one (read as: its best run follows the "
            "desired path to the printed digits of the angles)", "section V", "0 rad",
            arm("WOA", "best", "rms error"), within=Between(0, RESOLUTION)),
        *(follows("WOA", of, paths_told, usual) for of in (CUBIC_FIT, FIT, SEPTIC_FIT)),
        lower("polynomials are limited by how complex the path is, WOA is not (read as: on a "
              "septic path WOA ends below the best polynomial of degree five)", paths_told,
              arm("WOA", usual, of=SEPTIC_FIT),
              computed("least norm of any six coefficients", least_norm, SEPTIC)),
        lower("WOA is less sensitive to the initial conditions than a polynomial (read as: a "
              "change of the start angles changes its curves less than the quintic)", "section V",
              Sensitivity(experiment=FIT.name, shifted=SHIFTED_FIT.name, problems=JOINTS,
                          algorithm="WOA", shift=SHIFT), PASSED_ON),
    )  # fmt: skip


def quality(ga: str, usual: str) -> tuple[Sentence, ...]:
    """Return the claims on how well WOA and one lineage of GA fit."""
    name = LINEAGES[ga]
    return (
        lower(f"WOA is more accurate than {name} (read as: lower median final norm)", "abstract",
              arm("WOA", usual), arm(ga, usual)),
        says_in_words(
            f"the lowest norms of WOA and {name} are close (read as: within 10 %)",
            "section V, Fig. 6", "0 %",
            Reduction(before=arm(ga, "best"), after=arm("WOA", "best")), within=Between(-10, 10)),
        follows(ga, FIT, "section V", usual),
    )  # fmt: skip


def smoothness(ga: str, usual: str) -> tuple[Sentence, ...]:
    """Return the claims on how smooth the curves of WOA and one lineage of GA are."""
    name, places = LINEAGES[ga], "abstract, section IV with Fig. 5, section VI"
    return (
        lower(f"{name} is less smooth than WOA (read as: WOA's median integrated squared jerk is "
              "lower)", places,
              arm("WOA", usual, "squared jerk", "sum"), arm(ga, usual, "squared jerk", "sum")),
        lower(f"{name} is less smooth than WOA (read as: WOA's median greatest jerk is lower)",
              places, arm("WOA", usual, "peak jerk", "largest"),
              arm(ga, usual, "peak jerk", "largest")),
        *(lower(f"{name} is smoother at the {end} of the path (read as: its median jump of {kind} "
                "from rest is lower), though less smooth elsewhere", "abstract",
                arm(ga, usual, f"{word} {kind}"), arm("WOA", usual, f"{word} {kind}"))
          for word, end in (("start", "start"), ("end", "finish"))
          for kind in ("velocity", "acceleration")),
        lower(f"the path of {name} is less complex than WOA's (read as: its joints reverse less "
              "often)", "abstract and section VI",
              arm(ga, usual, "reversals", "sum"), arm("WOA", usual, "reversals", "sum")),
    )  # fmt: skip


def searching(ga: str, usual: str) -> tuple[Sentence, ...]:
    """Return the claims on how WOA and one lineage of GA search."""
    name, fig_6, both = LINEAGES[ga], "section V, Fig. 6", ("WOA", ga)
    first, half = "cost after 1 iteration", "cost after half of the iterations"
    return (
        lower(f"WOA is faster than {name} (read as: fewer evaluations until both have come to the "
              "worse of their two median final norms)", f"abstract and {fig_6}",
              *(Effort(experiment=FIT.name, problems=JOINTS, algorithm=algorithm, among=both)
                for algorithm in both)),
        lower(f"{name} gets off to a better start (read as: lower median norm after the first "
              "iteration, by which GA has evaluated its start and up to one child per agent)",
              fig_6, arm(ga, usual, first), arm("WOA", usual, first)),
        lower(f"WOA is more stable than {name} (read as: lower standard deviation of the final "
              "norm over the runs)", fig_6, arm("WOA", "std"), arm(ga, "std")),
        lower(f"WOA is more stable than {name} while it searches (read as: lower standard "
              "deviation over the runs at half of the iterations)",
              fig_6, arm("WOA", "std", half), arm(ga, "std", half)),
    )  # fmt: skip


def search_claims(usual: str = "median") -> tuple[Sentence, ...]:
    """Return all claims, `usual` being the statistic of the runs where no sentence names one."""
    groups = (group(ga, usual) for group in (quality, smoothness, searching) for ga in LINEAGES)
    return (*overall(usual), *chain.from_iterable(groups))


def every(**fields: object) -> dict[str, object]:
    """Return a change of every problem of every experiment."""
    return {"problems": {(e.name, joint): fields for e in EXPERIMENTS for joint in JOINTS}}


CHANGES: dict[str, dict[str, object]] = {
    "cubic path": {"problems": {(FIT.name, joint): path for joint, path in paths(cubic).items()}},
    "narrow bounds": every(box=((-32.0, 32.0),) * 6),
    "wide bounds": every(box=((-500.0, 500.0),) * 6),
    "50 intervals": every(intervals=50),
    "200 intervals": every(intervals=200),
    "population of 50": {"protocol": {e.name: {"population": 50} for e in EXPERIMENTS}},
    "1000 iterations": {"protocol": {e.name: {"iterations": 1000} for e in EXPERIMENTS}},
    **woa_readings(EXPERIMENTS, "WOA by its equations, numbers", "WOA by its equations, vectors",
                   "reflection", "new places"),
    "GA with blended genes": {"algorithms": everywhere(EXPERIMENTS, "GA", {"mixing": "blend"})},
    "GA with one-point crossover": {
        "algorithms": everywhere(EXPERIMENTS, "GA", {"mixing": "one point"})},
    "means of the runs": {"claims": search_claims("mean")},
}  # fmt: skip

KINEMATICS = "Angle, velocity and acceleration of the six joints"
PAPER = TEXT.paper(
    changes=CHANGES, experiments=EXPERIMENTS, inputs=(TABLE_IV, ANGLES), results=(),
    read_twice=True, claims=(*POLYNOMIAL_CLAIMS, *search_claims()),
    figures=(
        JointCurves(label="Fig. 2", caption=f"{KINEMATICS} by cubic polynomials", paths=CUBIC),
        JointCurves(label="Fig. 3", caption=f"{KINEMATICS} by quintic polynomials", paths=QUINTIC),
        JointCurves(label="Fig. 4", caption=f"{KINEMATICS} fitted by WOA", paths=QUINTIC,
                    experiment=FIT.name, algorithms=("WOA",)),
        JointCurves(label="Fig. 5", caption=f"{KINEMATICS} fitted by GA", paths=QUINTIC,
                    experiment=FIT.name, algorithms=tuple(LINEAGES)),
        Convergence(label="Fig. 6", caption="Norm of the difference over the iterations of WOA and "
                    "GA", experiment=FIT.name),
        Arm(label="Arm", caption="The arm of Table IV between the angles of Eqs. (10) and (11), "
            "read as angles A1 to A6 of the real arm, by the quintic and by the cubic polynomials; "
            "no time is minimised or printed, so both last the time that is assumed",
            dh=DH, convention="standard",
            motions=(ArmMotion(name="quintic polynomials", problem=ARM_QUINTIC),
                     ArmMotion(name="cubic polynomials", problem=ARM_CUBIC)),
            assumed=("Denavit-Hartenberg convention", "what the start and end angles are",
                     "duration of the motion")),
    ),
)  # fmt: skip
