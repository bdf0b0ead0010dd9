"""SYJI-0035 arm: seventh-order polynomials in four segments, timed by whale optimisation."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from repro.model import (
    WOA_BY_VECTORS, Arm, ArmMotion, Between, CellClaim, Claim, Computed, Convergence,
    Difference, Experiment, InRange, Less, Motion, MotionReading, Percent, Printed, PublishedTable,
    Reduction, RoundedOrCut, SameNumbers, Sentence, Sum, TableCell, TextNumber, ToolPath,
    as_one, column_cells, computed, computed_cells, equally_spaced, not_counted, prose, runs_of,
    says, says_in_words, woa_readings,
)  # fmt: skip
from repro.robotics import MinimumTime, RestToRestLaw, dh_rows, quintic, septic
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import cheapest
from repro.robotics.piecewise import PiecewiseMotion, passing_through, resting_at
from repro.robotics.rest_to_rest import DERIVATIVES, peaks

TEXT = prose(__file__)
TABLE_1 = PublishedTable.read("""
    Table 1, section 6R robot modeling
    Joint || Link distance di [m] | Link length ai-1 [m] | Link twist αi-1 [deg] | θi [text]
    1     || 0                    | 0                    | 0                     | -150°~150°
    2     || 0.02                 | 0.2                  | -90                   | -60°~55°
    3     || 0                    | 0.64                 | -90                   | -65°~65°
    4     || 0.866                | 0                    | -90                   | -180°~180°
    5     || 0                    | 0                    | 90                    | -150°~60°
    6     || 0.267                | 0                    | 180                   | -360°~360°
""")
TABLE_2 = PublishedTable.read("""
    Table 2, section 6R robot simulation
    Joint || Maximum velocity 7 [deg/s] | Maximum velocity 5 [deg/s] | Maximum acceleration 7 [deg/s^2] | Maximum acceleration 5 [deg/s^2] | Maximum Jerk 7 [deg/s^3] | Maximum Jerk 5 [deg/s^3]
    1     || 19.68 | 16.88 | 13.52 | 10.39 | 15.12 | 21.6
    2     || 39.36 | 33.75 | 27.04 | 20.75 | 37.78 | 43.2
    3     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    4     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    5     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    6     || 39.36 | 33.75 | 27.04 | 20.75 | 37.78 | 43.2
""")  # noqa: E501 (the heading is as wide as the page's)
TABLE_3 = PublishedTable.read("""
    Table 3, section Simulation parameter settings, item 1
    Joint || Maximum Velocity [deg/s] | Maximum Acceleration [deg/s^2] | Maximum Jerk [deg/s^3]
    1     || 19.68                    | 13.52                          | 15.12
    2     || 39.36                    | 27.04                          | 37.78
    3     || 19.68                    | 13.52                          | 18.89
    4     || 19.68                    | 13.52                          | 18.89
    5     || 19.68                    | 13.52                          | 18.89
    6     || 39.36                    | 27.04                          | 37.78
""")
TABLE_4 = PublishedTable.read("""
    Table 4, section Simulation parameter settings, item 2
    Joint || θ0 [deg] | θ1 [deg] | θ2 [deg] | θ3 [deg] | θf [deg]
    1     || 0        | 11.25    | 22.5     | 33.75    | 45
    2     || 90       | 67.5     | 45       | 22.5     | 0
    3     || 0        | -11.25   | -22.5    | -33.75   | -45
    4     || 0        | 11.25    | 22.5     | 33.75    | 45
    5     || 0        | -11.25   | -22.5    | -33.75   | -45
    6     || 0        | -22.5    | -45      | -67.5    | -90
