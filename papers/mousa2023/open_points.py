"""Mousa et al.: what the paper leaves open, misprints, or keeps to itself."""

from repro.model import Assumption, Erratum, Gap

GAPS = (
    Gap(
        what="the curves of Figs. 2 to 6 themselves",
        where="section IV and section V",
        because="they are printed as pictures without data, and neither the duration nor the "
        "settings of the searches are given; the re-run draws counterparts",
    ),
    Gap(
        what="polynomials are easier to implement",
        where="abstract, sections V and VI",
        because="no measure of ease is named; that Eq. (9) needs no search is claimed and checked",
    ),
    Gap(
        what="GA is the less complex algorithm, and both need more of it for more constraints",
        where="abstract and section VI",
        because="no measure of complexity is named and none printed; both spend one evaluation per "
        "agent and iteration. Read as complexity of the path it is claimed and checked",
    ),
    Gap(
        what="WOA and GA suit unstable environments and unpaved paths, unlike polynomials",
        where="section IV with Figs. 4 and 5, section V",
        because="no environment, disturbance or obstacle is defined, and no data are printed",
    ),
    Gap(
        what="WOA and GA reject paths that collide or cannot be executed",
        where="section V",
        because="no step of Tables III and IV rejects anything, and no obstacle is defined",
    ),
    Gap(
        what="WOA and GA balance time, energy and collisions where polynomials may struggle",
        where="section V",
        because="the one fitness is the norm of a difference; no second objective is printed",
    ),
    Gap(
        what="polynomials may be held to suboptimal paths",
        where="section V",
        because="no criterion by which a path would be better is printed, other than the norm, in "
        "which a polynomial has the least value there is",
    ),
    Gap(
        what="WOA is better because of its spiral",
        where="abstract",
        because="no search without the spiral is reported",
    ),
    Gap(
        what="choose polynomials for simple paths and WOA as surroundings grow complex",
        where="section V, end",
        because="it is advice; the statements under it are claims or gaps of their own",
    ),
)

ASSUMPTIONS = (
    Assumption(
        what="desired path that is fitted",
        where="Tables III and IV, step 2: a polynomial fitted to the start and the end angle",
        chosen="the quintic of Eq. (9)",
        alternatives=("the cubic of Eq. (4), re-run as well", "a straight line"),
        because="the output is called a polynomial of fifth degree; two angles alone fix no curve",
    ),
    Assumption(
        what="fitness",
        where="Table III, step 4",
        chosen="Euclidean norm of the difference of the angles at all instants, joint by joint",
        alternatives=("root of the mean square", "greatest difference"),
        because="norm of a vector means so in MATLAB, which the authors used",
    ),
    Assumption(
        what="what one search chooses",
        where="Table III, steps 1 and 5",
        chosen="the six coefficients of one joint; six searches make a path of the arm",
        alternatives=("all 36 coefficients in one search",),
        because="the best whale and its fitness carry the index of the joint",
    ),
    Assumption(
        what="duration of the motion",
        where="sections II and IV",
        chosen="2 s, from t = 0",
        alternatives=("any other",),
        because="none is printed; the copy keeps a 2 from a time axis of Fig. 2. Bounds below are "
        "such that the fits are the same for every duration; it only scales the derivatives. From "
        "0.56 s on the quintic keeps the speeds and accelerations of the real arm",
    ),
    Assumption(
        what="bounds of the coefficients",
        where="Tables III and IV, inputs",
        chosen="|a_j| T^j at most 50 rad for every coefficient and joint",
        alternatives=("joint ranges for a_0", "a narrow box about Eq. (9)", "wider ones"),
        because="none are printed; a round number with room for all joints (the largest is 30; on "
        "the septic path the best would be 64, and with 50 the error is still 0.3 % of the way)",
    ),
    Assumption(
        what="number of points M",
        where="Tables I to IV",
        chosen="100 intervals, 101 instants with both ends",
        alternatives=("50", "200"),
        because="none is printed; M scales the norm by about its root and nothing else",
    ),
    Assumption(
        what="population, iterations and runs",
        where="Tables III and IV, section IV",
        chosen="30 whales or chromosomes, 500 iterations, 30 runs",
        alternatives=("50 and 200", "one run, as the figures seem to show"),
        because="none are printed; those of the authors of WOA, and runs enough to see the spread",
    ),
    Assumption(
        what="program and parameters of WOA",
        where="Table III",
        chosen="its authors' program, b = 1",
        alternatives=("other published variants",),
        because="Table III has no step that moves a whale",
    ),
    Assumption(
        what="lineage of GA",
        where="section III-B, Table IV",
        chosen="as section III-B tells it: random parents, each gene that of the one or the other, "
        "a child replaces an agent only where it is better (rate 80 %), an agent is drawn anew "
        "whatever its cost (rate 1 %)",
        alternatives=(
            "by generations, which is run and judged as well: roulette on rank, blend, two elites",
            "as told, with genes blended",
            "one-point crossover",
        ),
        because="how a child comes of its parents is not told, and the two rates are those of "
        "MATLAB's program, which the authors may have used. The lineage decides: GA that blends is "
        "well ahead of WOA, GA that exchanges genes about equal to it. The one as told was added "
        "when runs of the other had shown this",
    ),
    Assumption(
        what="ranges of angle, velocity and acceleration in a search",
        where="Tables III and IV, inputs",
        chosen="not used",
        alternatives=("rejection of curves that leave them",),
        because="they are listed as inputs without values, and no step uses them",
    ),
    Assumption(
        what="Denavit-Hartenberg convention",
        where="the second Table IV",
        chosen="standard",
        alternatives=("modified",),
        because="no pose is printed to compare with. The modified one puts the axes of joints 5 "
        "and 6 on one line, so that the arm has five degrees of freedom at both postures; the "
        "standard one has six and meets the chain of the real arm in every posture",
    ),
    Assumption(
        what="what the start and end angles are",
        where="Eqs. (10) and (11)",
        chosen="both readings are checked; the fits need neither",
        alternatives=("angles A1 to A6 of the real arm", "joint angles θ of Table IV"),
        because="as A1 to A6 they lie in its ranges (github kroshu/kuka_robot_descriptions, "
        "kr4_r600_macro.xacro) and the tool is 0.91 m and 0.95 m high; as θ "
        "the tool is 1 mm and 3 mm above the base plane, but A2 is 59° beyond its range and the "
        "elbow stands 44 mm above that plane and within 50 mm of the axis of joint 1: in the base",
    ),
    Assumption(
        what="unit of the angles, α printed as 1.57",
        where="Eqs. (10) and (11), the second Table IV",
        chosen="radians, 1.57 as printed",
        alternatives=("π/2 for 1.57",),
        because="all angles lie between -π and π; π/2 would move the tool by less than 1 mm",
    ),
    Assumption(
        what="what is said of an arm of six joints",
        where="sections IV and V",
        chosen="the norm of the joints' norms and jumps, the greatest of their greatest jerks, the "
        "sum of their squared jerks and reversals, run by run; then the median of the runs",
        alternatives=("every joint by itself", "the mean of the runs"),
        because="the sentences speak of the path; means of such runs are led by a few bad ones",
    ),
    Assumption(
        what="slightly varied initial conditions",
        where="section V",
        chosen="all start angles 0.01 rad larger",
        alternatives=("one joint", "other sizes"),
        because="no size is printed; ten times the printed resolution",
    ),
    Assumption(
        what="how fast a search is",
        where="abstract and section V",
        chosen="evaluations of the fitness until a target that both methods reach",
        alternatives=("seconds of some computer",),
        because="seconds depend on program and machine, and none are printed",
    ),
)

