"""Liang et al.: what the paper leaves open."""

from papers.liang2026.experiments import BENCHMARK, MOTION
from papers.liang2026.open_motion import MOTION_OPEN
from papers.liang2026.tool import tool_positions
from repro.model.paper import Alternative, Assumption
from repro.optimisers import HybridWOA, SlimeWOA

BY_EQUATIONS = HybridWOA(leader="per whale", spiral_range="symmetric")


def both(algorithm: str, change: object) -> dict[tuple[str, str], object]:
    """Return a change of an algorithm in both experiments."""
    return {("benchmark", algorithm): change, ("motion", algorithm): change}


_ALGORITHMS = (
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
        alternatives=(
            Alternative(
                name="modified D-H",
                says="modified, as the headings a_{i-1}, α_{i-1} and Eq. (20) say",
                claims=tool_positions("modified"),
            ),
        ),
        because="the standard one comes near the waypoints of Table IV, the modified one does not: "
        "the audit gives both distances in mm",
    ),
    Assumption(
        what="WOA, GWO, PSO and DBO: programs and parameters",
        where="section III-D",
        chosen="the authors' programs with their defaults (PSO: the one of the wolf and whale "
        "toolboxes)",
        alternatives=(
            Alternative(
                name="WOA by its equations",
                says="WOA as its paper's equations say: one random whale for all coordinates, l "
                "uniform in [-1, 1]",
                algorithms=both("WOA", BY_EQUATIONS),
            ),
            Alternative(
                name="WOA by its equations, vectors",
                says="the same, with A and C drawn for every coordinate, as they are vectors there",
                algorithms=both("WOA", BY_EQUATIONS(coefficients="vector")),
            ),
            Alternative(
                name="WOA with one draw",
                says="WOA by its equations, with one r for A and C, which both print",
                algorithms=both(
                    "WOA",
                    SlimeWOA(leader="per whale", spiral_range="symmetric", shared_draw=True),
                ),
            ),
            Alternative(
                name="PSO clipped",
                says="PSO with every particle held in the box",
                algorithms={("benchmark", "PSO"): {"clip": "every particle"}},
            ),
            Alternative(
                says="parameters tuned per function",
                untried="nothing in the text says so, and there is no end of settings",
            ),
        ),
        because="the paper prints the equations of WOA, with l in [-1, 1] and one random whale, "
        "and of the others nothing; it gives no program, and a column of comparison is taken for "
        "the published program",
    ),
    Assumption(
        what="DBO group sizes for 50 beetles",
        where="section III-D",
        chosen="10, 2, 7 and 31, as its authors' program makes them",
        alternatives=(
            Alternative(
                name="DBO in proportion",
                says="in proportion to the 30 that the program is made for: 10, 10, 11, 19",
                algorithms={("benchmark", "DBO"): {"groups": "proportional"}},
            ),
        ),
        because="the program fixes two group ends for a population of 30",
    ),
    Assumption(
        what="course of the Tent map (Eq. 13) over the population",
        where="Eq. (13)",
        chosen="one chain per coordinate, running through the whales, from a uniform start",
        alternatives=(
            Alternative(
                name="Tent chain per whale",
                says="one chain per whale, running through its coordinates",
                algorithms=both("IWOA", {"start": "tent across"}),
            ),
            Alternative(
                name="one Tent chain",
                says="one chain for all",
                algorithms=both("IWOA", {"start": "tent chain"}),
            ),
        ),
        because="with slope 2 a chain of doubles loses one bit a step and stays at 0 after about "
        "53 steps, so one chain for all would put most whales on a corner of the box",
    ),
    Assumption(
        what="what p_t selects (Eq. 16)",
        where="Eq. (16)",
        chosen="encircling or searching with probability p_t, else the spiral",
        alternatives=(
            Alternative(
                name="p_t selects the spiral",
                says="the spiral with probability p_t",
                algorithms=both("IWOA", {"probability_selects": "spiral"}),
            ),
        ),
        because="p_t takes the place of the 0.5 below which WOA encircles",
    ),
    Assumption(
        what="A and C: one number per whale or a vector",
        where="Eqs. (8)-(12)",
        chosen="one number per whale, from independent draws",
        alternatives=(
            Alternative(
                name="vector coefficients",
                says="a fresh number for every coordinate",
                algorithms=both("IWOA", {"coefficients": "vector"}),
            ),
            Alternative(
                name="IWOA with one draw",
                says="one r for both, as they are printed",
                algorithms=both("IWOA", {"shared_draw": True}),
            ),
        ),
        because="they are called vectors, but r is called a number and |A| is compared with 1",
    ),
    Assumption(
        what="random whale of Eqs. (11)-(12) and range of l in Eq. (10)",
        where="Eqs. (10)-(12)",
        chosen="one whale for all coordinates; l uniform in [-1, 1]",
        alternatives=(
            Alternative(
                name="as WOA's program",
                says="as WOA's program: a new whale per coordinate, l from a shrinking range",
                algorithms=both("IWOA", {"leader": "per dimension", "spiral_range": "shrinking"}),
            ),
        ),
        because="the text says so; it concerns IWOA only, the column WOA is the program",
    ),
    Assumption(
        what="share of whales that differential evolution acts on, F and CR",
        where="Eqs. (17)-(18), step 5",
        chosen="the worse half; F = 0.5, CR = 0.9",
        alternatives=(
            Alternative(
                name="evolution of any half",
                says="a random half, drawn anew in every iteration",
                algorithms=both("IWOA", {"evolves": "any"}),
            ),
            Alternative(
                name="evolution of all",
                says="all whales",
                algorithms=both("IWOA", {"differential": 1.0}),
            ),
            Alternative(
                name="least F and CR",
                says="F = 0.4, CR = 0.6, the lower ends of the printed ranges",
                algorithms=both("IWOA", {"scale": 0.4, "crossover": 0.6}),
            ),
            Alternative(
                name="greatest F and CR",
                says="F = 0.9, CR = 0.95, the upper ends of the printed ranges",
                algorithms=both("IWOA", {"scale": 0.9, "crossover": 0.95}),
            ),
        ),
        because="the text says some individuals and prints usual ranges; these are the common "
        "settings inside them",
    ),
    Assumption(
        what="share of whales crossed, partner, size of the Gaussian perturbation",
        where="Eq. (19), step 6",
        chosen="the better half, each with a random other whale, α uniform per pair, standard "
        "deviation 1 % of the box",
        alternatives=(
            Alternative(
                name="crossover of all",
                says="all whales",
                algorithms=both("IWOA", {"genetic": 1.0}),
            ),
            Alternative(
                name="crossover with the best",
                says="the best whale as partner",
                algorithms=both("IWOA", {"partner": "best"}),
            ),
            Alternative(
                name="small perturbation",
                says="0.1 % of the box",
                algorithms=both("IWOA", {"mutation": 0.001}),
            ),
            Alternative(
                name="large perturbation",
                says="10 % of the box",
                algorithms=both("IWOA", {"mutation": 0.1}),
            ),
        ),
        because="the text says some individuals and gives no number",
    ),
    Assumption(
        what="whether a candidate must be better to replace its parent",
        where="steps 5 to 7",
        chosen="yes (greedy)",
        alternatives=(
            Alternative(
                name="not greedy",
                says="it always replaces its parent",
                algorithms=both("IWOA", {"greedy": False}),
            ),
        ),
        because="differential evolution is greedy in its source",
    ),
    Assumption(
        what="chaotic disturbance of the best point",
        where="section III-B 1)",
        chosen="one trial per iteration, one Tent step from a uniform start per coordinate, "
        "amplitude 1 % of the box falling linearly to 0, kept if better",
        alternatives=(
            Alternative(
                name="small disturbance",
                says="0.1 % of the box",
                algorithms=both("IWOA", {"disturbance": 0.001}),
            ),
            Alternative(
                name="large disturbance",
                says="10 % of the box",
                algorithms=both("IWOA", {"disturbance": 0.1}),
            ),
        ),
        because="the text says small and gradually reduced",
    ),
    Assumption(
        what="evaluations",
        where="section III-D",
        chosen="500 iterations for every algorithm, whatever they cost",
        alternatives=(
            Alternative(
                name="equal evaluations",
                says="as many evaluations for every algorithm as WOA spends",
                protocol={
                    "benchmark": {"evaluations": BENCHMARK.population * BENCHMARK.iterations},
                    "motion": {"evaluations": MOTION.population * MOTION.iterations},
                },
            ),
        ),
        because="the paper fixes iterations; the additions make IWOA spend about twice as many "
        "evaluations as the others",
    ),
    Assumption(
        what="coordinates of whales outside the box",
        where="section III-D",
        chosen="they are put on its edge when the whale is next evaluated",
        alternatives=(
            Alternative(
                name="reflection",
                says="they are mirrored at the edge, by IWOA and WOA",
                algorithms=both("IWOA", {"bounds": "reflect"})
                | both("WOA", HybridWOA(bounds="reflect")),
            ),
            Alternative(
                name="new places",
                says="they are drawn anew from the box, by IWOA and WOA",
                algorithms=both("IWOA", {"bounds": "re-initialise"})
                | both("WOA", HybridWOA(bounds="re-initialise")),
            ),
        ),
        because="the text is silent; this is what WOA's program does, and the other columns are "
        "their programs",
    ),
)
ASSUMPTIONS = (*_ALGORITHMS, *MOTION_OPEN)

# Those on which the text is most at odds with itself: it calls A and C vectors, makes p_t take the
# place of WOA's 0.5 without saying of what, and leaves open who evolves.
TOGETHER = ("p_t selects the spiral", "vector coefficients", "evolution of all")
