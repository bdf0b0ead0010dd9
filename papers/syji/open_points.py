"""SYJI-0035: what the paper leaves open, misprints, or keeps to itself."""

from repro.model import Assumption, Erratum, Gap

SERVO = Gap(
    what="greatest velocity, acceleration and jerk against what the servo drive allows",
    where="section 6R robot simulation",
    because="the drive and its limits are not printed",
)

ASSUMPTIONS = (
    Assumption(
        what="which columns of Table 2 are velocity, acceleration and jerk, and which order",
        where="Table 2",
        chosen="velocity, acceleration, jerk from left to right, 7 before 5 in each",
        alternatives=("acceleration before velocity, as the copy lists the headings",),
        because="the copy has lost the layout; Table 3 repeats the columns 7 under these names, "
        "and the closed form gives these values and no others",
    ),
    Assumption(
        what="how the values of Table 2 were brought to two decimals",
        where="Table 2",
        chosen="rounded or cut off",
        alternatives=("rounded", "cut off"),
        because="16.875 is printed both as 16.88 and as 16.87",
    ),
    Assumption(
        what="when P1, P2 and P3 are 1",
        where="Eqs. (6)-(8)",
        chosen="if the greatest value of any joint is above its limit, once for each kind",
        alternatives=("once per joint", "once per joint and segment", "if it is below the limit"),
        because="the copy has lost the inequality sign, and Eq. (9) has three terms; the fitness "
        "stays lower where limits are broken even if they are counted per joint and segment",
    ),
    Assumption(
        what="what the arm does at the positions between start and end",
        where="Eqs. (1)-(4), Table 4",
        chosen="each segment is a seventh-order polynomial at rest at both of its ends",
        alternatives=(
            "it passes through: the C^6 spline of order 7, at rest at start and end",
            "it passes on one polynomial from start to end",
        ),
        because="Eq. (1) sets velocity, acceleration and jerk at both ends of a polynomial, and "
        "no other condition is printed; the printed durations are judged under all three, and the "
        "fitness as printed is least at the shortest durations under all three",
    ),
    Assumption(
        what="greatest jerk allowed of joint 1",
        where="Table 3",
        chosen="15.12 °/s³, as printed",
        alternatives=("18.89 °/s³, as joints 3 to 5 of the same travel",),
        because="Tables 2 and 3 both print it; with 18.89 the least times that obey are 12.60, "
        "5.002 and 4.458 s instead of 13.57, 5.386 and 4.651 s",
    ),
    Assumption(
        what="range in which a duration is sought",
        where="section Simulation parameter settings",
        chosen="0.1 s to 5 s per segment",
        alternatives=("any other range",),
        because="the text is silent; 0.1 s is the step of the paper's own time axis, 5 s the time "
        "of the whole motion before optimisation; from any lower end below 1.2 s the fitness as "
        "printed is least with all four durations on that end, so no range gives the printed four",
    ),
    Assumption(
        what="durations of the joints",
        where="Eq. (4), Table 4",
        chosen="shared by all joints",
        alternatives=("one set per joint",),
        because="four durations are printed for six joints",
    ),
    Assumption(
        what="number of runs, and which of them is printed",
        where="section Simulation parameter settings, item 4",
        chosen="one run",
        alternatives=("the best of several",),
        because="one result is printed and no number of runs",
    ),
    Assumption(
        what="WOA: program, or equations as printed",
        where="Eqs. (10)-(17)",
        chosen="the authors' program (Mirjalili & Lewis 2016), b = 1",
        alternatives=(
            "as the equations say: one random whale for all coordinates, l uniform in [-1, 1]",
        ),
        because="the paper cites them and works in MATLAB; a duration outside its range is put "
        "on the edge, as there",
    ),
    Assumption(
        what="meaning of smoother",
        where="abstract, section 6R robot simulation, Conclusion",
        chosen="three readings, each judged: greatest jerk, jump of jerk at both ends, integral of "
        "squared jerk",
        alternatives=("peak velocity or acceleration, in which the fifth order is lower",),
        because="no measure is printed; Table 2 shows jerk",
    ),
    Assumption(
        what="meaning of a path without shaking",
        where="section Simulation parameter settings, item 4, Fig. 6",
        chosen="no joint turns back between start and end",
        alternatives=("a bound on the jerk of the tool",),
        because="Table 4 leads every joint one way, and no measure is printed",
    ),
    Assumption(
        what="Denavit-Hartenberg convention",
        where="Table 1",
        chosen="modified, as the headings a_{i-1} and α_{i-1} say; θ without offset",
        alternatives=("standard",),
        because="no position of the tool is printed to check it by",
    ),
    Assumption(
        what="link twists of joints 3 and 6",
        where="Table 1",
        chosen="-90° and 180°, as printed",
        alternatives=("0° for joint 3 and 90° or -90° for joint 6, as in most arms of this build",),
        because="as printed axes 2 and 3 are perpendicular and axes 5 and 6 parallel; the copy has "
        "lost the layout of the table, and only the counterpart of Fig. 6 depends on it",
    ),
)

ERRATA = (
    Erratum(
        where="section Simulation parameter settings, item 4",
        printed="0.845 s for segment 2",
        used="0.8945 s wherever the printed durations are judged; 0.845 as printed in its claim",
        because="the four printed durations make 2.2504 s, with 0.8945 they make 2.2999 s exactly",
    ),
    Erratum(
        where="Tables 2 and 3, jerk of joint 1, seventh order",
        printed="15.12",
        used="18.9 in Table 2; 15.12, as printed, as the limit of Table 3",
        because="42·45/5³ = 15.12 is the greatest positive jerk of a joint that moves 45° forward; "
        "its greatest jerk is -52.5·45/5³ = -18.9, and joint 4, which moves alike, has 18.89",
    ),
    Erratum(
        where="Table 2, joints 2 and 6, seventh order",
        printed="velocity 39.36 and jerk 37.78",
        used="39.375 and 37.8",
        because="they are twice 19.68 and 18.89, which are 19.6875 and 18.9 cut off (18.9 as a "
        "double can lie just below it)",
    ),
    Erratum(
        where="Table 2, joints 2 and 6, fifth order",
        printed="acceleration 20.75",
        used="20.785",
        because="10/√3·90/5² = 20.785, twice the 10.39 of the others; on the paper's time axis of "
        "0.1 s steps it would be 20.757, but 10.39 would then be 10.38",
    ),
    Erratum(
        where="Table 3",
        printed="limits said to be the greatest values of the seventh-order motion",
        used="as printed",
        because="most are cut off, so that the 5 s motion itself lies above them by less than "
        "0.1 %, which the tolerance of the claims allows for",
    ),
    Erratum(
        where="Table 1, θ2",
        printed="-60° to 55°",
        used="the 90° and 67.5° of Table 4, as printed",
        because="the motion starts outside the range of joint 2",
    ),
    Erratum(
        where="section Simulation parameter settings, item 3",
        printed="fitness with number (17)",
        used="Eq. (9) with λ = 0.1, 0.01, 0.01",
        because="(17) is already an equation of the search",
    ),
    Erratum(
        where="section Bubble-net attacking method, item 1",
        printed="A within [-1.1]",
        used="[-1, 1]",
        because="a comma became a point; in Eq. (12) A lies in [-a, a], a falling from 2",
    ),
)
