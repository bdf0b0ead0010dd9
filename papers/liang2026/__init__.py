"""Liang et al.: minimum-time motion of a FANUC arm with an improved whale optimisation."""

from dataclasses import replace
from functools import partial

from papers.liang2026.experiments import BENCHMARK, DH, FANUC, IWOA, MOTION
from papers.liang2026.formulas import FORMULAS
from papers.liang2026.misprints import ERRATA, PHYSICAL_ARM, ROBOGUIDE, SMOOTHER, TOOL_ERROR
from papers.liang2026.open_points import ASSUMPTIONS, TOGETHER
from papers.liang2026.printed import (
    TABLE_II,
    TABLE_III,
    TABLE_IV,
    TABLE_V,
    TABLE_VI,
)
from papers.liang2026.relations import RELATIONS
from papers.liang2026.times import BASELINE_SECONDS, baseline_time, table_vi, time_sentences
from papers.liang2026.tool import tool_positions
from repro.model.claims import Sentence, computed_cells, every_cell, lowest_everywhere
from repro.model.figures import Arm, ArmMotion, Convergence, Motion, ToolPath
from repro.model.measures.measure import Computed
from repro.model.paper import Paper, Source
from repro.model.tolerances import Absolute, Between, Fitness
from repro.robotics import peak
from repro.tables.published import Printed
from repro.tables.true_numbers import ZERO_STD

__all__ = ["FANUC", "IWOA", "PAPER"]

# Declared before any run. A factor of ten near zero, since a table of 30 heavy-tailed runs moves
# by decades from one batch to the next; a quarter of the value elsewhere.
FITNESS = Fitness(decades=1, near_zero=0.01, percent=25)
FITNESS_STD = replace(FITNESS, zero=ZERO_STD)
# of F12 the text says only that the curve is smooth and does not converge early
EARLY = replace(
    BENCHMARK, problems={name: BENCHMARK.problems[name] for name in ("F1", "F5", "F10")}
)
SENTENCES = (
    *lowest_everywhere(
        BENCHMARK,
        algorithm="IWOA",
        statistic="mean",
        claim="IWOA has the lowest mean of the five algorithms",
        where="section III-D",
    ),
    *lowest_everywhere(
        BENCHMARK,
        algorithm="IWOA",
        statistic="std",
        claim="IWOA has the smallest standard deviation of the five algorithms",
        where="section III-D",
    ),
    *lowest_everywhere(
        EARLY,
        algorithm="IWOA",
        statistic="mean",
        quantity="cost after 50 iterations",
        claim="IWOA is ahead early in the search (read as: lowest mean after a tenth of the "
        "iterations)",
        where="section III-D, Fig. 2",
    ),
    Sentence(
        claim="largest joint velocity of the quintic with 5 s per segment",
        where="section IV-B, Fig. 6",
        printed=Printed("1.53", "rad/s"),
        measure=Computed(
            how="closed-form peak of the quintic through Table V",
            value=partial(peak, FANUC, BASELINE_SECONDS, 1),
        ),
        accepted=Absolute(0),
    ),
    Sentence(
        claim="largest joint acceleration of the quintic with 5 s per segment",
        where="section IV-B, Fig. 6",
        printed=Printed("0.94", "rad/s^2"),
        measure=Computed(
            how="closed-form peak of the quintic through Table V",
            value=partial(peak, FANUC, BASELINE_SECONDS, 2),
        ),
        accepted=Absolute(0),
    ),
    *time_sentences("mean"),
    Sentence(
        claim="IWOA takes 18 % less time than the motion before optimisation in RoboGuide",
        where=ROBOGUIDE.where,
        printed=Printed("18", "%"),
        measure=None,
        accepted=Absolute(0.5),
        gap=ROBOGUIDE,
    ),
    Sentence(
        claim="IWOA takes 16.4 % less time than the motion before optimisation on the arm",
        where=PHYSICAL_ARM.where,
        printed=Printed("16.4", "%"),
        measure=None,
        accepted=Absolute(0.5),
        gap=PHYSICAL_ARM,
    ),
    Sentence(
        claim="the end position of the physical arm errs by no more than 2 mm",
        where=TOOL_ERROR.where,
        printed=Printed("2", "mm"),
        measure=None,
        accepted=Between(0, 2),
        gap=TOOL_ERROR,
    ),
)

PAPER = Paper(
    key="liang2026",
    read_twice=True,
    source=Source(
        authors="Caiping Liang, Hao Yuan, Chen Wang, Wenzu Niu, Yansong Zhang",
        title="Trajectory Planning of Shipbuilding Welding Manipulator Based on Improved Whale "
        "Optimization Algorithm",
        note="journal and year are not on the copy at hand, whose references run to 2025; another "
        "copy has Wenxu Niu",
    ),
    summary="An improved whale optimisation (IWOA) beats WOA, GWO, PSO and DBO on four test "
    "functions and cuts a two-segment motion of a FANUC R-2000iC/165F from 10 s to 4.69 s.",
    experiments=(BENCHMARK, MOTION),
    inputs=(TABLE_III, TABLE_V),
    results=(TABLE_II, TABLE_IV, TABLE_VI),
    claims=(
        *every_cell(
            TABLE_II,
            of=BENCHMARK,
            rows=("problem", "statistic"),
            columns="algorithm",
            names={"Best": "best", "Worst": "worst", "Mean": "mean", "Std": "std"},
            within=FITNESS,
            std_within=FITNESS_STD,
        ),
        *tool_positions("standard"),
        *computed_cells(
            TABLE_VI,
            measure=baseline_time,
            within=Absolute(0),
            only=("Fifth-order polynomial",),
        ),
        *table_vi("mean"),
        *SENTENCES,
    ),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=(ROBOGUIDE, PHYSICAL_ARM, TOOL_ERROR, SMOOTHER),
    formulas=FORMULAS,
    figures=(
        Convergence(
            label="Fig. 2",
            caption="Best cost over the iterations of the five algorithms",
            experiment="benchmark",
        ),
        ToolPath(
            label="Fig. 5",
            caption="Path of the tool through the three waypoints",
            problem=FANUC,
            dh=DH,
            convention="standard",
            printed_waypoints=TABLE_IV.points(),
        ),
        Motion(
            label="Fig. 6",
            caption="Angle, velocity and acceleration of the six joints, 5 s per segment",
            problem=FANUC,
            durations=BASELINE_SECONDS,
        ),
        Motion(
            label="Fig. 7",
            caption="Angle, velocity and acceleration of the six joints after optimisation",
            problem=FANUC,
            experiment="motion",
            algorithms=("WOA", "IWOA"),
        ),
        Arm(
            label="Arm",
            caption="The arm of Table III on its way through Table V, with the times that Table VI "
            "prints for IWOA and with those of the certified optimum",
            dh=DH,
            convention="standard",
            motions=(
                ArmMotion(
                    name="IWOA as printed",
                    problem=FANUC,
                    durations=(TABLE_VI["IWOA", "t1"].si, TABLE_VI["IWOA", "t2"].si),
                ),
                ArmMotion(name="certified optimum", problem=FANUC),
            ),
            assumed=(
                "Denavit-Hartenberg convention",
                "unit of lengths in Table III and of positions in Table IV",
            ),
        ),
    ),
    relations=RELATIONS,
    together=TOGETHER,
)
