"""Liang et al.: minimum-time motion of a FANUC arm with an improved whale optimisation."""

from dataclasses import replace
from functools import partial

from papers.liang2026.experiments import BENCHMARK, DH, FANUC, IWOA, MOTION
from papers.liang2026.formulas import FORMULAS
from papers.liang2026.misprints import ERRATA, PHYSICAL_ARM, ROBOGUIDE, TOOL_ERROR
from papers.liang2026.open_points import ASSUMPTIONS, TOGETHER
from papers.liang2026.printed import (
    BASELINE,
    TABLE_II,
    TABLE_III,
    TABLE_IV,
    TABLE_V,
    TABLE_VI,
    TIME_SAVED,
)
from papers.liang2026.relations import RELATIONS
from papers.liang2026.tool import tool_positions
from repro.claims import Sentence, computed_cells, every_cell, lowest_everywhere
from repro.figures import Arm, ArmMotion, Convergence, Motion, ToolPath
from repro.measures import Computed, Reduction, Statistic
from repro.model import Paper, Source
from repro.published import Printed
from repro.robotics import peak
from repro.verdict import ZERO_STD, Absolute, Between, Fitness, Percent

__all__ = ["FANUC", "IWOA", "PAPER"]

BASELINE_SECONDS = tuple(duration.si for duration in BASELINE)


def baseline_time(_row: str, column: str) -> Computed:
    """Return the measure of one cell of Table VI's first row: the durations that are set."""
    t1, t2 = BASELINE_SECONDS
    chosen = {"t1": t1, "t2": t2, "Total Time t": t1 + t2}[column]
    return Computed(how=f"{column} as set in section IV-B", value=lambda: chosen)


def total_time(algorithm: str) -> Statistic:
    """Return the measure of an algorithm's total time, averaged as section IV-C says."""
    return Statistic(
        experiment="motion",
        problem="FANUC",
        algorithm=algorithm,
        statistic="mean",
        quantity="total",
    )


BASELINE_TOTAL = baseline_time("Fifth-order polynomial", "Total Time t")

# Declared before any run. A factor of ten near zero, since a table of 30 heavy-tailed runs moves
# by decades from one batch to the next; a quarter of the value elsewhere.
FITNESS = Fitness(decades=1, near_zero=0.01, percent=25)
FITNESS_STD = replace(FITNESS, zero=ZERO_STD)
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
        BENCHMARK,
        algorithm="IWOA",
        statistic="mean",
        quantity="cost after 50 iterations",
        claim="IWOA is ahead early in the search: lowest mean after a tenth of the iterations",
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
    Sentence(
        claim="IWOA takes 18.3 % less time than the motion before optimisation",
        where="abstract",
        printed=TIME_SAVED,
        measure=Reduction(before=BASELINE_TOTAL, after=total_time("IWOA")),
        accepted=Absolute(0.5),
    ),
    Sentence(
        claim="IWOA cuts the total time from 10 s to 4.69 s",
        where="section VI",
        printed=TABLE_VI["IWOA", "Total Time t"],
        measure=total_time("IWOA"),
        accepted=Percent(1),
    ),
    Sentence(
        claim="WOA reaches a total time of 5.74 s",
        where="section VI",
        printed=TABLE_VI["WOA", "Total Time t"],
        measure=total_time("WOA"),
        accepted=Percent(1),
    ),
    Sentence(
        claim="IWOA plans a clearly faster motion than WOA (read as: at least 1 % less time; "
        "the printed times differ by 18.3 %)",
        where="sections IV-C and VI",
        printed=TIME_SAVED,
        measure=Reduction(before=total_time("WOA"), after=total_time("IWOA")),
        accepted=Between(1, 100),
        in_words=True,
    ),
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
        claim="the tool of the physical arm stays within 2 mm of its path",
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
        note="journal and year are not on the copy at hand, whose references run to 2025",
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
        *every_cell(
            TABLE_VI,
            of=MOTION,
            rows=("algorithm",),
            columns="quantity",
            given={"problem": "FANUC", "statistic": "mean"},
            names={"t1": "duration 1", "t2": "duration 2", "Total Time t": "total"},
            within=Percent(1),
            only=("WOA", "IWOA"),
        ),
        *SENTENCES,
    ),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=(ROBOGUIDE, PHYSICAL_ARM, TOOL_ERROR),
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
