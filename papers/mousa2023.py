"""Mousa et al.: polynomials, WOA and GA for point-to-point motion of a KUKA KR4 R600."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

import numpy as np

from repro.model import (
    Arm, ArmMotion, Between, Combination, Convergence, Effort, Experiment, JointCurves, Measure,
    NamedRobot, Percent, PlaceAmong, Printed, PublishedTable, Reduction, Sensitivity, Sentence,
    Together, as_one, computed, everywhere, not_counted, planned, prose, says, says_in_words,
    woa_readings,
)  # fmt: skip
from repro.optimisers import GA, WOA, SteadyStateGA
from repro.robotics import PathFitting, RestToRestLaw, cubic, dh_rows, freedoms, quintic, septic
from repro.robotics.polynomial_curves import derivative, values

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
    github kroshu/kuka_robot_descriptions, kr4_r600_macro.xacro and kr4_r600_joint_limits.yaml
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
KUKA = NamedRobot(
    name="KUKA KR4 R600", axes=REAL_ARM, zeros=AT_ZERO, signs=(-1,) * 6,
    links=PublishedTable.read("""
        github kroshu/kuka_robot_descriptions, kr4_r600_macro.xacro, origins
        axis || a [m] | α [rad] | d [m]
        A1   || 0     | π/2     | 0.330
        A2   || 0.29  | 0       | 0
        A3   || 0.02  | π/2     | 0
        A4   || 0     | -π/2    | 0.310
        A5   || 0     | π/2     | 0
        A6   || 0     | 0       | 0.075
    """))  # fmt: skip

# None of these is printed; each is an Assumption, those of the search with a range that is tried.
DURATION = 2.0  # s
INTERVALS = 100  # M
COEFFICIENT = 50.0  # rad: |a_j| T^j is at most this
SHIFT = 0.01  # rad: a slightly varied start


def axis_angles(joints: tuple[float, ...]) -> tuple[float, ...]:
    """Return A1…A6 of the real arm for joint angles θ of Table IV, or θ for A1…A6, in rad."""
    return tuple(zero - angle for zero, angle in zip(AT_ZERO, joints, strict=True))


def axes_out_of_range(*postures: tuple[float, ...]) -> float:
    """Return how many axes of the real arm lie outside their range in any of the postures."""
    return float(KUKA.outside(*postures))


def reach() -> float:
    """Return how far the wrist centre of Table IV gets from the axis of joint 1, in m."""
    (_, _, _), (a2, _, _), (a3, _, _), (_, _, d4), *_ = DH
    return a2 + math.hypot(a3, d4)


def paths(
    law: RestToRestLaw, starts: tuple[float, ...] = START, ends: tuple[float, ...] = END
) -> dict[str, PathFitting]:
    """Return one fit per joint to the path by `law` between some angles in rad."""
    return {
        f"joint {joint}": PathFitting(start=start, end=end, law=law, duration=DURATION,
                                      intervals=INTERVALS, box=same_box(COEFFICIENT))
        for joint, (start, end) in enumerate(zip(starts, ends, strict=True), 1)
    }  # fmt: skip


Box = tuple[tuple[float, float], ...]  # of a_0 to a_5, Table III


def same_box(greatest: float) -> Box:
    """Return one range for a_0 to a_5, in rad at the end of the path."""
    return ((-greatest, greatest),) * 6


def box_about(path: PathFitting, share: float, *, centre: float) -> Box:
    """Return ranges of a share of each best coefficient to both sides of `centre` times it.

    The joint's way stands for a coefficient of 0, of which every share is 0.
    """
    best = path.nearest() * path.duration ** np.arange(6)
    room = share * np.abs(np.where(best == 0, path.end - path.start, best))
    middle = centre * best
    return tuple(zip((middle - room).tolist(), (middle + room).tolist(), strict=True))


FIT = Experiment(
    name="quintic path", where="section IV, Tables III and IV", proposed="WOA",
    problems=paths(quintic), population=30, iterations=500, runs=30,
    algorithms={"WOA": WOA(), "GA": SteadyStateGA(crossover=CROSSOVER, mutation=MUTATION)},
)  # fmt: skip
CUBIC_FIT = replace(FIT, name="cubic path", problems=paths(cubic))
SEPTIC_FIT = replace(FIT, name="septic path", problems=paths(septic))
SHIFTED_START = tuple(angle + SHIFT for angle in START)
SHIFTED_FIT = replace(FIT, name="shifted start", problems=paths(quintic, SHIFTED_START))
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
MOMENT = 1e-9  # s, in which no jerk of the paths moves an acceleration by 1e-6 rad/s²


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


def greatest_jump(name: str) -> float:
    """Return the greatest change within a moment of any joint's angle and first two derivatives."""
    times = np.linspace(0.0, DURATION, 10 * INTERVALS, endpoint=False)
    curves = [derivative(printed_curve(name, p), order) for p in PATHS[name] for order in range(3)]
    apart = [values(curve, times + MOMENT) - values(curve, times) for curve in curves]
    return float(np.abs(apart).max())