ERRATA = (
    Erratum(
        where="the second Table IV, column θ",
        printed="q_1 in all six rows",
        used="q_1 to q_6",
        because="every joint has its own angle; the column is not used otherwise",
    ),
    Erratum(
        where="number of the table of link parameters",
        printed="Table IV a second time, after the pseudo-code of GA",
        used="the second Table IV is the one with numbers",
        because="both carry the number IV",
    ),
    Erratum(
        where="Eqs. (4) and (9)",
        printed="t_final",
        used="t_1 - t_0, and time counted from t_0",
        because="Tables I and II have ΔT = t_1 - t_0; with powers of t the coefficients hold only "
        "for t_0 = 0",
    ),
    Erratum(
        where="Tables I to IV",
        printed="M points, at t_0, t_0 + ΔT/M, …, t_0 + ΔT",
        used="M + 1 points",
        because="that series has M + 1 members",
    ),
    Erratum(
        where="Table II, step 1",
        printed="cubic coefficients",
        used="quintic",
        because="the step gives six coefficients, those of Eq. (9)",
    ),
    Erratum(
        where="Table III, steps 1 to 5",
        printed="W[j,i] with i for the whale and j for the coefficient, q̂_{j,t} with j for the "
        "instant, f(j,i) with j for the coefficient, and i elsewhere the joint",
        used="one population of six coefficients, and one fitness per whale, for each joint",
        because="the indices change their meaning from step to step and the joint has none in W",
    ),
    Erratum(
        where="Table IV (the first), inputs and step 1",
        printed="WOA parameters; number of generations N_g and number of iterations N; matrix P "
        "of N_w rows, filled as G[j,i] with i up to N_g",
        used="GA parameters; N_g chromosomes, N generations, one matrix",
        because="the block repeats Table III; it also breaks off after step 2",
    ),
    Erratum(
        where="abstract and section III-A",
        printed="conical spiral; operators that encircle, lure and shrink",
        used="logarithmic spiral; encircling, spiral and search",
        because="those are the operators of WOA (Mirjalili & Lewis 2016)",
    ),
)
