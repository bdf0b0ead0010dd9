"""SMWOA: minimum-time motion of a UR5 with a slime mould whale optimisation algorithm."""

from dataclasses import replace

from papers.smwoa2022.experiments import BENCHMARK, SMWOA, TRAJECTORY, UR5
from papers.smwoa2022.formulas import FORMULAS
from papers.smwoa2022.misprints import ERRATA, GAPS
from papers.smwoa2022.open_points import ASSUMPTIONS, TOGETHER
from papers.smwoa2022.printed import TABLE_2, TABLE_3, TABLE_4, TABLE_5, TABLE_6
from papers.smwoa2022.relations import RELATIONS
from papers.smwoa2022.robot import DH, LINKS
from papers.smwoa2022.sentences import SENTENCES, printed_durations
from papers.smwoa2022.table_3 import TABLE_3_CLAIMS
from papers.smwoa2022.table_6 import table_6
from repro.model.figures import Arm, ArmMotion, SplineMotion
from repro.model.paper import MotionReading, Paper, Source

__all__ = ["PAPER", "SMWOA"]

PAPER = Paper(
    key="smwoa2022",
    read_twice=True,
    source=Source(
        authors="authors not on the copy",
        title="Joints Trajectory Planning of Robot Based on Slime Mould Whale Optimization "
        "Algorithm",
        year=2022,
        journal="Algorithms 15(10), 363",
        doi="10.3390/a15100363",
        note="the copy at hand omits the authors",
    ),
    summary="A whale optimisation with parts of the slime mould algorithm (SMWOA) beats WOA, PSO, "
    "GSA, DE and SMA on fifteen test functions and cuts a motion of a UR5 through six nodes from "
    "39.526 s to 24.635 s.",
    experiments=(BENCHMARK, TRAJECTORY),
    inputs=(TABLE_2, TABLE_4, TABLE_5),
    results=(TABLE_3, TABLE_6),
    claims=(
        *TABLE_3_CLAIMS,
        *table_6("single"),
        *SENTENCES,
    ),
    assumptions=(*ASSUMPTIONS, LINKS),
    errata=ERRATA,
    gaps=GAPS,
    relations=RELATIONS,
    together=TOGETHER,
    motion_readings=(
        MotionReading(
            name="at rest at both ends, Eq. (20) for time",
            of=("trajectory", "UR5"),
            problem=replace(UR5, ends="still"),
        ),
        MotionReading(
            name="at rest at both ends, natural spline for time",
            of=("trajectory", "UR5"),
            problem=replace(UR5, ends="still", time_ends="natural"),
        ),
    ),
    formulas=FORMULAS,
    figures=(
        SplineMotion(
            label="Fig. 3",
            caption="Angle of the base joint with the printed durations, the re-run ones, and "
            "those of the proved optimum",
            problem=UR5,
            durations=printed_durations("SMWOA"),
            experiment="trajectory",
            algorithms=("SMWOA",),
            joints=(1,),
            derivatives=(0,),
        ),
        SplineMotion(
            label="Fig. 4",
            caption="Angle, velocity, acceleration and jerk of the six joints with the printed "
            "durations of SMWOA",
            problem=UR5,
            durations=printed_durations("SMWOA"),
            experiment="trajectory",
            algorithms=("SMWOA",),
            joints=(1, 2, 3, 4, 5, 6),
            derivatives=(0, 1, 2, 3),
        ),
        Arm(
            label="Arm",
            caption="A UR5 on its way through the nodes of Table 4, with the durations that Table "
            "6 prints for SMWOA and with those of the certified optimum",
            dh=DH,
            convention="standard",
            motions=(
                ArmMotion(
                    name="SMWOA as printed", problem=UR5, durations=printed_durations("SMWOA")
                ),
                ArmMotion(name="certified optimum", problem=UR5),
            ),
            assumed=(LINKS.what,),
        ),
    ),
)
