"""Motions of problems that somebody else wrote are drawn as ours are."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.evidence import Evidence, Runs
from repro.model.figures import ArmMotion, Motion, ToolPath
from repro.report.drawings.arm_motion import moving, waypoints
from repro.report.drawings.draw import Drawing, draw
from repro.robotics.shown_motion import ShowsMotion, highest
from tests.small_arms import ARM, SWING
from tests.small_papers import EXPERIMENT, PAPER, Bowl, evidence_of
from tests.written_rows import rows_of

Vector = NDArray[np.float64]
SPEED = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Wave(Bowl):
    """Two joints swing to and fro; a point is (seconds of either half, height in rad)."""

    @property
    def limits(self) -> Vector:
        """A speed for the first joint, nothing else."""
        return np.array([[SPEED, np.inf], [np.inf, np.inf], [np.inf, np.inf]])

    def durations(self, point: Vector) -> Vector:
        """Return two equal halves."""
        return np.array([point[0], point[0]])

    def motion(self, point: Vector, *, derivative: int, samples: int) -> tuple[Vector, Vector]:
        """Return a whole wave, the second joint half as high."""
        half = np.linspace(0.0, 1.0, samples)
        times = point[0] * np.concatenate([half, 1.0 + half])
        rate = math.pi / point[0]
        curve = point[1] * rate**derivative * np.sin(rate * times + derivative * math.pi / 2)
        return times, np.outer(curve, [1.0, 0.5])


WAVE = Wave()
OF_OWN = replace(EXPERIMENT, problems={"bowl": Bowl(), "wave": WAVE})
FIGURE = Motion(
    label="Figure 1",
    caption="a wave",
    problem=WAVE,
    experiment="search",
    algorithms=("guess", "wide"),
)


def evidence() -> Evidence:
    """Return three runs of one algorithm, of which the second is the best."""
    points = np.array([[[4.0, 1.0], [2.0, 0.5], [3.0, 1.0]]])
    runs = Runs(
        costs=np.array([[3.0, 1.0, 2.0]]),
        points=points,
        histories=np.ones((1, 3, 1)),
        evaluations=1,
    )
    return evidence_of(replace(PAPER, experiments=(OF_OWN,)), {("search", "wave", "guess"): runs})


def drawn(figure: Motion = FIGURE) -> Drawing:
    return draw(figure, evidence(), "wave")


def test_motion_of_ones_own_is_drawn_for_the_best_run_and_no_optimum_is_claimed() -> None:
    drawing = drawn()

    assert isinstance(WAVE, ShowsMotion)
    assert "guess: 2 + 2 = 4 s, with at most 0.7854 rad/s" in drawing.description
    assert {row[0] for row in rows_of(drawing.frame)[1:]} == {"guess"}
    assert "No runs yet of wide" in drawing.description
    assert "at rest" not in drawing.description


def test_motion_without_runs_says_so() -> None:
    assert drawn(replace(FIGURE, algorithms=("wide",))).description == "No runs yet."


def test_fixed_point_of_ones_own_motion_is_drawn_without_runs() -> None:
    drawing = drawn(replace(FIGURE, durations=(1.0, 2.0), experiment="", algorithms=()))

    last = rows_of(drawing.frame)[-1]
    assert float(last[1]) == 2.0
    assert float(last[2]) == pytest.approx(0.0, abs=1e-9)


def test_limits_of_ones_own_motion_are_told() -> None:
    assert "velocity limit 3 to inf rad/s" in drawn().description


def test_peak_of_a_sampled_motion_is_that_of_its_formula() -> None:
    point = np.array([2.0, 0.5])

    assert highest(WAVE, point, 1) == pytest.approx(0.5 * math.pi / 2, rel=1e-6)


def test_problem_that_the_experiment_has_not_is_refused_with_those_that_it_has() -> None:
    with pytest.raises(DeclarationError, match="Figure 1: its problem is none of search, which"):
        drawn(replace(FIGURE, problem=SWING))


def test_arm_moves_along_a_motion_of_ones_own() -> None:
    own = ArmMotion(name="own", problem=WAVE, durations=(2.0, 0.5))
    arm = replace(ARM, motions=(own, own))

    shown = moving(arm)[0]

    assert shown.durations == (2.0, 2.0)
    assert shown.total == 4.0
    assert len(waypoints(arm)) == 3


def test_tool_path_of_ones_own_motion_passes_its_stops() -> None:
    figure = ToolPath(
        label="Figure 2", caption="a path", problem=WAVE, dh=ARM.dh, convention=ARM.convention,
        printed_waypoints=(), durations=(2.0, 0.5),
    )  # fmt: skip

    rows = rows_of(draw(figure, evidence(), "path").frame)

    assert len([row for row in rows if row[0] == "computed waypoint"]) == 3
    with pytest.raises(DeclarationError, match="Figure 2: a problem of one's own needs a point"):
        replace(figure, durations=None)


def test_arm_needs_to_be_told_which_motion_of_ones_own_it_makes() -> None:
    with pytest.raises(DeclarationError, match="needs a point in `durations`"):
        ArmMotion(name="own", problem=WAVE)
