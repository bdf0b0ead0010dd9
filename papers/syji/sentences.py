"""SYJI-0035: what the text says about results, and how each statement is measured."""

from collections.abc import Callable
from functools import partial

from papers.syji.misprints import SERVO
from papers.syji.motions import (
    PRINTED,
    READINGS,
    RESTING,
    SEVENTH,
    in_five_seconds,
    least_share_of_speed,
    reversals,
    share_of_limit,
)
from papers.syji.printed import DURATIONS, RESULTS, SAVED, TOTAL, WHOLE
from repro.model.claims import Sentence
from repro.model.measures.measure import Computed, Difference, Reduction, Statistic
from repro.model.tolerances import Between, Percent
from repro.robotics import RestToRestLaw, quintic, septic
from repro.robotics.fastest import fastest_joints
from repro.robotics.fixed_penalties import cheapest
from repro.robotics.rest_to_rest import DERIVATIVES
from repro.tables.published import Printed

SIMULATION = "section 6R robot simulation"

# Declared before any run. The times stand for one run of a search, and are given to four digits.
TIME = Percent(1)
# Table 3 is cut to two decimals, which is less than 0.1 % of any limit.
KEPT = Between(0, 100.1)
WHOLE_LIMIT = Printed("100", "%")  # "satisfied", "smoother": no more than the whole


def found(quantity: str, statistic: str = "mean") -> Statistic:
    """Return the measure of what the one run of the search finds, or a statistic of several."""
    return Statistic(
        experiment="motion",
        problem="SYJI-0035",
        algorithm="WOA",
        statistic=statistic,
        quantity=quantity,
    )


BEFORE = Computed(how="the 5 s of the seventh-order motion", value=lambda: WHOLE.si)


def times(statistic: str = "mean") -> tuple[Sentence, ...]:
    """Return the claims on the times found, by a statistic of the runs."""
    return (
        Sentence(
            claim="the search finds a total time of 2.2999 s",
            where=RESULTS,
            printed=TOTAL,
            measure=found("total", statistic),
            accepted=TIME,
        ),
        *(
            Sentence(
                claim=f"the search finds {printed.text} s for segment {number}",
                where=RESULTS,
                printed=printed,
                measure=found(f"duration {number}", statistic),
                accepted=TIME,
            )
            for number, printed in enumerate(DURATIONS, start=1)
        ),
        *_saved(statistic),
    )


def _saved(statistic: str) -> tuple[Sentence, ...]:
    """Return the claims on the time that is saved."""
    return (
        Sentence(
            claim="that is 2.7001 s less than the seventh-order motion of 5 s",
            where=RESULTS,
            printed=SAVED,
            measure=Difference(before=BEFORE, after=found("total", statistic)),
            accepted=TIME,
        ),
        Sentence(
            claim="the time of each joint is greatly reduced (read as: by a tenth at least; the "
            "printed times differ by 54 %; all joints share the four durations)",
            where=RESULTS,
            printed=Printed("54", "%"),
            measure=Reduction(before=BEFORE, after=found("total", statistic)),
            accepted=Between(10, 100),
            in_words=True,
        ),
        Sentence(
            claim="the running time is the shortest (read as: it is that of the least fitness as "
            "printed, each duration being 0.1 s or more; under the limits see below)",
            where="Conclusion",
            printed=TOTAL,
            measure=Computed(
                how="time of the proved minimum of the fitness as printed",
                value=lambda: cheapest(PRINTED).time,
            ),
            accepted=TIME,
        ),
    )


SHORTEST = {
    "at rest at each position of Table 4": lambda: float(RESTING.shortest().sum()),
    "with one polynomial from start to end": lambda: float(SEVENTH.shortest().sum()),
    "with any curve whatever that is at rest at the ends": lambda: max(fastest_joints(RESTING)),
}
TIMES_UNDER_LIMITS = tuple(
    Sentence(
        claim=f"2.7001 s are saved under the same limits, {reading}",
        where=RESULTS,
        printed=SAVED,
        measure=Difference(
            before=BEFORE,
            after=Computed(how=f"the least time that obeys Table 3, {reading}", value=shortest),
        ),
        accepted=TIME,
    )
    for reading, shortest in SHORTEST.items()
)

LIMITS = (
    *(
        Sentence(
            claim=f"the {kind} limits are satisfied, {reading}",
            where="Conclusion",
            printed=WHOLE_LIMIT,
            measure=Computed(
                how=f"largest {kind} with the printed durations, {reading}, in percent of its "
                "limit in Table 3",
                value=partial(share_of_limit, motion, derivative),
            ),
            accepted=KEPT,
            in_words=True,
        )
        for reading, motion in READINGS.items()
        for derivative, kind in DERIVATIVES.items()
    ),
    Sentence(
        claim="the velocity limits are satisfied, with any curve whatever that meets Table 4 at "
        "the printed times",
        where="Conclusion",
        printed=WHOLE_LIMIT,
        measure=Computed(
            how="largest average velocity in a segment, in percent of its limit in Table 3",
            value=least_share_of_speed,
        ),
        accepted=KEPT,
        in_words=True,
    ),
    *(
        Sentence(
            claim=f"the seventh-order motion of 5 s is under the same {kind} limits",
            where=RESULTS,
            printed=WHOLE_LIMIT,
            measure=Computed(
                how=f"largest {kind} of the 5 s motion in percent of its limit in Table 3",
                value=partial(share_of_limit, in_five_seconds, derivative),
            ),
            accepted=KEPT,
            in_words=True,
        )
        for derivative, kind in DERIVATIVES.items()
    ),
)


def ratio(of_law: Callable[[RestToRestLaw], float]) -> float:
    """Return what the seventh order has, in percent of what the fifth has."""
    return 100 * of_law(septic) / of_law(quintic)


def jump_of_jerk(law: RestToRestLaw) -> float:
    """Return by how much jerk jumps where the motion starts."""
    return abs(float(law.polynomial.deriv(3)(0.0)))


SMOOTHNESS = {
    "lower greatest jerk": lambda law: law.peak_factor(3),
    "smaller jump of jerk at start and end": jump_of_jerk,
    "lower integral of squared jerk": lambda law: law.squared(3),
}
SMOOTH = (
    *(
        Sentence(
            claim=f"the seventh order is smoother than the fifth (read as: {reading})",
            where=f"abstract, {SIMULATION} and Conclusion",
            printed=WHOLE_LIMIT,
            measure=Computed(
                how=f"{reading}: seventh order in percent of the fifth, same move and time",
                value=partial(ratio, of_law),
            ),
            accepted=Between(0, 100),
            in_words=True,
        )
        for reading, of_law in SMOOTHNESS.items()
    ),
    Sentence(
        claim="greatest velocity, acceleration and jerk of both orders are far below what the "
        "servo drive allows",
        where=SIMULATION,
        printed=WHOLE_LIMIT,
        measure=None,
        accepted=Between(0, 100),
        in_words=True,
        gap=SERVO,
    ),
    *(
        Sentence(
            claim=f"the path is smooth, without shaking (read as: no joint turns back), {reading}",
            where=f"{RESULTS}, Fig. 6",
            printed=Printed("0"),
            measure=Computed(
                how=f"how often a joint turns back with the printed durations, {reading}",
                value=partial(reversals, motion),
            ),
            accepted=Between(0, 0),
            in_words=True,
        )
        for reading, motion in READINGS.items()
    ),
)

SENTENCES = (*SMOOTH, *times(), *TIMES_UNDER_LIMITS, *LIMITS)
