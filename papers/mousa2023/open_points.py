"""Mousa et al.: what the paper leaves open."""

from collections.abc import Mapping

from papers.mousa2023.protocol import EXPERIMENTS, FIT, paths
from papers.mousa2023.search_claims import search_claims
from repro.model.paper import Alternative, Assumption
from repro.optimisers import HybridWOA
from repro.robotics import cubic

BY_EQUATIONS = HybridWOA(leader="per whale", spiral_range="symmetric")
BY_VECTORS = BY_EQUATIONS(coefficients="vector")
REFLECTED, ANEW = HybridWOA(bounds="reflect"), HybridWOA(bounds="re-initialise")


def every(**fields: object) -> Mapping[tuple[str, str], object]:
    """Return a change of every problem of every experiment."""
    return {(e.name, problem): fields for e in EXPERIMENTS for problem in e.problems}


def bounded(coefficient: float) -> Mapping[tuple[str, str], object]:
    """Return the change to |a_j| T^j of at most `coefficient` rad."""
    return every(box=((-coefficient, coefficient),) * 6)


ASSUMPTIONS = (
    Assumption(
        what="desired path that is fitted",
        where="Tables III and IV, step 2: a polynomial fitted to the start and the end angle",
        chosen="the quintic of Eq. (9)",
        alternatives=(
            Alternative(
                name="cubic path",
                says="the cubic of Eq. (4), which is an experiment of its own too",
                problems={(FIT.name, joint): path for joint, path in paths(cubic).items()},
            ),
            Alternative(
                says="a straight line",
                untried="its speed jumps at both ends, and the output is called a polynomial of "
                "fifth degree",
            ),
        ),
        because="the output is called a polynomial of fifth degree; two angles alone fix no curve",
    ),
    Assumption(
        what="fitness",
        where="Table III, step 4",
        chosen="Euclidean norm of the difference of the angles at all instants, joint by joint",
        alternatives=(
            Alternative(
                says="root of the mean square",
                untried="it is the norm divided by a constant: the same order of all curves",
            ),
            Alternative(
                says="length of the path and energy, which section III-B names of GA",
                untried="neither is defined or printed, and the steps of Tables III and IV have "
                "the norm alone",
            ),
            Alternative(
                says="greatest difference",
                untried="norm of a vector means another one, and no word of the text says so",
            ),
        ),
        because="norm of a vector means so in MATLAB, which the authors used",
    ),
    Assumption(
        what="what one search chooses",
        where="Table III, steps 1 and 5",
        chosen="the six coefficients of one joint; six searches make a path of the arm",
        alternatives=(
            Alternative(
                says="all 36 coefficients in one search",
                untried="there would be no best whale per joint, which Table III has",
            ),
        ),
        because="the best whale and its fitness carry the index of the joint",
    ),
    Assumption(
        what="duration of the motion",
        where="sections II and IV",
        chosen="2 s, from t = 0",
        alternatives=(
            Alternative(
                says="any other",
                untried="the bounds below make the fits the same for every duration",
            ),
        ),
        because="none is printed; the copy keeps a 2 from a time axis of Fig. 2. Bounds below are "
        "such that the fits are the same for every duration; it only scales the derivatives. From "
        "0.56 s on the quintic keeps the speeds and accelerations of the real arm",
    ),
    Assumption(
        what="bounds of the coefficients",
        where="Tables III and IV, inputs",
        chosen="|a_j| T^j at most 50 rad for every coefficient and joint",
        alternatives=(
            Alternative(
                name="narrow bounds",
                says="at most 32 rad, which is a narrow box about Eq. (9)",
                problems=bounded(32.0),
            ),
            Alternative(name="wide bounds", says="at most 500 rad", problems=bounded(500.0)),
            Alternative(says="joint ranges for a_0", untried="they bound one coefficient of six"),
        ),
        because="none are printed; a round number with room for all joints (the largest is 30; on "
        "the septic path the best would be 64, and with 50 the error is still 0.3 % of the way)",
    ),
    Assumption(
        what="number of points M",
        where="Tables I to IV",
        chosen="100 intervals, 101 instants with both ends",
        alternatives=(
            Alternative(name="50 intervals", says="50 intervals", problems=every(intervals=50)),
            Alternative(name="200 intervals", says="200 intervals", problems=every(intervals=200)),
        ),
        because="none is printed; M scales the norm by about its root and nothing else",
    ),
    Assumption(
        what="population, iterations and runs",
        where="Tables III and IV, section IV",
        chosen="30 whales or chromosomes, 500 iterations, 30 runs",
        alternatives=(
            Alternative(
                name="population of 50",
                says="50 whales or chromosomes",
                protocol={experiment.name: {"population": 50} for experiment in EXPERIMENTS},
            ),
            Alternative(
                name="1000 iterations",
                says="1000 iterations",
                protocol={experiment.name: {"iterations": 1000} for experiment in EXPERIMENTS},
            ),
            Alternative(
                says="one run, as the figures seem to show", untried="each of the 30 is such a run"
            ),
        ),
        because="none are printed; those of the authors of WOA, and runs enough to see the spread",
    ),
    Assumption(
        what="program and parameters of WOA",
        where="Table III",
        chosen="its authors' program, b = 1",
        alternatives=(
            Alternative(
                name="WOA by its equations",
                says="WOA as its paper's equations say: one random whale for all coordinates, l "
                "uniform in [-1, 1]",
                algorithms={(experiment.name, "WOA"): BY_EQUATIONS for experiment in EXPERIMENTS},
            ),
            Alternative(
                name="WOA by its equations, vectors",
                says="the same, with A and C drawn for every coordinate, as they are vectors there",
                algorithms={(experiment.name, "WOA"): BY_VECTORS for experiment in EXPERIMENTS},
            ),
            Alternative(
                name="reflection",
                says="the program, with coefficients outside their range mirrored at its edge "
                "instead of put on it",
                algorithms={(experiment.name, "WOA"): REFLECTED for experiment in EXPERIMENTS},
            ),
            Alternative(
                name="new places",
                says="the program, with coefficients outside their range drawn anew",
                algorithms={(experiment.name, "WOA"): ANEW for experiment in EXPERIMENTS},
            ),
        ),
        because="Table III has no step that moves a whale or brings one back",
    ),
    Assumption(
        what="lineage of GA",
        where="section III-B, Table IV",
        chosen="as section III-B tells of random parents: each gene is that of the one or the "
        "other, a child replaces an agent only where it is better (rate 80 %), an agent is drawn "
        "anew whatever its cost (rate 1 %)",
        alternatives=(
            Alternative(
                says="by generations: roulette on rank, blend, two elites",
                untried="it is run and judged as well, in claims of its own",
            ),
            Alternative(
                name="GA with blended genes",
                says="as told, with genes blended",
                algorithms={
                    (experiment.name, "GA"): {"mixing": "blend"} for experiment in EXPERIMENTS
                },
            ),
            Alternative(
                name="GA with one-point crossover",
                says="one-point crossover",
                algorithms={
                    (experiment.name, "GA"): {"mixing": "one point"} for experiment in EXPERIMENTS
                },
            ),
        ),
        because="section III-B tells of random parents and also of selecting the best paths; how "
        "a child comes of its parents is not on the copy, which has lost the end of Table IV. The "
        "two rates are those of MATLAB's program, which the authors may have used. The lineage "
        "decides: GA that blends "
        "is well ahead of WOA, GA that exchanges genes about equal to it. The one as told was "
        "added when runs of the other had shown this",
    ),
    Assumption(
        what="ranges of angle, velocity and acceleration in a search",
        where="Tables III and IV, inputs",
        chosen="not used",
        alternatives=(
            Alternative(
                says="rejection of curves that leave them",
                untried="no values of the ranges are printed",
            ),
        ),
        because="they are listed as inputs without values; that paths satisfy the constraints, as "
        "section III-B says, no step of the tables that are left ensures",
    ),
    Assumption(
        what="Denavit-Hartenberg convention",
        where="the second Table IV",
        chosen="standard",
        alternatives=(Alternative(says="modified", untried="no claim rests on a pose"),),
        because="no pose is printed to compare with. The modified one puts the axes of joints 5 "
        "and 6 on one line, so that the arm has five degrees of freedom at both postures; the "
        "standard one has six and meets the chain of the real arm in every posture",
    ),
    Assumption(
        what="what the start and end angles are",
        where="Eqs. (10) and (11)",
        chosen="both readings are checked; the fits need neither",
        alternatives=(
            Alternative(
                says="angles A1 to A6 of the real arm",
                untried="both readings are checked, and the fits need neither",
            ),
            Alternative(says="joint angles θ of Table IV", untried="as above"),
        ),
        because="as A1 to A6 they lie in its ranges (github kroshu/kuka_robot_descriptions, "
        "kr4_r600_macro.xacro) and the tool is 0.91 m and 0.95 m high; as θ the tool is 1 mm and "
        "3 mm above the base plane, but A2 is 59° beyond its range and the elbow stands 44 mm "
        "above that plane and within 50 mm of the axis of joint 1: in the base",
    ),
    Assumption(
        what="unit of the angles, α printed as 1.57",
        where="Eqs. (10) and (11), the second Table IV",
        chosen="radians, 1.57 as printed",
        alternatives=(Alternative(says="π/2 for 1.57", untried="no claim rests on it"),),
        because="all angles lie between -π and π; π/2 would move the tool by less than 1 mm",
    ),
    Assumption(
        what="what is said of an arm of six joints",
        where="sections IV and V",
        chosen="the norm of the joints' norms and jumps, the greatest of their greatest jerks, "
        "the sum of their squared jerks and reversals, run by run; then the median of the runs",
        alternatives=(
            Alternative(
                says="every joint by itself",
                untried="the sentences speak of the path, not of joints",
            ),
            Alternative(
                name="means of the runs", says="the mean of the runs", claims=search_claims("mean")
            ),
        ),
        because="the sentences speak of the path; means of such runs are led by a few bad ones",
    ),
    Assumption(
        what="slightly varied initial conditions",
        where="section V",
        chosen="all start angles 0.01 rad larger",
        alternatives=(
            Alternative(
                says="one joint",
                untried="a change is passed on joint by joint, so that it is part of the chosen "
                "one",
            ),
            Alternative(says="other sizes", untried="the measure divides by the size"),
        ),
        because="no size is printed; ten times the printed resolution",
    ),
    Assumption(
        what="how fast a search is",
        where="abstract and section V",
        chosen="evaluations of the fitness until a target that both methods reach",
        alternatives=(
            Alternative(
                says="seconds of some computer",
                untried="none are printed, and they would be those of another computer",
            ),
        ),
        because="seconds depend on program and machine, and none are printed",
    ),
)

# The lineage of GA decides most claims, and the bounds set how hard the search is.
TOGETHER = ("GA with blended genes", "narrow bounds", "WOA by its equations")
