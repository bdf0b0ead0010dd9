"""Mousa et al.: what the text says of WOA and GA, with a reading declared before any run.

Where WOA is compared with GA, it is compared with both lineages of GA, in a claim each.
"""

import math
from collections.abc import Callable
from functools import partial

from papers.mousa2023.polynomial_claims import FIRST, PASSED_ON
from papers.mousa2023.protocol import (
    ALGORITHMS,
    CUBIC,
    CUBIC_FIT,
    FIT,
    JOINTS,
    QUINTIC,
    SEPTIC,
    SEPTIC_FIT,
    SHIFT,
    SHIFTED_FIT,
)
from papers.mousa2023.robot import END, START
from repro.model.claims import Sentence
from repro.model.experiment import Experiment
from repro.model.measures.curves import Combination, Effort, PlaceAmong, Sensitivity, Together
from repro.model.measures.measure import Computed, Measure, Reduction
from repro.model.tolerances import Between
from repro.tables.published import Printed

RESOLUTION = 0.001  # rad: the last digit in which most angles of Eqs. (10) and (11) are printed
TRAVEL = math.dist(START, END)  # rad
FOLLOWED = Between(0, 0.01 * TRAVEL)  # within 1 % of the way that the joints go together
HALF = "cost after half of the iterations"
Arm = Callable[..., Together]
LINEAGES = {name: name for name in ALGORITHMS if name != "WOA"} | {"GA": "GA as told"}


def arm_by(
    usual: str,
    algorithm: str,
    quantity: str = "cost",
    combination: Combination = "norm",
    *,
    statistic: str = "",
    of: Experiment = FIT,
) -> Together:
    """Return a statistic, else the usual one, of a quantity of the whole arm over the runs."""
    return Together(
        experiment=of.name,
        problems=JOINTS,
        algorithm=algorithm,
        quantity=quantity,
        combination=combination,
        statistic=statistic or usual,
    )


def ahead(claim: str, where: str, best: Measure, *others: Measure) -> Sentence:
    """Return the claim that one measure is lower than the others."""
    return Sentence(
        claim=claim,
        where=where,
        printed=FIRST,
        measure=PlaceAmong(of=best, others=others),
        accepted=Between(1, 1),
        in_words=True,
    )


def follows(arm: Arm, algorithm: str, of: Experiment, where: str) -> Sentence:
    """Return the claim that an algorithm follows the path of an experiment."""
    return Sentence(
        claim=f"{LINEAGES.get(algorithm, algorithm)} suits a {of.name} (read as: the error of the "
        "six joints together is at most 1 % of their way)",
        where=where,
        printed=Printed("0", "rad"),
        measure=arm(algorithm, "rms error", of=of),
        accepted=FOLLOWED,
        in_words=True,
    )


def _norm_of_cubic() -> float:
    return math.hypot(
        *(
            float(fit.quantity("rms error", path.coefficients)) * math.sqrt(fit.intervals + 1)
            for fit, path in zip(QUINTIC, CUBIC, strict=True)
        )
    )


def _overall(arm: Arm) -> tuple[Sentence, ...]:
    """Return the claims on WOA against all other methods."""
    return (
        ahead(
            "WOA plans the better path of all methods (read as: lowest median norm of WOA, GA, "
            "cubic and quintic)",
            "abstract and section V",
            *(arm(algorithm) for algorithm in ALGORITHMS),
            Computed(how="norm of the cubic", value=_norm_of_cubic),
            Computed(
                how="norm of the quintic",
                value=lambda: math.hypot(*(path.least_cost() for path in QUINTIC)),
            ),
        ),
        Sentence(
            claim="WOA avoids local optima and finds the global one (read as: its best run "
            "follows the desired path to the printed digits of the angles)",
            where="section V",
            printed=Printed("0", "rad"),
            measure=arm("WOA", "rms error", statistic="best"),
            accepted=Between(0, RESOLUTION),
            in_words=True,
        ),
    )


