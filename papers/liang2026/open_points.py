"""Liang et al.: what the paper leaves open, misprints, or keeps to itself."""

from repro.model import Assumption, Erratum, Gap

ROBOGUIDE = Gap(
    what="times in the RoboGuide simulation (18 % less)",
    where="section V-C 1) and section VI",
    because="the waypoints P1 to P4, the times and the planned motion are not printed",
)
PHYSICAL_ARM = Gap(
    what="times on the physical arm (16.4 % less)",
    where="section V-C 2) and section VI",
    because="the waypoints P1 to P4 and the measured times are not printed, and it needs the arm",
)
TOOL_ERROR = Gap(
    what="position error of the physical arm (within 2 mm)",
    where="section V-C 2) and section VI",
    because="no measured positions are printed, and it needs the arm",
)

ASSUMPTIONS = (
    Assumption(
        what="unit of lengths in Table III and of positions in Table IV",
        where="Tables III and IV",
        chosen="millimetres and metres",
        alternatives=(),
        because="none is printed; with these the tool comes near every printed waypoint",
    ),
    Assumption(
        what="Denavit-Hartenberg convention",
        where="Table III, Eqs. (20)-(21)",
        chosen="standard",
        alternatives=("modified, as the headings a_{i-1}, α_{i-1} and Eq. (20) say",),
        because="the standard one comes near the waypoints of Table IV, the modified one does not: "
        "the audit gives both distances in mm",
    ),
    Assumption(
        what="WOA, GWO, PSO and DBO: programs and parameters",
        where="section III-D",
        chosen="the authors' programs with their defaults (PSO: the one of the wolf and whale "
        "toolboxes)",
        alternatives=("other published variants", "parameters tuned per function"),
        because="the paper gives neither parameters nor programs",
    ),
    Assumption(
        what="DBO group sizes for 50 beetles",
        where="section III-D",
        chosen="10, 2, 7 and 31, as its authors' program makes them",
        alternatives=("in proportion to the 30 that the program is made for: 10, 10, 11, 19",),
        because="the program fixes two group ends for a population of 30",
    ),
    Assumption(
        what="course of the Tent map (Eq. 13) over the population",
        where="Eq. (13)",
        chosen="one chain per coordinate, running through the whales, from a uniform start",
        alternatives=("one chain per whale, running through its coordinates", "one chain for all"),
        because="with slope 2 a chain of doubles loses one bit a step and stays at 0 after about "
        "53 steps, so one chain for all would put most whales on a corner of the box",
    ),
    Assumption(
        what="what p_t selects (Eq. 16)",
        where="Eq. (16)",
        chosen="encircling or searching with probability p_t, else the spiral",
        alternatives=("the spiral with probability p_t",),
        because="p_t takes the place of the 0.5 below which WOA encircles",
    ),
    Assumption(
        what="A and C: one number per whale or a vector",
        where="Eqs. (8)-(12)",
        chosen="one number per whale, from independent draws",
        alternatives=("a fresh number for every coordinate",),
        because="they are called vectors, but r is called a number and |A| is compared with 1",
    ),
    Assumption(
        what="random whale of Eqs. (11)-(12) and range of l in Eq. (10)",
        where="Eqs. (10)-(12)",
        chosen="one whale for all coordinates; l uniform in [-1, 1]",
        alternatives=("as WOA's program: a new whale per coordinate, l from a shrinking range",),
        because="the text says so; it concerns IWOA only, the column WOA is the program",
    ),
    Assumption(
        what="share of whales that differential evolution acts on, F and CR",
        where="Eqs. (17)-(18), step 5",
        chosen="the worse half; F = 0.5, CR = 0.9",
        alternatives=("all whales", "F from 0.4 to 0.9, CR from 0.6 to 0.95"),
        because="the text says some individuals and prints usual ranges; these are the common "
        "settings inside them",
    ),
    Assumption(
        what="share of whales crossed, partner, size of the Gaussian perturbation",
        where="Eq. (19), step 6",
        chosen="the better half, each with a random other whale, α uniform per pair, standard "
        "deviation 1 % of the box",
        alternatives=("all whales", "the best whale as partner", "0.1 % or 10 % of the box"),
        because="the text says some individuals and gives no number",
    ),
    Assumption(
        what="whether a candidate must be better to replace its parent",
        where="steps 5 to 7",
        chosen="yes (greedy)",
        alternatives=("it always replaces its parent",),
        because="differential evolution is greedy in its source",
    ),
    Assumption(
        what="chaotic disturbance of the best point",
        where="section III-B 1)",
        chosen="one trial per iteration, one Tent step from a uniform start per coordinate, "
        "amplitude 1 % of the box falling linearly to 0, kept if better",
        alternatives=("another amplitude or course",),
        because="the text says small and gradually reduced",
    ),
    Assumption(
        what="evaluations",
        where="section III-D",
        chosen="500 iterations for every algorithm, whatever they cost",
        alternatives=("equal numbers of evaluations",),
        because="the paper fixes iterations; the additions make IWOA spend about twice as many "
        "evaluations as the others",
    ),
    Assumption(
        what="bounds of the benchmark searches",
        where="section III-D",
        chosen="a whale outside the box is put on its edge when it is next evaluated",
        alternatives=("reflection", "a random new place"),
        because="the text is silent; this is what WOA's program does",
    ),
    Assumption(
        what="range in which a duration is sought",
        where="section IV-C",
        chosen="0.1 s to 5 s per segment",
        alternatives=("any other range that holds the optimum",),
        because="the text is silent; 5 s is the duration before optimisation",
    ),
    Assumption(
        what="handling of motions that break a limit",
        where="Eq. (7), section IV-C",
        chosen="any motion that obeys comes before any that does not, and these by excess",
        alternatives=("a penalty per unit of excess", "one flat cost"),
        because="the text is silent; this rule has no weight to choose",
    ),
)

ERRATA = (
    Erratum(
        where="Table I, F12",
        printed="10 sin²(π (x_1+1)/4), Σ ((x_i+1)/4)² closed before the factor 1 + 10 sin²(π "
        "(x_n+1)/4), which so multiplies the sum once",
        used="Generalized penalized function 1 with y_i = 1 + (x_i+1)/4 and the factor "
        "1 + 10 sin²(π y_{i+1}) inside the sum (Yao, Liu & Lin 1999)",
        because="the name, box, constants and optimum are those of that function",
    ),
    Erratum(
        where="Eqs. (20)-(21)",
        printed="last row 0 0 0 0, in Eq. (20) and in the first matrix of Eq. (21)",
        used="0 0 0 1",
        because="a homogeneous transformation ends in 0 0 0 1, as the other matrices do",
    ),
    Erratum(
        where="Table III against Table IV",
        printed="d_1 = 490",
        used="490, as printed",
        because="the tables do not quite agree: the audit gives the gap and the one constant that "
        "would close it; the re-run keeps the print",
    ),
    Erratum(
        where="section III-D",
        printed="Kent map",
        used="Tent map",
        because="section III-B and Eq. (13) say Tent",
    ),
    Erratum(
        where="section III-C, step 4",
        printed="Eqs. (9) and (10) encircle, (11) is the spiral, (12) and (13) search",
        used="(8)-(9) encircle, (10) is the spiral, (11)-(12) search",
        because="that is what the numbered equations say; (13) is the Tent map",
    ),
)