def zero_at_ends(name: str, quantity: str, unit: str) -> Sentence:
    """Return the claim that a quantity of a polynomial is 0 at both ends."""
    told = {
        "error": f"the {name} leads from the start to the end angles",
        "velocity": f"the {name} has zero velocity at both ends, as at rest before and after",
        "acceleration": f"the {name} has zero acceleration at both ends, as at rest",
    }
    how = f"greatest {quantity} of the six joints at either end by the printed coefficients"
    measure = computed(how, greatest, name, f"start {quantity}", f"end {quantity}")
    where = {"cubic": "section IV, Eqs. (2)-(4)", "quintic": "section IV, Eqs. (6)-(9)"}[name]
    return says_in_words(told[quantity], where, f"0 {unit}", measure, within=NONE)


def smoother_quintic(what: str) -> Sentence:
    """Return the claim that the quintic is the smoother polynomial, by one of SMOOTHNESS."""
    quantity, combination = SMOOTHNESS[what]
    measures = (computed(f"{what} of the {law}", planned(PATHS[law], quantity, combination))
                for law in ("quintic", "cubic"))  # fmt: skip
    return lower("the quintic is smoother than the cubic", "section IV, Fig. 3", *measures)


def least_norm(fits: tuple[PathFitting, ...]) -> float:
    """Return the least norm of any six coefficients per joint."""
    return math.hypot(*(path.least_cost() for path in fits))


def norm_of_cubic(intervals: int) -> float:
    """Return the norm of the difference between the cubic and the quintic."""
    pairs = zip((replace(path, intervals=intervals) for path in QUINTIC), CUBIC, strict=True)
    errors = [float(fit.quantity("rms error", path.coefficients)) for fit, path in pairs]
    return math.hypot(*(error * math.sqrt(intervals + 1) for error in errors))


def passed_on() -> float:
    """Return the greatest change of the quintic over that of its start."""
    pairs = zip(QUINTIC, SHIFTED, strict=True)
    return float(max(np.abs(moved.desired - path.desired).max() for path, moved in pairs) / SHIFT)


PASSED_ON = computed(
    f"greatest change of the quintic over the {SHIFT:g} rad by which its start changes; both are "
    "in proportion, so that it is the same for every change", passed_on
)  # fmt: skip
ANY_LARGER, ANY_AT_ALL = Between(1 + 1e-9, 1e9), Between(1e-9, 1e9)  # but for rounding


def sensitive(within: Between) -> Sentence:
    """Return the claim that a polynomial can be sensitive, by what a change of start becomes."""
    return says_in_words("a polynomial can be sensitive to its initial conditions", "section V",
                         "1", PASSED_ON, within=within)  # fmt: skip


def within_limits(start: tuple[float, ...], end: tuple[float, ...]) -> Sentence:
    """Return the claim on the movement limits, of angles taken for A1 to A6."""
    return says_in_words(
        "the start and end angles suit the movement limits of the six joints",
        "section IV, Eqs. (10) and (11)", "0",
        computed("axes of the real arm out of range at the start or the end",
                 axes_out_of_range, start, end), within=Between(0, 0))  # fmt: skip


