"""Ten motions of other people's, certified, and computed a second time by plain sampling."""

import importlib.util
import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.interpolate import BPoly, BSpline
from scipy.optimize import brentq, minimize

from repro.commands.certify_problem import certify
from repro.commands.motion_files import MotionFile, read_motion
from repro.judge.outside_planners import ruckig_time, toppra_time
from repro.robotics import DirectedSpline, MinimumTime, MinimumTimeSpline
from repro.robotics.own_motion import points_of
from repro.robotics.polynomial_motion import PolynomialMotion
from repro.robotics.proofs.proved import FREE

Vector = NDArray[np.float64]
HERE = Path(__file__).parents[1] / "motions"
FILES = sorted(HERE.glob("*.toml"))
FINE = np.linspace(0.0, 1.0, 4001)


def absent(*packages: str) -> bool:
    return any(importlib.util.find_spec(name) is None for name in packages)


def readable(path: Path) -> MotionFile:
    if "robot" in path.read_text(encoding="utf-8") and absent("yourdfpy"):
        pytest.skip("yourdfpy is not installed")
    return read_motion(path)


def of(*kinds: type) -> list[object]:
    """Return the files whose law is a spline or is not, without reading a robot's description."""
    spline = MinimumTimeSpline in kinds
    return [
        pytest.param(path, id=path.stem)
        for path in FILES
        if ('law = "spline"' in path.read_text(encoding="utf-8")) == spline
    ]


