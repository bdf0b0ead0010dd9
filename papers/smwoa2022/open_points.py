"""SMWOA: what the paper leaves open or keeps to itself."""

from papers.smwoa2022.misprints import ERRATA
from repro.model import Assumption, Gap

__all__ = ["ASSUMPTIONS", "ERRATA", "GAPS", "UNOPTIMISED"]

UNOPTIMISED = Gap(
    what="time of the motion before optimisation (39.526 s)",
    where="section 4.3, Fig. 3",
    because="neither the segment times before optimisation nor how they were chosen is printed",
)
GAPS = (
    UNOPTIMISED,
    Gap(
        what="low energy consumption of the trajectory",
        where="abstract",
        because="no energy is defined, measured or printed; the cost is time alone",
    ),
    Gap(
        what="computing time, of order d + T N (1 + log N + d)",
        where="section 3.2",
        because="no computing times are printed; it is an estimate on paper, not a result",
    ),
)

_ALGORITHM = (
    Assumption(
        what="whether SMA's restart (z) and its contraction by v_c survive in SMWOA",
        where="Eqs. (8) and (12)-(14), Fig. 1",
        chosen="no",
        alternatives=("the restart with z = 0.03, as in SMA's program",),
        because="section 3 describes three moves, Eqs. (12) to (14), and no other",
    ),
    Assumption(
        what="A and D: whether both have the same r_rand, and whether it is a vector",
        where="Eqs. (4) and (15)",
        chosen="one number per whale each, from independent draws",
        alternatives=("one draw for both", "a fresh number for every coordinate"),
        because="r_rand is called a vector, but |A| is compared with 1; WOA's program draws so",
    ),
    Assumption(
        what="v_b: a number or a vector, and how it is drawn",
        where="Eqs. (8), (10) and (13)",
        chosen="a fresh number for every coordinate, uniform in [-a, a]",
        alternatives=("one number per whale",),
        because="it is called a vector; SMA's program draws so",
    ),
    Assumption(
        what="whose weight ω stands in Eqs. (13) and (14), and whether it is a vector",
        where="Eqs. (11) and (15)",
        chosen="that of the whale that moves, with a fresh r for every coordinate",
        alternatives=("that of the whale it multiplies (1 for the best)", "one r per whale"),
        because="in SMA's program a mould multiplies another's position by its own weight",
    ),
    Assumption(
        what="logarithm of the weight, and the weight where all costs are equal",
        where="Eq. (11)",
        chosen="decimal; 1 where Eq. (11) is 0/0",
        alternatives=("natural",),
        because="SMA's program takes the decimal one",
    ),
    Assumption(
        what="random whale X^r, range of l, shape b of the spiral, probability P",
        where="Eqs. (5) to (7), (13) and (14)",
        chosen="one whale for all coordinates; l uniform in [-1, 1]; b = 1; P uniform in [0, 1], "
        "drawn per whale",
        alternatives=("as WOA's program: a new whale per coordinate, l from a shrinking range",),
        because="the text says so but for b, which is WOA's; it concerns SMWOA only",
    ),
    Assumption(
        what="order of moves, bounds, and whether a move must be better to be kept",
        where="section 3.1, Fig. 1",
        chosen="whales move one after another, every move is kept, and a whale outside the box is "
        "put on its edge when it is next evaluated",
        alternatives=("all at once", "only better moves are kept", "reflection at the edge"),
        because="the text is silent; this is what both parents' programs do",
    ),
    Assumption(
        what="first value of t in Eqs. (10) and (15)",
        where="Eqs. (10) and (15)",
        chosen="1",
        alternatives=(),
        because="at t = 0 the arc hyperbolic tangent is infinite",
    ),
)
_BENCHMARK = (
    Assumption(
        what="WOA, PSO, GSA, DE and SMA: programs and parameters",
        where="section 3.3",
        chosen="the authors' programs with their defaults (PSO: the one of the wolf and whale "
        "toolboxes; GSA: new places for coordinates outside the box; DE: F uniform in [0.2, 0.8], "
        "CR = 0.2; SMA: z = 0.03)",
        alternatives=("other published variants", "parameters tuned per function"),
        because="the paper gives neither parameters nor programs",
    ),
    Assumption(
        what="dimension of F8",
        where="Table 2",
        chosen="30",
        alternatives=("2 to 4, as the last five functions",),
        because="the cell is empty; F8 is listed among the multimodal functions of 30 dimensions",
    ),
    Assumption(
        what="box of F12",
        where="Table 2",
        chosen="[-5, 5] for both coordinates, as printed",
        alternatives=("[-5, 10] for the first and [0, 15] for the second, as usual",),
        because="the printed box holds one of the three minimisers, so the optimum is the same",
    ),
    Assumption(
        what="constants of F11, F14 and F15",
        where="Table 2",
        chosen="those of Yao, Liu & Lin 1999",
        alternatives=("other libraries' roundings",),
        because="none are printed; the names and optima are those of that set",
    ),
    Assumption(
        what="standard deviation",
        where="Table 3",
        chosen="divided by n - 1",
        alternatives=("divided by n",),
        because="the paper used MATLAB, whose std does so",
    ),
    Assumption(
        what="what the one p-value per algorithm is a test of",
        where="Table 3, p/h",
        chosen="rank-sum of all runs on all 15 functions together, 450 costs against 450",
        alternatives=(
            "the mean of 15 p-values, one per function",
            "the 15 averages of one algorithm against those of the other",
        ),
        because="the text names the test and not its samples; the printed averages themselves give "
        "0.005 to 0.7, far from the printed values",
    ),
    Assumption(
        what="how algorithms are ranked",
        where="Table 3, average ranking",
        chosen="by the average on each function, the lowest first; ties share the mean of their "
        "places",
        alternatives=("by the standard deviation as well",),
        because="so ranked, the printed averages give four of the six printed average ranks",
    ),
)
_TRAJECTORY = (
    Assumption(
        what="unit of the angles in Table 4",
        where="Tables 4 and 5",
        chosen="degrees",
        alternatives=(),
        because="Table 5 and the text have degrees",
    ),
    Assumption(
        what="what is searched, and in which range",
        where="section 4.2, Eq. (23)",
        chosen="the five segment times, each from 0.1 s to 10 s",
        alternatives=("any other range that holds the optimum",),
        because="the text is silent; the printed times and the optimum lie well inside",
    ),
    Assumption(
        what="handling of motions that break a limit",
        where="section 4.2, Eq. (28)",
        chosen="any motion that obeys comes before any that does not, and these by excess; last "
        "come durations with which time would run backwards somewhere",
        alternatives=("every motion counts with the time at which it just obeys",),
        because="the text is silent; this rule has no weight to choose",
    ),
    Assumption(
        what="sign of the limits",
        where="Eq. (28)",
        chosen="they hold for the absolute values of velocity and acceleration",
        alternatives=("for one direction only, as Eq. (28) is printed",),
        because="Table 5 has one limit per joint for both directions",
    ),
    Assumption(
        what="angle limits",
        where="Table 5, Eq. (28)",
        chosen="not part of the search",
        alternatives=(),
        because="Eq. (28) omits them; the path does not depend on the durations, and its largest "
        "angles are 30 % (joint 3) to 65 % (joint 4) of them",
    ),
    Assumption(
        what="end condition of the B-splines",
        where="Eqs. (20) and (22)",
        chosen="Eq. (20) for angles and time alike",
        alternatives=("at rest at both ends",),
        because="Eq. (22) treats both alike; the alternative has a certificate of its own",
    ),
    Assumption(
        what="number of runs, and which of them Table 6 and Figs. 3 and 4 show",
        where="section 4.3",
        chosen="any one run; 30 are made to say how far one run may lie from another",
        alternatives=("the best of several", "the mean of several"),
        because="the text gives no number of runs for the motion",
    ),
)

ASSUMPTIONS = (*_ALGORITHM, *_BENCHMARK, *_TRAJECTORY)