JERK_RANGE = {
    law: computed(f"greatest less least jerk of the {law}, any joint", greatest, law, "jerk range")
    for law in PATHS
}
# A polynomial of degree three or five cannot do otherwise, and Eq. (9) is what it is held against.
BY_DEFINITION = (
    says_in_words("the acceleration of the cubic is a straight line (its jerk does not vary)",
                  "section IV, Fig. 3", "0 rad/s^3", JERK_RANGE["cubic"], within=NONE),
    says_in_words(
        "the acceleration of the quintic is curved (its jerk varies more than the cubic's)",
        "section IV, Fig. 3", "2 rank",
        PlaceAmong(of=JERK_RANGE["quintic"], others=(JERK_RANGE["cubic"],)), within=Between(2, 2)),
    says_in_words("angle, velocity and acceleration of the cubic are continuous between its ends",
                  "section IV, Fig. 2", "0",
                  computed(f"greatest change of any of them, in rad and s, within {MOMENT:g} s",
                           greatest_jump, "cubic"), within=Between(0, 1e-6)),
    says_in_words("a polynomial is efficient on a well-defined path: the coefficients of Eq. (9) "
                  "follow it without any search", "abstract and section V",
                  "0 rad", computed("greatest norm of a joint by the printed coefficients",
                                    greatest, "quintic", "rms error"), within=NONE),
)  # fmt: skip
THE_ARM = (  # from which the study starts
    says("the arm has six degrees of freedom (at the start and the end angles)",
         "title and Table IV", FREEDOMS, computed(
             "rank of the Jacobian of Table IV in the standard convention, the lower of the two",
             lambda: float(min(freedoms(DH, START), freedoms(DH, END)))), within=Between(6, 6)),
    says("Table IV is the arm R600, whose name gives its reach in mm", "Table IV", REACH,
         computed("farthest place of the wrist centre from the axis of joint 1", reach),
         within=Percent(1)),  # names are round numbers
)  # fmt: skip
POLYNOMIAL_CLAIMS = (
    *as_one("Eq. (4) meets the conditions of Eq. (2)",
            (zero_at_ends("cubic", "error", "rad"), zero_at_ends("cubic", "velocity", "rad/s"))),
    *as_one("Eq. (9) meets the conditions of Eq. (6)",
            (zero_at_ends("quintic", "error", "rad"), zero_at_ends("quintic", "velocity", "rad/s"),
             zero_at_ends("quintic", "acceleration", "rad/s^2"))),
    smoother_quintic("jump of acceleration at the start"),
    sensitive(ANY_LARGER), within_limits(START, END),
    *not_counted(BY_DEFINITION), *not_counted(THE_ARM),
)  # fmt: skip

# What the text says of WOA and GA, with readings declared before any run, but
# for the global optimum: the median in the place of the best run, when runs were known.
RESOLUTION = 0.001  # rad: the last digit in which most angles of Eqs. (10) and (11) are printed
FOLLOWED = Between(0, 0.01 * math.dist(START, END))  # 1 % of the way that the joints go together
BOTH = ("WOA", "GA")


def arm(algorithm: str, statistic: str, quantity: str = "cost",
        combination: Combination = "norm", of: Experiment = FIT) -> Together:  # fmt: skip
    """Return a statistic, over the runs, of a quantity of the whole arm."""
    return Together(experiment=of.name, problems=JOINTS, algorithm=algorithm, quantity=quantity,
                    combination=combination, statistic=statistic)  # fmt: skip


def lower_arm(claim: str, where: str, *measures: tuple[str, str, str, Combination]) -> Sentence:
    """Return the claim that the arm's first measure is lower than the others."""
    return lower(claim, where, *(arm(*measure) for measure in measures))


def follows(algorithm: str, of: Experiment, where: str, usual: str) -> Sentence:
    """Return the claim that an algorithm follows the path of an experiment."""
    return says_in_words(
        f"{algorithm} suits a {of.name} (read as: the error of the six joints together is at most "
        "1 % of their way)", where, "0 rad",
        arm(algorithm, usual, "rms error", of=of), within=FOLLOWED)  # fmt: skip


def better_than_all(usual: str, *polynomials: str, intervals: int = INTERVALS) -> Sentence:
    """Return the claim that WOA plans the better path, by the polynomials it is compared with."""
    norms = {"cubic": computed("norm of the cubic", norm_of_cubic, intervals),
             "quintic": computed("norm of the quintic, which is the desired path",
                                 least_norm, QUINTIC)}  # fmt: skip
    return lower("WOA plans the better path of all methods (read as: lowest norm)",
                 "abstract and section V", *(arm(name, usual) for name in BOTH),
                 *(norms[name] for name in polynomials))  # fmt: skip


def finds_the_optimum(usual: str) -> Sentence:
    """Return the claim that WOA comes to the global optimum, by a statistic of the runs."""
    return says_in_words(
        "WOA avoids local optima and finds the global one (read as: it follows the desired path "
        "to the printed digits of the angles)", "section V", "0 rad",
        arm("WOA", usual, "rms error"), within=Between(0, RESOLUTION))  # fmt: skip


