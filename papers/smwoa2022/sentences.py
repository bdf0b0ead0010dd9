"""SMWOA: what the text says about results, and how each statement is measured."""

from collections.abc import Mapping
from functools import partial

import numpy as np

from papers.smwoa2022.experiments import (
    BENCHMARK,
    FIXED,
    MULTIMODAL,
    UNIMODAL,
    UR5,
    F,
    contest,
)
from papers.smwoa2022.misprints import UNOPTIMISED
from papers.smwoa2022.printed import AFTER, BEFORE, TABLE_6, TIME_SAVED
from papers.smwoa2022.table_6 import TIME
from repro.model.claims import Sentence, ranked
from repro.model.measures.measure import Computed, Measure, Rank, Reduction, Statistic
from repro.model.measures.ranks import ContestPlace, Firsts, RankSum
from repro.model.tolerances import Absolute, Between
from repro.robotics.spline_motion import motion
from repro.tables.published import Printed

TEXT = "section 3.3"
FIGURE_3 = "section 4.3, Fig. 3"
FIGURE_4 = "section 4.3, Fig. 4"
WHOLE_LIMIT = Printed("100", "%")
FIRST = Printed("1", "rank")
FIRST_PLACES = Printed("9")  # functions that the text says SMWOA is first on


def printed_durations(algorithm: str) -> tuple[float, ...]:
    """Return the durations of the five segments that Table 6 prints, in s."""
    return tuple(TABLE_6[algorithm, f"h{k}"].si for k in range(1, 6))


def found(quantity: str, algorithm: str = "SMWOA", statistic: str = "single") -> Statistic:
    """Return the measure of what an algorithm finds for the UR5."""
    return Statistic(
        experiment="trajectory",
        problem="UR5",
        algorithm=algorithm,
        statistic=statistic,
        quantity=quantity,
    )


def places(printed: Mapping[str, int]) -> tuple[Sentence, ...]:
    """Return the claims on the place of SMWOA by the average on each function."""
    return ranked(
        contest(*F),
        algorithm="SMWOA",
        places=printed,
        claim="SMWOA ranked by average",
        where=TEXT,
    )


def strength(claim: str, functions: tuple[str, ...]) -> Sentence:
    """Return a claim that is read as: SMWOA has the lowest mean rank over the functions."""
    return Sentence(
        claim=f"{claim} (read as: the lowest mean rank over {', '.join(functions)})",
        where=TEXT,
        printed=FIRST,
        measure=ContestPlace(contest=contest(*functions), algorithm="SMWOA"),
        accepted=Between(1, 1),
        in_words=True,
    )


FUNCTIONS = (
    Sentence(
        claim="SMWOA is clearly more accurate than the other algorithms on the 15 functions (read "
        "as: it is first, or shares that place, on more than half of them)",
        where="abstract and section 3.3",
        printed=FIRST_PLACES,
        measure=Firsts(contest=contest(*F), algorithm="SMWOA"),
        accepted=Between(8, 15),
        in_words=True,
    ),
    *places({"F1": 1, "F2": 1, "F3": 1, "F5": 1}),
    Sentence(
        claim="SMWOA is not first on F4 by average (Table 3: second)",
        where=TEXT,
        printed=Printed("2", "rank"),
        measure=Rank(
            of=Statistic(
                experiment=BENCHMARK.name, problem="F4", algorithm="SMWOA", statistic="mean"
            ),
            among=tuple(BENCHMARK.algorithms),
        ),
        accepted=Between(2, 6),
        in_words=True,
    ),
    *places({"F7": 1, "F8": 1, "F10": 1, "F6": 2, "F9": 2}),
    *places({"F13": 1, "F15": 1, "F11": 2, "F12": 2, "F14": 2}),
    strength("SMWOA exploits strongly", UNIMODAL),
    strength("SMWOA explores strongly", MULTIMODAL),
    strength("SMWOA can leave local optima", FIXED),
    strength("SMWOA performs best of the six algorithms over all", F),
    Sentence(
        claim="some results of SMWOA are not ideal (read as: it is not first on every function)",
        where=TEXT,
        printed=FIRST_PLACES,
        measure=Firsts(contest=contest(*F), algorithm="SMWOA"),
        accepted=Between(0, 14),
        in_words=True,
    ),
    *(
        Sentence(
            claim=f"the rank-sum test marks SMWOA as better than {other} (+, read as 1: lower "
            "costs at the 5 % level, all runs on all functions together)",
            where="Table 3, p/h",
            printed=Printed("+1"),
            measure=RankSum(
                experiment=BENCHMARK.name,
                problems=F,
                algorithm="SMWOA",
                against=other,
                sign=True,
            ),
            accepted=Between(1, 1),
            in_words=True,
        )
        for other in tuple(BENCHMARK.algorithms)[1:]
    ),
)

