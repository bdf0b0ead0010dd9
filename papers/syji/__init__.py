"""SYJI-0035 arm: seventh-order polynomials in four segments, timed by whale optimisation."""

from functools import partial

from papers.syji.motions import ORDERS, PRINTED, RESTING, SEVENTH
from papers.syji.open_points import ASSUMPTIONS, ERRATA, SERVO
from papers.syji.printed import TABLE_1, TABLE_2, TABLE_3, TABLE_4, WHOLE
from papers.syji.relations import RELATIONS
from papers.syji.sentences import SENTENCES
from repro.claims import computed_cells
from repro.figures import Convergence, Motion, ToolPath
from repro.measures import Computed
from repro.model import Experiment, Paper, Reading, Source
from repro.optimisers import WOA
from repro.robotics import dh_rows
from repro.robotics.rest_to_rest import MinimumTime, peaks
from repro.verdict import RoundedOrCut

MOTION = Experiment(
    name="motion",
    where="section Simulation parameter settings, item 4",
    proposed="WOA",
    problems={"SYJI-0035": PRINTED},
    algorithms={"WOA": WOA(b=1)},
    population=50,
    iterations=200,
    runs=1,
)
DERIVATIVES = {"Maximum velocity": 1, "Maximum acceleration": 2, "Maximum Jerk": 3}


def greatest(joint: str, column: str) -> Computed:
    """Return the measure of one cell of Table 2: the closed-form peak of a joint in 5 s."""
    kind, _, order = column.rpartition(" ")
    derivative = DERIVATIVES[kind]
    return Computed(
        how=f"closed form of the {kind.lower()} of joint {joint}, order {order}, 5 s",
        value=partial(_greatest, ORDERS[order], derivative, int(joint) - 1),
    )


def _greatest(problem: MinimumTime, derivative: int, joint: int) -> float:
    return float(peaks(problem, (WHOLE.si,), derivative)[joint])


PAPER = Paper(
    key="syji",
    read_twice=True,
    source=Source(
        authors="authors not on the copy",
        title="Seventh-order polynomial interpolation and whale optimization for the SYJI-0035 "
        "robot",
        note="title, authors, journal and year are not on the copy at hand, so this title "
        "is ours; the robot is by Henan Senyuan Electric Co., Ltd.",
    ),
    summary="Seventh-order polynomials move a six-joint arm more smoothly than fifth-order ones, "
    "and whale optimisation (WOA) of four durations cuts the motion from 5 s to 2.2999 s.",
    experiments=(MOTION,),
    inputs=(TABLE_1, TABLE_3, TABLE_4),
    results=(TABLE_2,),
    claims=(
        *computed_cells(TABLE_2, measure=greatest, within=RoundedOrCut()),
        *SENTENCES,
    ),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=(SERVO,),
    relations=RELATIONS,
    readings=(
        Reading(
            name="limits kept, at rest at each position",
            of=("motion", "SYJI-0035"),
            problem=RESTING,
        ),
        Reading(
            name="limits kept, one polynomial from start to end",
            of=("motion", "SYJI-0035"),
            problem=SEVENTH,
        ),
    ),
    figures=(
        *(
            Motion(
                label=f"Fig. 4, order {order}",
                caption="Angle, velocity, acceleration and jerk of the six joints in 5 s, with "
                "the limits of Table 3",
                problem=problem,
                durations=(WHOLE.si,),
            )
            for order, problem in ORDERS.items()
        ),
        Convergence(
            label="Fig. 5",
            caption="Fitness as printed over the iterations",
            experiment="motion",
        ),
        ToolPath(
            label="Fig. 6",
            caption="Path of the tool through the positions of Table 4",
            problem=RESTING,
            dh=dh_rows(
                a=TABLE_1.column("Link length ai-1"),
                alpha=TABLE_1.column("Link twist αi-1"),
                d=TABLE_1.column("Link distance di"),
            ),
            convention="modified",
            printed_waypoints=(),
        ),
    ),
)