""")
DOUBLED = "26"  # the joints that travel twice as far as the others; see the errata
HEADINGS = ("Maximum velocity", "Maximum acceleration", "Maximum Jerk")  # of Table 2
SIMULATION = "section 6R robot simulation"
RESULTS = "section Simulation parameter settings, item 4"
START = tuple(Printed(text, "rad") for text in ("0", "π/2", "0", "0", "0", "0"))  # q1
END = tuple(Printed(text, "rad") for text in ("π/4", "0", "-π/4", "π/4", "-π/4", "-π/2"))  # q2
WHOLE, TOTAL, SAVED = (Printed(text, "s") for text in ("5", "2.2999", "2.7001"))
DURATIONS = tuple(Printed(text, "s") for text in ("0.2308", "0.845", "0.9166", "0.258"))
Jerks = tuple[float, ...]  # the greatest allowed of each joint, in rad/s³
Durations = tuple[float, ...]  # of the four segments, in s


def corrected(segment: int, seconds: float) -> Durations:
    """Return the printed durations with another one for a segment, counted from 1."""
    return tuple(
        seconds if k == segment else printed.si for k, printed in enumerate(DURATIONS, 1)
    )  # fmt: skip


JERK = TABLE_3.column("Maximum Jerk")
ALIKE = (JERK[2], *JERK[1:])  # joint 3 travels as far as joint 1
FOUND = corrected(2, 0.8945)  # see the errata

# One polynomial from q1 to q2, Eqs. (1)-(3); then the problem as printed, Eqs. (4)-(9)
SEVENTH = MinimumTime(
    waypoints=tuple(tuple(angle.si for angle in place) for place in (START, END)),
    velocity=TABLE_3.column("Maximum Velocity"), jerk=TABLE_3.column("Maximum Jerk"),
    acceleration=TABLE_3.column("Maximum Acceleration"), durations=(0.1, 10.0), law=septic,
)  # fmt: skip
ORDERS = {"7": SEVENTH, "5": replace(SEVENTH, law=quintic)}
PRINTED = replace(
    SEVENTH,
    waypoints=tuple(TABLE_4.column(name) for name in TABLE_4.column_names),
    durations=(0.1, WHOLE.si),
    handling="fixed penalties",
    penalties=(0.1, 0.01, 0.01),  # λ1, λ2, λ3: section Simulation parameter settings, item 3
)
RESTING = replace(PRINTED, handling="feasibility first")
MOTION = Experiment(
    name="motion", where=RESULTS, proposed="WOA", problems={"SYJI-0035": PRINTED},
    algorithms={"WOA": WOA_BY_VECTORS}, population=50, iterations=200, runs=1,
)  # fmt: skip
DH = dh_rows(a=TABLE_1.column("Link length ai-1"), alpha=TABLE_1.column("Link twist αi-1"),
             d=TABLE_1.column("Link distance di"))  # fmt: skip

AT_REST, PASSING, ONE = (
    "at rest at each position of Table 4",
    "passing through the positions of Table 4 without a stop",
    "with one polynomial from start to end",
)
READINGS: dict[str, Callable[[Durations], PiecewiseMotion]] = {
    AT_REST: lambda durations: resting_at(PRINTED.waypoints, durations, law=septic),
    PASSING: lambda durations: passing_through(PRINTED.waypoints, durations, degree=septic.degree),
    ONE: lambda durations: resting_at(SEVENTH.waypoints, (sum(durations),), law=septic),
}  # fmt: skip
KINDS = tuple((kind, derivative) for derivative, kind in DERIVATIVES.items())
BEFORE = computed("the 5 s of the seventh-order motion", lambda: WHOLE.si)
TIME = Percent(1)  # declared before any run: one run of a search, given to four digits
TWO_DECIMALS = RoundedOrCut()  # Table 2 has both: see the assumptions
KEPT = Between(0, 100.1)  # Table 3 is cut to two decimals, less than 0.1 % of any limit


def table_2() -> tuple[CellClaim, ...]:
    """Return the claims on Table 2, by the derivatives that its headings mean."""
    meant = dict(zip(HEADINGS, DERIVATIVES, strict=True))

    def greatest(joint: str, column: str) -> Computed:
        kind, _, order = column.rpartition(" ")
        return computed(
            f"closed form of the {kind.lower()} of joint {joint}, order {order}, 5 s",
            lambda: float(peaks(ORDERS[order], (WHOLE.si,), meant[kind])[int(joint) - 1]),
        )

    return tuple(
        replace(claim, group=computation(claim.row, claim.column))
        for claim in computed_cells(TABLE_2, measure=greatest, within=TWO_DECIMALS)
    )


def computation(joint: str, column: str) -> str:
    """Return what a cell of Table 2 counts with: joints that travel alike, or one slip."""
    travel = abs(TABLE_4[joint, "θf"].value - TABLE_4[joint, "θ0"].value)
    if (joint, column) == ("1", "Maximum Jerk 7"):
        return "Table 2, jerk of joint 1"
    if joint in DOUBLED and column in {"Maximum velocity 7", "Maximum Jerk 7"}:
        return "Table 2, doubled after cutting"
    return f"Table 2, {column}, joints that travel {travel:g}°"


def share(motion: PiecewiseMotion, derivative: int, of: MinimumTime) -> float:
    """Return the largest share of its limit that any joint uses, in percent."""
    return float(100 * (motion.peaks(derivative) / of.limits[derivative - 1]).max())


def share_on_average() -> float:
    """Return the largest average speed of a joint in a segment, in percent of its limit.

    Whatever the curve, a joint is somewhere as fast as it is on average.
    """
    averages = PRINTED.distances / np.array(FOUND)[:, None]
    return float(100 * (averages / PRINTED.limits[0]).max())


def times(statistic: str = "mean") -> tuple[Sentence, ...]:
    """Return the claims on the one result of the search, by a statistic of the runs."""
    found = runs_of(MOTION, "WOA", statistic)
    total = found("total")
    return as_one("the time found", (
        says("the search finds a total time of 2.2999 s", RESULTS, TOTAL, total, within=TIME),
        *(
            says(
                f"the search finds {printed.text} s for segment {k}", RESULTS, printed,
                found(f"duration {k}"), within=TIME)
            for k, printed in enumerate(DURATIONS, 1)
        ),
        says(
            "that is 2.7001 s less than the seventh-order motion of 5 s", RESULTS, SAVED,
            Difference(before=BEFORE, after=total), within=TIME),
    ))  # fmt: skip


def reduced(statistic: str = "mean") -> Sentence:
    """Return the claim that the time is greatly reduced, by a statistic of the runs."""
    return says_in_words(
        "the time of each joint is greatly reduced (read as: by a tenth at least; the printed "
        "times differ by 54 %; all joints share the four durations)", RESULTS, "54 %",
        Reduction(before=BEFORE, after=runs_of(MOTION, "WOA", statistic)("total")),
        within=Between(10, 100))  # fmt: skip


def shortest(problem: MinimumTime) -> tuple[Sentence, ...]:
    """Return the claim that no time is shorter, for the range of durations of a problem."""
    return as_one("the time found", [says(
        "the running time is the shortest (read as: it is that of the least fitness as printed)",
        "Conclusion", TOTAL,
        computed(f"time of the proved minimum of the fitness as printed, each duration being "
                 f"{problem.durations[0]:g} s or more", lambda: cheapest(problem).time),
        within=TIME)])  # fmt: skip


SMOOTHNESS: Mapping[str, Callable[[RestToRestLaw], float]] = {
    "greatest jerk": lambda law: law.peak_factor(3),
    "jump of jerk at start and end": lambda law: abs(float(law.polynomial.deriv(3)(0.0))),
    "integral of squared jerk": lambda law: law.squared(3),
}
ANY_CURVE = "with any curve whatever that is at rest at the ends"
SHORTEST: Mapping[str, Callable[[Jerks], float]] = {
    AT_REST: lambda jerk: float(replace(RESTING, jerk=jerk).shortest().sum()),
    ONE: lambda jerk: float(replace(SEVENTH, jerk=jerk).shortest().sum()),
    ANY_CURVE: lambda jerk: max(fastest_joints(replace(RESTING, jerk=jerk))),
}


def smoother(meaning: str) -> Sentence:
    """Return the claim that the seventh order is smoother, by one meaning of smooth."""
    of = SMOOTHNESS[meaning]
    return says_in_words(
        "the seventh order is smoother than the fifth", f"abstract, {SIMULATION} and Conclusion",
        "100 %", computed(f"{meaning}: seventh order in percent of the fifth, same move and time",
                          lambda: 100 * of(septic) / of(quintic)),
        within=Between(0, 100))  # fmt: skip


def unshaken(how: str, durations: Durations = FOUND) -> Sentence:
    """Return the claim that no joint turns back, by what the arm does between the positions."""
    return says_in_words(
        "the path is smooth, without shaking (read as: no joint turns back)",
        f"{RESULTS}, Fig. 6", "0",
        computed(f"how often a joint turns back with the printed durations, {how}",
                 lambda: float(READINGS[how](durations).reversals())),
        within=Between(0, 0))  # fmt: skip


def saved_under_limits(how: str, jerk: Jerks = JERK) -> Sentence:
    """Return the claim that the time is saved under the limits of Table 3, or others of jerk."""
    least = computed(f"the least time that obeys the limits, {how}", SHORTEST[how], jerk)
    return says(
        "2.7001 s are saved under the same limits", RESULTS, SAVED,
        Difference(before=BEFORE, after=least), within=TIME)  # fmt: skip


def kept(kind: str, measure: Computed) -> Sentence:
    """Return the claim that a kind of limit is kept, by its largest share in percent."""
    claim = says_in_words(
        f"the {kind} limits are satisfied", "Conclusion", "100 %", measure, within=KEPT
    )  # fmt: skip
    return replace(claim, group="the constraints are satisfied")


def limits_kept(
    how: str, durations: Durations = FOUND, of: MinimumTime = PRINTED
) -> tuple[Sentence, ...]:
    """Return the claims that durations keep each kind of limit, by what the arm does."""
    return tuple(
        kept(kind, computed(
            f"largest {kind} in percent of its limit, {how}, with "
            f"{', '.join(f'{seconds:g}' for seconds in durations)} s",
            lambda m=m: share(READINGS[how](durations), m, of)))
        for kind, m in KINDS
    )  # fmt: skip


def between(how: str, durations: Durations = FOUND) -> tuple[Claim, ...]:
    """Return the claims on what the arm does with the printed durations."""
    return unshaken(how, durations), *limits_kept(how, durations)


def limit_kept_before(kind: str, derivative: int, of: MinimumTime = PRINTED) -> Sentence:
    """Return the claim that the motion of 5 s keeps a kind of limit, which is copied from it."""
    motion = resting_at(SEVENTH.waypoints, (WHOLE.si,), law=septic)
    return says_in_words(
        f"the seventh-order motion of 5 s is under the same {kind} limits", RESULTS, "100 %",
        computed(f"largest {kind} of the 5 s motion in percent of its limit", share, motion,
                 derivative, of), within=KEPT)  # fmt: skip


SERVO = says_in_words(
    "greatest velocity, acceleration and jerk of both orders are far below what the servo drive "
    "allows", SIMULATION, "100 %", TEXT.gap("servo"), within=Between(0, 100),
)  # fmt: skip
WHATEVER_THE_CURVE = (
    kept("velocity", computed(
        "largest average velocity in a segment with the printed durations, in percent of its "
        "limit, which no curve through Table 4 is below everywhere", share_on_average)),
    saved_under_limits(ANY_CURVE),
)  # fmt: skip

JERK_ALIKE = replace(PRINTED, jerk=ALIKE)
RANGES = {f"durations from {least:g} s": (least, WHOLE.si) for least in (0.01, 0.5, 1.0)}
PROBLEMS: dict[str, dict[str, Any]] = {
    "penalties per joint": {"handling": "fixed penalties per joint"},
    "penalties per segment": {"handling": "fixed penalties per joint and segment"},
    "penalties where kept": {"handling": "fixed penalties where kept"},
    "equal jerk limits": {"jerk": ALIKE},
    **{name: {"durations": durations} for name, durations in RANGES.items()},
}
CLAIMS: dict[str, tuple[Claim, ...]] = {
    "equal jerk limits": (
        limits_kept(AT_REST, of=JERK_ALIKE)[-1],
        limit_kept_before(*KINDS[-1], JERK_ALIKE),
        saved_under_limits(AT_REST, ALIKE),
    ),
    **{name: shortest(replace(PRINTED, durations=own)) for name, own in RANGES.items()},
    "passing through": between(PASSING),
    "one polynomial": (*between(ONE), saved_under_limits(ONE)),
    "any curve": WHATEVER_THE_CURVE,
    "0.2803 s for segment 1": between(AT_REST, corrected(1, 0.2803)),
    "0.9661 s for segment 3": between(AT_REST, corrected(3, 0.9661)),
    **{meaning: (smoother(meaning),) for meaning in tuple(SMOOTHNESS)[1:]},
    "best of 30 runs": (*times("best"), reduced("best")),
}
CHANGES: dict[str, dict[str, Any]] = {
    **{name: {"claims": own} for name, own in CLAIMS.items()},
    **{name: {"problems": {("motion", "SYJI-0035"): own}, "claims": CLAIMS.get(name, ())}
       for name, own in PROBLEMS.items()},
    "best of 30 runs": {"protocol": {"motion": {"runs": 30}}, "claims": CLAIMS["best of 30 runs"]},
    **woa_readings([MOTION]),
}  # fmt: skip


def in_text(printed: Printed) -> TextNumber:
    """Return a number of the text that reports the result."""
    return TextNumber(printed=printed, where=RESULTS)


def ends(joint: str) -> dict[str, TextNumber]:
    """Return the ends of a joint's range, which Table 1 prints in one cell."""
    cell = str(TABLE_1.cells[TABLE_1.row_names.index(joint)][-1]).replace("°", "")
    return {
        end: TextNumber(printed=Printed(text, "deg"), where=f"Table 1, joint {joint}")
        for end, text in zip(("low", "high"), cell.split("~"), strict=True)
    }