BEFORE_OPTIMISATION = Computed(
    how="the time before optimisation as printed", value=lambda: BEFORE.si
)
TIMES = (
    Sentence(
        claim="before optimisation the motion takes 39.526 s",
        where=FIGURE_3,
        printed=BEFORE,
        measure=None,
        accepted=TIME,
        gap=UNOPTIMISED,
    ),
    Sentence(
        claim="after optimisation by SMWOA the motion takes 24.635 s",
        where=FIGURE_3,
        printed=AFTER,
        measure=found("total"),
        accepted=TIME,
    ),
    Sentence(
        claim="SMWOA takes 37.674 % less time than the motion before optimisation",
        where="abstract and section 4.3",
        printed=TIME_SAVED,
        measure=Reduction(before=BEFORE_OPTIMISATION, after=found("total")),
        accepted=Absolute(0.5),
    ),
    Sentence(
        claim="the efficiency of the joints' motion is improved (read as: SMWOA takes less time "
        "than the 39.526 s before)",
        where="abstract and section 4.3",
        printed=TIME_SAVED,
        measure=Reduction(before=BEFORE_OPTIMISATION, after=found("total")),
        accepted=Between(0, 100),
        in_words=True,
    ),
    Sentence(
        claim="SMWOA plans the motion better than SMA and WOA (read as: the lowest mean total "
        "time)",
        where="sections 4.3 and 5, Table 6",
        printed=FIRST,
        measure=Rank(of=found("total", statistic="mean"), among=("SMA", "WOA", "SMWOA")),
        accepted=Between(1, 1),
        in_words=True,
    ),
)


def share(algorithm: str, kind: str) -> float:
    """Return the peak of the printed motion of an algorithm, in percent of its limit."""
    return float(UR5.quantity(f"{kind} share", np.array(printed_durations(algorithm))))


def speed_at_ends(algorithm: str) -> float:
    """Return how fast the fastest joint of a printed motion is at its start or end, in rad/s."""
    return float(UR5.quantity("speed at the ends", np.array(printed_durations(algorithm))))


def spikes_of_jerk(joint: int) -> float:
    """Return in how many stretches of SMWOA's printed motion |jerk| exceeds half of its peak."""
    _, jerk = motion(UR5, np.array(printed_durations("SMWOA")), derivative=3, samples=1001)
    size = np.abs(jerk[:, joint - 1])
    high = np.concatenate([[False], size > 0.5 * size.max()])
    return float((~high[:-1] & high[1:]).sum())


AS_PRINTED = "with the printed durations of SMWOA"
AS_FOUND = "with those that SMWOA finds here"
AT_ENDS: Mapping[str, Measure] = {
    AS_PRINTED: Computed(
        how="speed of the fastest joint at the ends, durations of SMWOA in Table 6",
        value=partial(speed_at_ends, "SMWOA"),
    ),
    AS_FOUND: found("speed at the ends"),
}
ACCELERATIONS: Mapping[str, Measure] = {
    AS_PRINTED: Computed(
        how="greatest acceleration of any joint in percent of its limit, durations of SMWOA in "
        "Table 6",
        value=partial(share, "SMWOA", "acceleration"),
    ),
    AS_FOUND: found("acceleration share"),
}
LIMITS = (
    *(
        Sentence(
            claim=f"the motion of {algorithm} with its printed durations keeps every {kind} limit "
            "of Table 5, Eq. (28)",
            where="section 4.3, Tables 5 and 6",
            printed=WHOLE_LIMIT,
            measure=Computed(
                how=f"greatest {kind} of any joint along the B-spline through Table 4 with the "
                f"durations of {algorithm} in Table 6, in percent of its limit",
                value=partial(share, algorithm, kind),
            ),
            accepted=Between(0, 100),
            in_words=True,
        )
        for algorithm in TABLE_6.row_names
        for kind in ("velocity", "acceleration")
    ),
    *(
        Sentence(
            claim=f"the optimised motion starts and ends at rest (not stated; a whole motion "
            f"should, and Eq. (20) is its only end condition), {reading}",
            where="sections 4.1 and 4.3",
            printed=Printed("0.0", "deg/s"),
            measure=measure,
            accepted=Absolute(0),
            in_words=True,
        )
        for reading, measure in AT_ENDS.items()
    ),
)
SMOOTHNESS = (
    *(
        Sentence(
            claim=f"velocity and acceleration are gentle and steady after optimisation (read as: "
            f"the greatest acceleration is below half of its limit), {reading}",
            where=FIGURE_4,
            printed=Printed("50", "%"),
            measure=measure,
            accepted=Between(0, 50),
            in_words=True,
        )
        for reading, measure in ACCELERATIONS.items()
    ),
    *(
        Sentence(
            claim=f"the jerk of joint {joint} has one cusp and is otherwise smooth (read as: it "
            "exceeds half of its peak in one stretch of time only)",
            where=FIGURE_4,
            printed=Printed("1"),
            measure=Computed(
                how=f"stretches in which the jerk of joint {joint} exceeds half of its peak, 1001 "
                "instants per segment, durations of SMWOA in Table 6",
                value=partial(spikes_of_jerk, joint),
            ),
            accepted=Between(1, 1),
            in_words=True,
        )
        for joint in (1, 2, 4, 6)
    ),
)

SENTENCES = (*FUNCTIONS, *TIMES, *LIMITS, *SMOOTHNESS)