def excess(file: MotionFile, segment: int, time: float) -> float:
    """Return the greatest share of a limit in a segment, sampled from scipy's own polynomials."""
    problem = file.problem
    assert isinstance(problem, MinimumTime | PolynomialMotion)
    degree = problem.degree if isinstance(problem, PolynomialMotion) else problem.law.degree  # type: ignore[attr-defined]
    still = [0.0] * len(file.names)
    first = getattr(problem, "start", still) if segment == 0 else still
    last = getattr(problem, "end", still) if segment == problem.segments - 1 else still
    worst = 0.0
    for joint in range(len(file.names)):
        ends = [
            [problem.waypoints[segment + k][joint], speed[joint], *[0.0] * ((degree - 3) // 2)]
            for k, speed in enumerate((first, last))
        ]
        curve = BPoly.from_derivatives([0.0, time], ends)
        for m, kind in enumerate(("range", "velocity", "acceleration", "jerk")):
            values = curve(time * FINE, nu=m)
            for low, high in file.limits[kind][joint : joint + 1] if kind in file.limits else ():
                if m == 0:
                    assert low <= values.min() + 1e-9
                    assert values.max() <= high + 1e-9
                else:
                    worst = max(worst, values.max() / high, values.min() / low)
    return worst


@pytest.mark.parametrize("path", of(MinimumTime))
def test_minimum_of_polynomials_is_that_of_a_plain_search(path: Path) -> None:
    file = readable(path)
    found = certify(file.problem)

    box = file.problem.durations
    for segment, duration in enumerate(found.at):
        assert excess(file, segment, duration) <= 1 + 1e-9
        if duration <= box[0] * (1 + 1e-9):
            continue
        low = max(0.8 * duration, box[0])
        assert excess(file, segment, low) > 1
        least = brentq(lambda time, k=segment: excess(file, k, time) - 1.0, low, 1.2 * duration)
        assert duration == pytest.approx(least, rel=1e-5)
    assert found.minimum == pytest.approx(sum(found.at), rel=1e-12)


def basis(count: int) -> Vector:
    """Return values and derivatives at FINE of the four uniform cubic B-splines on a span."""
    knots = np.arange(-3.0, 5.0)
    return np.array(
        [[BSpline.basis_element(knots[k : k + 5])(FINE, nu=m, extrapolate=False) for k in range(4)]
         for m in range(count)]
    )  # fmt: skip


def control(values: Vector, ends: str) -> Vector:
    """Return the control points of the spline through values, by plain linear algebra."""
    n = len(values)
    rule = {"repeated": (1, -1, 0), "still": (1, 0, -1), "natural": (1, -2, 1)}[ends]
    matrix, given = np.zeros((n + 2, n + 2)), np.zeros((n + 2, values.shape[1]))
    matrix[0, :3], matrix[-1, -3:] = rule, rule[::-1]
    for k in range(n):
        matrix[k + 1, k : k + 3] = (1 / 6, 4 / 6, 1 / 6)
    given[1:-1] = values
    return np.asarray(np.linalg.solve(matrix, given), dtype=np.float64)


def shares(problem: MinimumTimeSpline, durations: Vector) -> Vector:
    """Return by how much of a limit velocity and acceleration stay below it, finely sampled."""
    b = np.nan_to_num(basis(3))
    angle = control(np.array(problem.nodes), problem.ends)
    instants = np.concatenate([[0.0], np.cumsum(durations)])[:, None]
    time = control(instants, problem.time_ends)
    room = []
    for span in range(problem.segments):
        q1, q2 = (np.einsum("ku,kj->uj", b[m], angle[span : span + 4]) for m in (1, 2))
        t1, t2 = (np.einsum("ku,kj->uj", b[m], time[span : span + 4]) for m in (1, 2))
        fast = np.abs(q1) / problem.limits[0]
        hard = np.abs(q2 * t1 - q1 * t2) / problem.limits[1]
        room += [(t1 - fast).min(axis=0), (np.maximum(t1, 1e-9) ** 3 - hard).min(axis=0)]
    return np.concatenate(room)


@pytest.mark.parametrize("path", of(MinimumTimeSpline))
def test_minimum_of_splines_is_that_of_scipy(path: Path) -> None:
    problem = read_motion(path).problem
    assert isinstance(problem, MinimumTimeSpline)
    found = certify(problem)
    assert found.minimum is not None
    assert found.binding
    assert shares(problem, np.array(found.at)).min() > -1e-9

    rng = np.random.default_rng(1)
    best = min(
        (
            minimize(
                lambda x: x.sum(),
                np.array(found.at) * rng.uniform(1.0, 1.5, problem.segments),
                method="SLSQP",
                bounds=[(1e-3, 99.0)] * problem.segments,
                constraints={"type": "ineq", "fun": lambda x: shares(problem, x)},
                options={"maxiter": 200, "ftol": 1e-10},
            )
            for _ in range(3)
        ),
        key=lambda each: each.fun if shares(problem, each.x).min() > -1e-6 else np.inf,
    )
    assert best.fun >= (found.lower_bound or 0.0) * (1 - 1e-4)
    assert best.fun == pytest.approx(found.minimum, rel=1e-3)


@pytest.mark.parametrize("name", ["panda_jerk", "ruckig_two_sided"])
def test_spline_under_limits_of_others_keeps_them_all_and_meets_one(
    name: str, tmp_path: Path
) -> None:
    text = (HERE / f"{name}.toml").read_text(encoding="utf-8")
    path = tmp_path / "spline.toml"
    path.write_text(re.sub(r"(?m)^law = .*$", 'law = "spline"', text), encoding="utf-8")
    file = read_motion(path)
    found = certify(file.problem)
    assert isinstance(file.problem, DirectedSpline)
    assert found.minimum is not None

    b = np.nan_to_num(basis(4))
    angle = control(np.array(file.problem.nodes), file.problem.ends)
    time = control(np.concatenate([[0.0], np.cumsum(found.at)])[:, None], file.problem.time_ends)
    worst: dict[str, float] = {}
    for span in range(file.problem.segments):
        q1, q2, q3 = (np.einsum("ku,kj->uj", b[m], angle[span : span + 4]) for m in (1, 2, 3))
        t1, t2, t3 = (np.einsum("ku,kj->uj", b[m], time[span : span + 4]) for m in (1, 2, 3))
        bend = (q2 * t1 - q1 * t2) / t1**3
        jolt = ((q3 * t1 - q1 * t3) / t1**3 - 3.0 * bend * t2 / t1) / t1
        # FINE ends in a knot, at which scipy's third derivative is 0 and none of this span's
        for kind, values in (("velocity", q1 / t1), ("acceleration", bend), ("jerk", jolt[:-1])):
            low, high = np.array(file.limits[kind]).T
            share = np.maximum(values / low, values / high).max()
            worst[kind] = max(worst.get(kind, 0.0), float(share))
    assert max(worst.values()) == pytest.approx(1.0, abs=1e-5)
    assert max(worst.values()) <= 1.0
    assert all(kind in " ".join(found.binding) for kind, share in worst.items() if share > 0.9999)


@pytest.mark.skipif(absent("ruckig", "toppra"), reason="the extra `references` is not installed")
@pytest.mark.parametrize("path", of(MinimumTime))
def test_no_motion_beats_the_least_time_of_any_curve(path: Path) -> None:
    problem = readable(path).problem
    if not isinstance(problem, MinimumTime):
        pytest.skip("starts or ends moving, or its limits differ by direction")
    found = certify(problem)
    assert ruckig_time(problem) <= (found.lower_bound or 0.0) * (1 + 1e-9)
    assert toppra_time(problem) > 0.0


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_file_says_whose_motion_it_is(path: Path) -> None:
    file = readable(path)

    assert path.read_text(encoding="utf-8").startswith("# ")
    assert file.title != path.stem
    assert file.problem.durations == FREE or "durations" in path.read_text(encoding="utf-8")
    assert all(start != end for start, end in pairwise(points_of(file.problem)))


def test_there_are_ten_of_them() -> None:
    assert len(FILES) == 10