RELATIONS = (
    Sum(total=in_text(TOTAL), addends=tuple(map(in_text, DURATIONS))),
    Less(
        printed=in_text(SAVED),
        before=TextNumber(printed=WHOLE, where=SIMULATION),
        after=in_text(TOTAL),
    ),
    *(
        SameNumbers(
            first=column_cells(TABLE_3, limit),
            second=column_cells(TABLE_2, f"{peak} 7"),
            meaning="the limits are what Table 2 prints as peaks of the 5 s motion, so that no "
            "faster motion of that shape obeys them",
        )
        for limit, peak in zip(TABLE_3.column_names, HEADINGS, strict=True)
    ),
    *equally_spaced(TABLE_4),
    *(
        InRange(value=TableCell(table=TABLE_4, row=joint, column=place), **ends(joint))
        for joint in TABLE_4.row_names
        for place in TABLE_4.column_names
    ),
)

PAPER = TEXT.paper(
    read_twice=True,
    experiments=(MOTION,),
    inputs=(TABLE_1, TABLE_3, TABLE_4),
    results=(TABLE_2,),
    claims=(
        *table_2(),
        smoother("greatest jerk"),
        SERVO,
        *between(AT_REST),
        *times(),
        reduced(),
        *shortest(PRINTED),
        saved_under_limits(AT_REST),
        *not_counted(limit_kept_before(*kind) for kind in KINDS),
    ),
    changes=CHANGES,
    relations=RELATIONS,
    motion_readings=tuple(
        MotionReading(name=f"limits kept, {how}", of=("motion", "SYJI-0035"), problem=problem)
        for how, problem in (
            ("at rest at each position", RESTING),
            ("one polynomial from start to end", SEVENTH),
        )
    ),
    figures=(
        *(
            Motion(
                label=f"Fig. 4, order {order}", problem=problem, durations=(WHOLE.si,),
                caption="Angle, velocity, acceleration and jerk of the six joints in 5 s, with the "
                "limits of Table 3",
            )
            for order, problem in ORDERS.items()
        ),
        Convergence(label="Fig. 5", caption="Fitness as printed over the iterations",
                    experiment="motion"),
        ToolPath(
            label="Fig. 6", caption="Path of the tool through the positions of Table 4",
            problem=RESTING, dh=DH, convention="modified", printed_waypoints=(),
        ),
        Arm(
            label="Arm", dh=DH, convention="modified", table=TABLE_1,
            caption="The arm of Table 1 on its way through Table 4, at rest at each position, with "
            "the printed durations and with the shortest that keep the limits of Table 3",
            motions=(
                ArmMotion(name="certified optimum, limits kept", problem=RESTING),
                ArmMotion(name="WOA as printed", problem=RESTING, durations=FOUND),
            ),
            assumed=("Denavit-Hartenberg convention", "link twists of joints 3 and 6"),
        ),
    ),
)  # fmt: skip
