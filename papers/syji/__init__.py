"""SYJI-0035 arm: seventh-order polynomials in four segments, timed by whale optimisation."""

from papers.syji.formulas import FORMULAS
from papers.syji.misprints import ERRATA, SERVO
from papers.syji.motions import FOUND, ORDERS, PRINTED, RESTING, SEVENTH
from papers.syji.open_points import ASSUMPTIONS, TOGETHER
from papers.syji.printed import TABLE_1, TABLE_2, TABLE_3, TABLE_4, WHOLE
from papers.syji.relations import RELATIONS
from papers.syji.sentences import SENTENCES
from papers.syji.table_2 import table_2_claims
from repro.model.experiment import Experiment
from repro.model.figures import Arm, ArmMotion, Convergence, Motion, ToolPath
from repro.model.paper import MotionReading, Paper, Source
from repro.optimisers import WOA
from repro.robotics import dh_rows

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
DH = dh_rows(
    a=TABLE_1.column("Link length ai-1"),
    alpha=TABLE_1.column("Link twist αi-1"),
    d=TABLE_1.column("Link distance di"),
)

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
        *table_2_claims(),
        *SENTENCES,
    ),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=(SERVO,),
    relations=RELATIONS,
    together=TOGETHER,
    motion_readings=(
        MotionReading(
            name="limits kept, at rest at each position",
            of=("motion", "SYJI-0035"),
            problem=RESTING,
        ),
        MotionReading(
            name="limits kept, one polynomial from start to end",
            of=("motion", "SYJI-0035"),
            problem=SEVENTH,
        ),
    ),
    formulas=FORMULAS,
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
            dh=DH,
            convention="modified",
            printed_waypoints=(),
        ),
        Arm(
            label="Arm",
            caption="The arm of Table 1 on its way through Table 4, at rest at each position, with "
            "the printed durations and with the shortest that keep the limits of Table 3",
            dh=DH,
            convention="modified",
            motions=(
                ArmMotion(name="WOA as printed", problem=RESTING, durations=FOUND),
                ArmMotion(name="certified optimum, limits kept", problem=RESTING),
            ),
            assumed=("Denavit-Hartenberg convention", "link twists of joints 3 and 6"),
        ),
    ),
)
