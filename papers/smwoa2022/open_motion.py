"""SMWOA: what the paper leaves open of the motion of the arm."""

from collections.abc import Mapping

from papers.smwoa2022.table_6 import table_6
from repro.model.paper import Alternative, Assumption


def ur5(change: object) -> Mapping[tuple[str, str], object]:
    """Return a change of the problem of the arm."""
    return {("trajectory", "UR5"): change}


MOTION = (
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
        alternatives=(
            Alternative(
                name="durations to 20 s",
                says="0.1 s to 20 s",
                problems=ur5({"durations": (0.1, 20.0)}),
            ),
            Alternative(
                name="durations from 1 s",
                says="1 s to 10 s",
                problems=ur5({"durations": (1.0, 10.0)}),
            ),
        ),
        because="the text is silent; the printed times and the optimum lie well inside",
    ),
    Assumption(
        what="handling of motions that break a limit",
        where="section 4.2, Eq. (28)",
        chosen="any motion that obeys comes before any that does not, and these by excess; last "
        "come durations with which time would run backwards somewhere",
        alternatives=(
            Alternative(
                name="time scaling",
                says="every motion counts with the time at which it just obeys",
                problems=ur5({"handling": "time scaling"}),
            ),
        ),
        because="the text is silent; this rule has no weight to choose",
    ),
    Assumption(
        what="sign of the limits",
        where="Eq. (28)",
        chosen="they hold for the absolute values of velocity and acceleration",
        alternatives=(
            Alternative(
                says="for one direction only, as Eq. (28) is printed",
                untried="the other direction would then have no limit at all",
            ),
        ),
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
        alternatives=(
            Alternative(
                name="at rest",
                says="at rest at both ends, Eq. (20) for time",
                problems=ur5({"ends": "still"}),
            ),
            Alternative(
                name="at rest, natural time",
                says="at rest at both ends, natural spline for time",
                problems=ur5({"ends": "still", "time_ends": "natural"}),
            ),
        ),
        because="Eq. (22) treats both alike; the alternatives have certificates of their own",
    ),
    Assumption(
        what="number of runs, and which of them Table 6 and Figs. 3 and 4 show",
        where="section 4.3",
        chosen="any one run; 30 are made to say how far one run may lie from another",
        alternatives=(
            Alternative(name="best of the runs", says="the best of 30", claims=table_6("best")),
            Alternative(name="mean of the runs", says="the mean of 30", claims=table_6("mean")),
        ),
        because="the text gives no number of runs for the motion",
    ),
)
