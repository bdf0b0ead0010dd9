"""Liang et al.: the algorithm, the robot, and the two experiments."""

from papers.liang2026.printed import ACCELERATION, TABLE_III, TABLE_V, VELOCITY
from repro.functions import FUNCTIONS
from repro.model.experiment import Experiment
from repro.optimisers import DBO, GWO, PSO, WOA, HybridWOA
from repro.robotics import MinimumTime, dh_rows, quintic

IWOA = HybridWOA(
    start="tent",  # Eq. (13)
    control="quadratic",  # Eq. (14)
    spiral=(2.5, 1.0),  # Eq. (15)
    probability="cosine",  # Eq. (16)
    leader="per whale",  # Eqs. (11)-(12)
    spiral_range="symmetric",  # Eq. (10)
    differential=0.5,  # Eqs. (17)-(18), step 5
    scale=0.5,
    crossover=0.9,
    genetic=0.5,  # Eq. (19), step 6
    mutation=0.01,
    disturbance=0.01,  # section III-B 1)
)

BENCHMARK = Experiment(
    name="benchmark",
    where="section III-D",
    proposed="IWOA",
    problems={
        "F1": FUNCTIONS["sphere"].problem(40),
        "F5": FUNCTIONS["rosenbrock"].problem(40),
        "F10": FUNCTIONS["ackley"].problem(40),
        "F12": FUNCTIONS["penalized_1"].problem(40),
    },
    algorithms={"IWOA": IWOA, "WOA": WOA(), "GWO": GWO(), "PSO": PSO(), "DBO": DBO()},
    population=50,
    iterations=500,
    runs=30,
)
FANUC = MinimumTime(
    waypoints=tuple(TABLE_V.column(name) for name in TABLE_V.column_names),
    law=quintic,  # Eqs. (1)-(4)
    velocity=(VELOCITY.si,) * 6,
    acceleration=(ACCELERATION.si,) * 6,
    durations=(0.1, 5.0),
)
MOTION = Experiment(
    name="motion",
    where="section IV-C",
    proposed="IWOA",
    problems={"FANUC": FANUC},
    algorithms={"WOA": WOA(), "IWOA": IWOA},
    population=30,
    iterations=300,
    runs=50,
)
DH = dh_rows(
    a=TABLE_III.column("a_{i-1}"),
    alpha=TABLE_III.column("α_{i-1}"),
    d=TABLE_III.column("d_i"),
)