def overall(usual: str) -> tuple[Sentence, ...]:
    """Return the claims on WOA against all other methods, and on a start that varies."""
    paths_told = "abstract and section VI"
    return (
        better_than_all(usual, "cubic", "quintic"),
        finds_the_optimum(usual),
        *as_one("WOA suits all paths", (follows("WOA", of, paths_told, usual)
                                        for of in (CUBIC_FIT, FIT, SEPTIC_FIT))),
        lower("polynomials are limited by how complex the path is, WOA is not (read as: on a "
              "septic path WOA ends below the best polynomial of degree five, which its own curve "
              "is one of)", paths_told, arm("WOA", usual, of=SEPTIC_FIT),
              computed("least norm of any six coefficients", least_norm, SEPTIC)),
        lower("WOA is less sensitive to the initial conditions than a polynomial (read as: a "
              "change of the start angles changes its curves less than the quintic)", "section V",
              Sensitivity(experiment=FIT.name, shifted=SHIFTED_FIT.name, problems=JOINTS,
                          algorithm="WOA", shift=SHIFT), PASSED_ON),
    )  # fmt: skip


def quality(usual: str) -> tuple[Sentence, ...]:
    """Return the claims on how well WOA and GA fit."""
    return (
        lower("WOA is more accurate than GA (read as: lower final norm)", "abstract",
              *(arm(name, usual) for name in BOTH)),
        says_in_words(
            "the lowest norms of WOA and GA are close (read as: within 10 %)",
            "section V, Fig. 6", "0 %",
            Reduction(before=arm("GA", "best"), after=arm("WOA", "best")),
            within=Between(-10, 10)),
        follows("GA", FIT, "section V", usual),
    )  # fmt: skip


def less_smooth(usual: str, quantity: str, combination: Combination) -> Sentence:
    """Return the claim that GA's curves are less smooth than WOA's, by a measure of smooth."""
    return lower("GA is less smooth than WOA", "abstract, section IV with Fig. 5, section VI",
                 *(arm(name, usual, quantity, combination) for name in BOTH))  # fmt: skip


def smoother_ends(usual: str, kind: str) -> tuple[Sentence, ...]:
    """Return the claims that GA starts and ends more smoothly, by its jump of a kind from rest."""
    return as_one("GA is smoother at start and finish", (
        lower(f"GA is smoother at the {end} of the path, though less smooth elsewhere", "abstract",
              *(arm(name, usual, f"{word} {kind}") for name in reversed(BOTH)))
        for word, end in (("start", "start"), ("end", "finish"))))  # fmt: skip


def more_stable(quantity: str) -> Sentence:
    """Return the claim that WOA searches more stably, by what must vary less from run to run."""
    return lower("WOA is more stable than GA while it searches (read as: lower standard deviation "
                 "of the norm over the runs)", "section V, Fig. 6",
                 *(arm(name, "std", quantity) for name in BOTH))  # fmt: skip


def searching(usual: str) -> tuple[Sentence, ...]:
    """Return the claims on how smooth the curves of WOA and GA are, and on how they search."""
    fig_6, first = "section V, Fig. 6", "cost after 1 iteration"
    return (
        less_smooth(usual, "squared jerk", "sum"),
        *smoother_ends(usual, "velocity"),
        lower("the path of GA is less complex than WOA's (read as: its joints reverse less often)",
              "abstract and section VI",
              *(arm(name, usual, "reversals", "sum") for name in reversed(BOTH))),
        lower("WOA is faster than GA (read as: fewer evaluations until both have come to the "
              "worse of their two median final norms)", f"abstract and {fig_6}",
              *(Effort(experiment=FIT.name, problems=JOINTS, algorithm=algorithm, among=BOTH)
                for algorithm in BOTH)),
        lower("GA gets off to a better start (read as: lower norm after the first iteration, by "
              "which GA has evaluated its start and up to one child per agent)",
              fig_6, *(arm(name, usual, first) for name in reversed(BOTH))),
        more_stable("cost after half of the iterations"),
    )  # fmt: skip


def search_claims(usual: str = "median") -> tuple[Sentence, ...]:
    """Return all claims, `usual` being the statistic of the runs where no sentence names one."""
    return (*overall(usual), *quality(usual), *searching(usual))


Change = Mapping[str, object]
# Beside other settings of the quintic path the start must shift under the same ones; the cubic and
# the septic path add other coefficients and no other search, so such a reading leaves them.
TWO = (FIT, SHIFTED_FIT)


def fitted(
    change: Callable[[PathFitting], object], of: Iterable[Experiment] = EXPERIMENTS
) -> Change:
    """Return a change of every problem of some experiments, which may follow the path."""
    return {"problems": {(e.name, joint): change(path)
                         for e in of for joint, path in e.problems.items()}}  # fmt: skip


def points(intervals: int) -> Change:
    """Return another number of instants on the quintic path, and where its start shifts."""
    claim = better_than_all("median", "cubic", "quintic", intervals=intervals)
    return {**fitted(lambda _: {"intervals": intervals}, TWO), "claims": (claim,)}


