"""SMWOA: what the paper leaves open of the algorithm and of its tests."""

from collections.abc import Mapping
from dataclasses import replace

from papers.smwoa2022.experiments import FUNCTION_OF
from papers.smwoa2022.open_motion import MOTION
from papers.smwoa2022.table_3 import probabilities, ranking
from repro.functions import FUNCTIONS
from repro.model.paper import Alternative, Assumption
from repro.optimisers import SlimeWOA

BY_EQUATIONS = SlimeWOA(leader="per whale", spiral_range="symmetric")
BY_VECTORS = replace(BY_EQUATIONS, coefficients="vector")


def both(change: object) -> Mapping[tuple[str, str], object]:
    """Return a change of SMWOA in both experiments."""
    return {("benchmark", "SMWOA"): change, ("trajectory", "SMWOA"): change}


_ALGORITHM = (
    Assumption(
        what="whether SMA's restart (z) and its contraction by v_c survive in SMWOA",
        where="Eqs. (8) and (12)-(14), Fig. 1",
        chosen="no",
        alternatives=(
            Alternative(
                name="restart",
                says="the restart with z = 0.03, as in SMA's program",
                algorithms=both({"restart": 0.03}),
            ),
            Alternative(
                says="the contraction by v_c",
                untried="in none of the three moves of section 3 is there a place for it",
            ),
        ),
        because="section 3 describes three moves, Eqs. (12) to (14), and no other",
    ),
    Assumption(
        what="A and D: whether both have the same r_rand, and whether it is a vector",
        where="Eqs. (4) and (15)",
        chosen="one number per whale each, from independent draws",
        alternatives=(
            Alternative(
                name="one draw for A and D",
                says="one draw for both",
                algorithms=both({"shared_draw": True}),
            ),
            Alternative(
                name="vector coefficients",
                says="a fresh number for every coordinate",
                algorithms=both({"coefficients": "vector"}),
            ),
        ),
        because="r_rand is called a vector, but |A| is compared with 1; WOA's program draws so",
    ),
    Assumption(
        what="v_b: a number or a vector, and how it is drawn",
        where="Eqs. (8), (10) and (13)",
        chosen="a fresh number for every coordinate, uniform in [-a, a]",
        alternatives=(
            Alternative(
                name="v_b per whale",
                says="one number per whale",
                algorithms=both({"swing": "per whale"}),
            ),
        ),
        because="it is called a vector; SMA's program draws so",
    ),
    Assumption(
        what="whose weight ω stands in Eqs. (13) and (14), and whether it is a vector",
        where="Eqs. (11) and (15)",
        chosen="that of the whale that moves, with a fresh r for every coordinate",
        alternatives=(
            Alternative(
                name="weight of the leader",
                says="that of the whale it multiplies (1 for the best)",
                algorithms=both({"weight": "of the leader"}),
            ),
            Alternative(
                name="weight per whale",
                says="one r per whale",
                algorithms=both({"weights": "per whale"}),
            ),
        ),
        because="in SMA's program a mould multiplies another's position by its own weight",
    ),
    Assumption(
        what="logarithm of the weight, and the weight where all costs are equal",
        where="Eq. (11)",
        chosen="decimal; 1 where Eq. (11) is 0/0",
        alternatives=(
            Alternative(
                name="natural logarithm", says="natural", algorithms=both({"logarithm": "natural"})
            ),
        ),
        because="SMA's program takes the decimal one",
    ),
    Assumption(
        what="random whale X^r, range of l, shape b of the spiral, probability P",
        where="Eqs. (5) to (7), (13) and (14)",
        chosen="one whale for all coordinates; l uniform in [-1, 1]; b = 1; P uniform in [0, 1], "
        "drawn per whale",
        alternatives=(
            Alternative(
                name="as WOA's program",
                says="as WOA's program: a new whale per coordinate, l from a shrinking range",
                algorithms=both({"leader": "per dimension", "spiral_range": "shrinking"}),
            ),
        ),
        because="the text says so but for b, which is WOA's; it concerns SMWOA only",
    ),
    Assumption(
        what="order of moves, bounds, and whether a move must be better to be kept",
        where="section 3.1, Fig. 1",
        chosen="whales move one after another, every move is kept, and a whale outside the box is "
        "put on its edge when it is next evaluated",
        alternatives=(
            Alternative(
                name="moves at once", says="all at once", algorithms=both({"moves": "at once"})
            ),
            Alternative(
                name="greedy", says="only better moves are kept", algorithms=both({"greedy": True})
            ),
            Alternative(
                name="reflection",
                says="coordinates outside the box are mirrored at its edge",
                algorithms=both({"bounds": "reflect"}),
            ),
            Alternative(
                name="new places",
                says="coordinates outside the box are drawn anew, as GSA's program does",
                algorithms=both({"bounds": "re-initialise"}),
            ),
        ),
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
        alternatives=(
            Alternative(
                name="WOA by its equations",
                says="WOA as its paper's equations say: one random whale for all coordinates, l "
                "uniform in [-1, 1]",
                algorithms={
                    ("benchmark", "WOA"): BY_EQUATIONS,
                    ("trajectory", "WOA"): BY_EQUATIONS,
                },
            ),
            Alternative(
                name="WOA by its equations, vectors",
                says="the same, with A and C drawn for every coordinate, as r_rand is a vector",
                algorithms={
                    ("benchmark", "WOA"): BY_VECTORS,
                    ("trajectory", "WOA"): BY_VECTORS,
                },
            ),
            Alternative(
                name="SMA with a falling v_c",
                says="SMA with v_c itself falling from 1 to 0, as is printed below Eq. (8)",
                algorithms={
                    ("benchmark", "SMA"): {"contraction": "falling"},
                    ("trajectory", "SMA"): {"contraction": "falling"},
                },
            ),
            Alternative(
                name="PSO clipped",
                says="PSO with every particle held in the box",
                algorithms={("benchmark", "PSO"): {"clip": "every particle"}},
            ),
            Alternative(
                name="GSA clipped",
                says="GSA with coordinates outside the box put on its edge",
                algorithms={("benchmark", "GSA"): {"bounds": "clip"}},
            ),
            Alternative(
                name="DE with usual constants",
                says="DE with F = 0.5 and CR = 0.9",
                algorithms={("benchmark", "DE"): {"scale": (0.5, 0.5), "crossover": 0.9}},
            ),
            Alternative(
                says="parameters tuned per function",
                untried="nothing in the text says so, and there is no end of settings",
            ),
        ),
        because="the paper prints the equations of WOA and, but for z, of SMA, and of the others "
        "nothing; it gives no program, and a column of comparison is taken for the published "
        "program",
    ),
    Assumption(
        what="dimension of F8",
        where="Table 2",
        chosen="30",
        alternatives=(
            Alternative(
                name="F8 of two dimensions",
                says="2, as most of the last five functions",
                problems={("benchmark", "F8"): FUNCTION_OF["Alpine"].problem(2)},
            ),
        ),
        because="the cell is empty; F8 is listed among the multimodal functions of 30 dimensions",
    ),
    Assumption(
        what="box of F12",
        where="Table 2",
        chosen="[-5, 5] for both coordinates, as printed",
        alternatives=(
            Alternative(
                name="usual box of F12",
                says="[-5, 10] for the first and [0, 15] for the second, as usual",
                problems={("benchmark", "F12"): FUNCTIONS["branin"].problem()},
            ),
        ),
        because="the printed box holds one of the three minimisers, so the optimum is the same",
    ),
    Assumption(
        what="constants of F11, F14 and F15",
        where="Table 2",
        chosen="those of Yao, Liu & Lin 1999",
        alternatives=(
            Alternative(
                says="other libraries' roundings",
                untried="they change the optima in digits that Table 3 does not print",
            ),
        ),
        because="none are printed; the names and optima are those of that set",
    ),
    Assumption(
        what="standard deviation",
        where="Table 3",
        chosen="divided by n - 1",
        alternatives=(
            Alternative(says="divided by n", untried="it is 1.7 % less, far within the tolerance"),
        ),
        because="the paper used MATLAB, whose std does so",
    ),
    Assumption(
        what="what the one p-value per algorithm is a test of",
        where="Table 3, p/h",
        chosen="rank-sum of all runs on all 15 functions together, 450 costs against 450",
        alternatives=(
            Alternative(
                name="mean of p-values",
                says="the mean of 15 p-values, one per function",
                claims=probabilities("each problem"),
            ),
            Alternative(
                name="test of averages",
                says="the 15 averages of one algorithm against those of the other",
                claims=probabilities("averages"),
            ),
        ),
        because="the text names the test and not its samples; the printed averages themselves give "
        "0.005 to 0.7, far from the printed values",
    ),
    Assumption(
        what="how algorithms are ranked",
        where="Table 3, average ranking",
        chosen="by the average on each function, the lowest first; ties share the mean of their "
        "places",
        alternatives=(
            Alternative(
                name="ranked by deviation", says="by the standard deviation", claims=ranking("std")
            ),
        ),
        because="so ranked, the printed averages give four of the six printed average ranks",
    ),
)
ASSUMPTIONS = (*_ALGORITHM, *_BENCHMARK, *MOTION)
# Those on which the text is most at odds with itself: r_rand and v_b are called vectors, one being
# compared with a number, and it is not said whose weight is meant.
TOGETHER = ("vector coefficients", "v_b per whale", "weight of the leader")