def _followed(arm: Arm) -> tuple[Sentence, ...]:
    """Return the claims on the paths that WOA follows, and on a start that varies."""
    return (
        follows(arm, "WOA", CUBIC_FIT, "abstract and section VI"),
        follows(arm, "WOA", FIT, "abstract and section VI"),
        follows(arm, "WOA", SEPTIC_FIT, "abstract and section VI"),
        ahead(
            "polynomials are limited by how complex the path is, WOA is not (read as: on a septic "
            "path WOA ends below the best polynomial of degree five)",
            "abstract and section VI",
            arm("WOA", of=SEPTIC_FIT),
            Computed(
                how="least norm of any six coefficients",
                value=lambda: math.hypot(*(path.least_cost() for path in SEPTIC)),
            ),
        ),
        ahead(
            "WOA is less sensitive to the initial conditions than a polynomial (read as: a change "
            "of the start angles changes its curves less than the quintic)",
            "section V",
            Sensitivity(
                experiment=FIT.name,
                shifted=SHIFTED_FIT.name,
                problems=JOINTS,
                algorithm="WOA",
                shift=SHIFT,
            ),
            PASSED_ON,
        ),
    )


def _quality(arm: Arm, ga: str, name: str) -> tuple[Sentence, ...]:
    """Return the claims on how well WOA and one lineage of GA fit."""
    return (
        ahead(
            f"WOA is more accurate than {name} (read as: lower median final norm)",
            "abstract",
            arm("WOA"),
            arm(ga),
        ),
        Sentence(
            claim=f"the lowest norms of WOA and {name} are close (read as: within 10 %)",
            where="section V, Fig. 6",
            printed=Printed("0", "%"),
            measure=Reduction(before=arm(ga, statistic="best"), after=arm("WOA", statistic="best")),
            accepted=Between(-10, 10),
            in_words=True,
        ),
        follows(arm, ga, FIT, "section V"),
    )


def _smoothness(arm: Arm, ga: str, name: str) -> tuple[Sentence, ...]:
    """Return the claims on how smooth the curves of WOA and one lineage of GA are."""
    places = "abstract, section IV with Fig. 5, section VI"
    return (
        ahead(
            f"{name} is less smooth than WOA (read as: WOA's median integrated squared jerk is "
            "lower)",
            places,
            arm("WOA", "squared jerk", "sum"),
            arm(ga, "squared jerk", "sum"),
        ),
        ahead(
            f"{name} is less smooth than WOA (read as: WOA's median greatest jerk is lower)",
            places,
            arm("WOA", "peak jerk", "largest"),
            arm(ga, "peak jerk", "largest"),
        ),
        *(
            ahead(
                f"{name} is smoother at the {end} of the path (read as: its median jump of {kind} "
                "from rest is lower), though less smooth elsewhere",
                "abstract",
                arm(ga, f"{word} {kind}"),
                arm("WOA", f"{word} {kind}"),
            )
            for word, end in (("start", "start"), ("end", "finish"))
            for kind in ("velocity", "acceleration")
        ),
        ahead(
            f"the path of {name} is less complex than WOA's (read as: its joints reverse less "
            "often)",
            "abstract and section VI",
            arm(ga, "reversals", "sum"),
            arm("WOA", "reversals", "sum"),
        ),
    )


def _search(arm: Arm, ga: str, name: str) -> tuple[Sentence, ...]:
    """Return the claims on how WOA and one lineage of GA search."""
    fig_6 = "section V, Fig. 6"
    efforts = [
        Effort(experiment=FIT.name, problems=JOINTS, algorithm=algorithm, among=("WOA", ga))
        for algorithm in ("WOA", ga)
    ]
    return (
        ahead(
            f"WOA is faster than {name} (read as: fewer evaluations until both have come to the "
            "worse of their two median final norms)",
            f"abstract and {fig_6}",
            *efforts,
        ),
        ahead(
            f"{name} gets off to a better start (read as: lower median norm after the first "
            "iteration, by which GA has evaluated its start and up to one child per agent)",
            fig_6,
            arm(ga, "cost after 1 iteration"),
            arm("WOA", "cost after 1 iteration"),
        ),
        ahead(
            f"WOA is more stable than {name} (read as: lower standard deviation of the final norm "
            "over the runs)",
            fig_6,
            arm("WOA", statistic="std"),
            arm(ga, statistic="std"),
        ),
        ahead(
            f"WOA is more stable than {name} while it searches (read as: lower standard deviation "
            "over the runs at half of the iterations)",
            fig_6,
            arm("WOA", HALF, statistic="std"),
            arm(ga, HALF, statistic="std"),
        ),
    )


def search_claims(usual: str = "median") -> tuple[Sentence, ...]:
    """Return all claims, `usual` being the statistic of the runs where no sentence names one."""
    arm = partial(arm_by, usual)
    return (
        *_overall(arm),
        *_followed(arm),
        *(
            claim
            for claims in (_quality, _smoothness, _search)
            for ga, name in LINEAGES.items()
            for claim in claims(arm, ga, name)
        ),
    )
