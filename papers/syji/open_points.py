"""SYJI-0035: what the paper leaves open."""

from collections.abc import Mapping

from papers.syji.printed import TABLE_3, WHOLE
from papers.syji.sentences import times
from papers.syji.table_2 import ACCELERATION_FIRST, table_2_claims
from repro.model.paper import Alternative, Assumption
from repro.model.tolerances import Absolute
from repro.optimisers import HybridWOA, SlimeWOA

BY_EQUATIONS = HybridWOA(leader="per whale", spiral_range="symmetric")

_JERK = TABLE_3.column("Maximum Jerk")
EQUAL_JERK = (_JERK[2], *_JERK[1:])  # joint 3 travels as far as joint 1


def changed(**fields: object) -> Mapping[tuple[str, str], object]:
    """Return a change of the motion problem."""
    return {("motion", "SYJI-0035"): fields}


ASSUMPTIONS = (
    Assumption(
        what="which columns of Table 2 are velocity, acceleration and jerk, and which order",
        where="Table 2",
        chosen="velocity, acceleration, jerk from left to right, 7 before 5 in each",
        alternatives=(
            Alternative(
                name="acceleration first",
                says="acceleration before velocity, as the copy lists the headings",
                claims=table_2_claims(ACCELERATION_FIRST),
            ),
        ),
        because="the copy has lost the layout; Table 3 repeats the columns 7 under these names, "
        "and the closed form gives these values and no others",
    ),
    Assumption(
        what="how the values of Table 2 were brought to two decimals",
        where="Table 2",
        chosen="rounded or cut off",
        alternatives=(
            Alternative(
                name="rounded only", says="rounded", claims=table_2_claims(within=Absolute(0))
            ),
            Alternative(says="cut off", untried="16.88 is above the exact value"),
        ),
        because="16.875 is printed both as 16.88 and as 16.87",
    ),
    Assumption(
        what="when P1, P2 and P3 are 1",
        where="Eqs. (6)-(8)",
        chosen="if the greatest value of any joint is above its limit, once for each kind",
        alternatives=(
            Alternative(
                name="penalties per joint",
                says="once per joint",
                problems=changed(handling="fixed penalties per joint"),
            ),
            Alternative(
                name="penalties per segment",
                says="once per joint and segment",
                problems=changed(handling="fixed penalties per joint and segment"),
            ),
            Alternative(
                name="penalties where kept",
                says="if it is below the limit",
                problems=changed(handling="fixed penalties where kept"),
            ),
        ),
        because="the copy has lost the inequality sign, and Eq. (9) has three terms; the fitness "
        "stays lower where limits are broken even if they are counted per joint and segment",
    ),
    Assumption(
        what="what the arm does at the positions between start and end",
        where="Eqs. (1)-(4), Table 4",
        chosen="each segment is a seventh-order polynomial at rest at both of its ends",
        alternatives=(
            Alternative(
                says="it passes through: the C^6 spline of order 7, at rest at start and end",
                untried="the printed durations are judged under it, and the fitness as printed is "
                "least at the shortest durations under it too",
            ),
            Alternative(says="it passes on one polynomial from start to end", untried="as above"),
        ),
        because="Eq. (1) sets velocity, acceleration and jerk at both ends of a polynomial, and "
        "no other condition is printed; the printed durations are judged under all three, and the "
        "fitness as printed is least at the shortest durations under all three",
    ),
    Assumption(
        what="greatest jerk allowed of joint 1",
        where="Table 3",
        chosen="15.12 °/s³, as printed",
        alternatives=(
            Alternative(
                name="equal jerk limits",
                says="18.89 °/s³, as joints 3 to 5 of the same travel",
                problems=changed(jerk=EQUAL_JERK),
            ),
        ),
        because="Tables 2 and 3 both print it; with 18.89 the least times that obey are 12.60, "
        "5.002 and 4.458 s instead of 13.57, 5.386 and 4.651 s",
    ),
    Assumption(
        what="range in which a duration is sought",
        where="section Simulation parameter settings",
        chosen="0.1 s to 5 s per segment",
        alternatives=(
            Alternative(
                name="durations from 0.01 s",
                says="0.01 s to 5 s",
                problems=changed(durations=(0.01, WHOLE.si)),
            ),
            Alternative(
                name="durations from 0.5 s",
                says="0.5 s to 5 s",
                problems=changed(durations=(0.5, WHOLE.si)),
            ),
            Alternative(
                says="any other range",
                untried="there is no end of them; none that starts below 1.2 s gives the printed "
                "four",
            ),
        ),
        because="the text is silent; 0.1 s is the step of the paper's own time axis, 5 s the time "
        "of the whole motion before optimisation; from any lower end below 1.2 s the fitness as "
        "printed is least with all four durations on that end, so no range gives the printed four",
    ),
    Assumption(
        what="durations of the joints",
        where="Eq. (4), Table 4",
        chosen="shared by all joints",
        alternatives=(
            Alternative(says="one set per joint", untried="four durations are printed, not 24"),
        ),
        because="four durations are printed for six joints",
    ),
    Assumption(
        what="number of runs, and which of them is printed",
        where="section Simulation parameter settings, item 4",
        chosen="one run",
        alternatives=(
            Alternative(
                name="best of 30 runs",
                says="the best of 30",
                protocol={"motion": {"runs": 30}},
                claims=times("best"),
            ),
        ),
        because="one result is printed and no number of runs",
    ),
    Assumption(
        what="WOA: program, or equations as printed",
        where="Eqs. (10)-(17)",
        chosen="the authors' program (Mirjalili & Lewis 2016), b = 1",
        alternatives=(
            Alternative(
                name="WOA by its equations",
                says="as the equations say: one random whale for all coordinates, l uniform in "
                "[-1, 1]",
                algorithms={("motion", "WOA"): BY_EQUATIONS},
            ),
            Alternative(
                name="WOA by its equations, vectors",
                says="the same, with A and C drawn for every coordinate, as r is a vector",
                algorithms={("motion", "WOA"): BY_EQUATIONS(coefficients="vector")},
            ),
            Alternative(
                name="WOA with one draw",
                says="WOA by its equations, with one r for A and C, which both print",
                algorithms={
                    ("motion", "WOA"): SlimeWOA(
                        leader="per whale", spiral_range="symmetric", shared_draw=True
                    )
                },
            ),
            Alternative(
                name="reflection",
                says="the program, with durations outside their range mirrored at its edge",
                algorithms={("motion", "WOA"): HybridWOA(bounds="reflect")},
            ),
            Alternative(
                name="new places",
                says="the program, with durations outside their range drawn anew",
                algorithms={("motion", "WOA"): HybridWOA(bounds="re-initialise")},
            ),
        ),
        because="the paper cites them and works in MATLAB; a duration outside its range is put on "
        "the edge, as there",
    ),
    Assumption(
        what="meaning of smoother",
        where="abstract, section 6R robot simulation, Conclusion",
        chosen="three readings, each judged: greatest jerk, jump of jerk at both ends, integral "
        "of squared jerk",
        alternatives=(
            Alternative(
                says="peak velocity or acceleration",
                untried="in these the fifth order is lower, as Table 2 itself shows",
            ),
        ),
        because="no measure is printed; Table 2 shows jerk",
    ),
    Assumption(
        what="meaning of a path without shaking",
        where="section Simulation parameter settings, item 4, Fig. 6",
        chosen="no joint turns back between start and end",
        alternatives=(
            Alternative(says="a bound on the jerk of the tool", untried="no bound is printed"),
        ),
        because="Table 4 leads every joint one way, and no measure is printed",
    ),
    Assumption(
        what="Denavit-Hartenberg convention",
        where="Table 1",
        chosen="modified, as the headings a_{i-1} and α_{i-1} say; θ without offset",
        alternatives=(
            Alternative(
                says="standard", untried="no claim rests on it, only the counterpart of Fig. 6"
            ),
        ),
        because="no position of the tool is printed to check it by",
    ),
    Assumption(
        what="link twists of joints 3 and 6",
        where="Table 1",
        chosen="-90° and 180°, as printed",
        alternatives=(
            Alternative(
                says="0° for joint 3 and 90° or -90° for joint 6, as in most arms of this build",
                untried="no claim rests on it, only the pictures of path and arm",
            ),
        ),
        because="as printed axes 2 and 3 are perpendicular and axes 5 and 6 parallel; the copy "
        "has lost the layout of the table, and only the pictures of path and arm depend on it",
    ),
)

# How penalties are counted and which jerk is allowed decide what the least fitness is.
TOGETHER = ("penalties per segment", "equal jerk limits", "WOA by its equations")