def protocol(**fields: int) -> Change:
    """Return a change of the sizes of a search on the quintic path, and where its start shifts."""
    return {"protocol": {e.name: fields for e in TWO}}


def other_path(law: RestToRestLaw) -> Change:
    """Return the desired path by another law, with its start as it is and shifted."""
    own = {FIT.name: paths(law), SHIFTED_FIT.name: paths(law, SHIFTED_START)}
    return {"problems": {(name, joint): own[name][joint] for name in own for joint in JOINTS}}


GA_BY_GENERATIONS = GA(crossover=CROSSOVER, mutation=MUTATION)
CHANGES: dict[str, Change] = {
    "cubic path": other_path(cubic),
    "bounds of 32 rad": fitted(lambda _: {"box": same_box(32.0)}),
    "bounds of 500 rad": fitted(lambda _: {"box": same_box(500.0)}),
    "bounds in rad per s^j": fitted(lambda path: {"box": tuple(
        (-COEFFICIENT * path.duration**j, COEFFICIENT * path.duration**j) for j in range(6))}),
    "twice Eq. (9)": fitted(lambda path: {"box": box_about(path, 2.0, centre=0.0)}),
    "Eq. (9) within a tenth": fitted(lambda path: {"box": box_about(path, 0.1, centre=1.0)}),
    **{f"{m} intervals": points(m) for m in (50, 200)},
    **{f"population of {n}": protocol(population=n) for n in (20, 50, 100)},
    **{f"{n} iterations": protocol(iterations=n) for n in (200, 1000)},
    **woa_readings(EXPERIMENTS, "WOA by its equations, numbers", "WOA by its equations, vectors",
                   "reflection", "new places"),
    "GA by generations": {"algorithms": everywhere(EXPERIMENTS, "GA", GA_BY_GENERATIONS)},
    "GA with blended genes": {"algorithms": everywhere([FIT], "GA", {"mixing": "blend"})},
    "GA with one-point crossover": {"algorithms": everywhere([FIT], "GA", {"mixing": "one point"})},
    "means of the runs": {"claims": search_claims("mean")},
    "best run": {"claims": (finds_the_optimum("best"),)},
    "angles as θ": {"claims": (within_limits(*CONVERTED),)},
    "greatest jerk of the polynomials": {"claims": (smoother_quintic(
        "greatest jerk between the ends"),)},
    "squared jerk of the polynomials": {"claims": (smoother_quintic(
        "integrated squared jerk between the ends"),)},
    "greatest jerk of what is found": {"claims": (less_smooth("median", "peak jerk", "largest"),)},
    "jumps of acceleration": {"claims": smoother_ends("median", "acceleration")},
    "spread of the ends": {"claims": (more_stable("cost"),)},
    "any change at all": {"claims": (sensitive(ANY_AT_ALL),)},
    "without the desired path": {"claims": (better_than_all("median", "cubic"),)},
}  # fmt: skip

KINEMATICS = "Angle, velocity and acceleration of the six joints"
PAPER = TEXT.paper(
    changes=CHANGES, experiments=EXPERIMENTS, inputs=(TABLE_IV, ANGLES), results=(),
    read_twice=True, claims=(*POLYNOMIAL_CLAIMS, *search_claims()),
    figures=(
        JointCurves(label="Fig. 2", caption=f"{KINEMATICS} by cubic polynomials", paths=CUBIC),
        JointCurves(label="Fig. 3", caption=f"{KINEMATICS} by quintic polynomials", paths=QUINTIC),
        *(JointCurves(label=label, caption=f"{KINEMATICS} fitted by {name}", paths=QUINTIC,
                      experiment=FIT.name, algorithms=(name,))
          for label, name in (("Fig. 4", "WOA"), ("Fig. 5", "GA"))),
        Convergence(label="Fig. 6", caption="Norm of the difference over the iterations of WOA and "
                    "GA", experiment=FIT.name),
        Arm(label="Arm", caption="The arm of Table IV between the angles of Eqs. (10) and (11), "
            "read as angles A1 to A6 of the real arm, by the quintic and by the cubic polynomials; "
            "no time is minimised or printed, so both last the time that is assumed",
            dh=DH, convention="standard", table=TABLE_IV, robot=KUKA,
            motions=(ArmMotion(name="quintic polynomials", problem=ARM_QUINTIC),
                     ArmMotion(name="cubic polynomials", problem=ARM_CUBIC)),
            assumed=("Denavit-Hartenberg convention", "what the start and end angles are",
                     "duration of the motion")),
    ),
)  # fmt: skip
