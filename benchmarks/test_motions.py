"""What one evaluation of each motion problem costs, and what its certificate does."""

import subprocess
import sys
from functools import partial
from statistics import median
from typing import Any

import numba
import numpy as np
import pytest
from numba.types import FunctionType
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.measuring import in_turns, timed
from benchmarks.results import Results, Section
from repro.commands.catalogue import all_papers
from repro.determinism.compiled import COST, VECTOR, ready
from repro.functions.function import BenchmarkProblem
from repro.judge.certificates import certify
from repro.model.experiment import Experiment
from repro.model.paper import Paper

POINTS = 2000
PAPERS = all_papers()
MOTIONS = [
    (paper.key, experiment)
    for paper in PAPERS.values()
    for experiment in paper.experiments
    if not any(isinstance(p, BenchmarkProblem) for p in experiment.problems.values())
]
COSTS = Section(
    title="One evaluation of each motion problem",
    text=f"Nanoseconds per evaluation at {POINTS} points drawn uniformly from the box, the cost "
    "behind a pointer as in a search.",
    columns=("paper", "experiment", "problem", "variables", "ns"),
)
CERTIFICATES = Section(
    title="Certificates",
    text="Milliseconds to prove the minima of all motion problems of a paper, as a program's first "
    "call.",
    columns=("paper", "certificates", "ms"),
)


@numba.njit(  # type: ignore[untyped-decorator,unused-ignore]
    numba.float64(FunctionType(COST), VECTOR, numba.float64[:, ::1])
)
def summed(cost: Any, data: Any, points: Any) -> float:  # noqa: ANN401
    total = 0.0
    for i in range(points.shape[0]):
        total += cost(points[i], data)
    return total


@pytest.mark.parametrize(
    ("paper", "experiment"), MOTIONS, ids=[f"{p}/{e.name}" for p, e in MOTIONS]
)
def test_one_evaluation(
    benchmark: BenchmarkFixture, results: Results, paper: str, experiment: Experiment
) -> None:
    calls = {}
    for name, problem in experiment.problems.items():
        low, high = problem.bounds.T
        points = np.random.default_rng(1).uniform(low, high, size=(POINTS, len(low)))
        data = np.ascontiguousarray(problem.data, dtype=np.float64)
        calls[name] = partial(summed, ready(problem.kernel, COST), data, points)
    taken = in_turns(benchmark, calls, rounds=21)
    for name, problem in experiment.problems.items():
        each = f"{1e9 * median(taken[name]) / POINTS:.0f}"
        results.add(COSTS, paper, experiment.name, name, str(len(problem.bounds)), each)


@pytest.mark.parametrize("paper", PAPERS.values(), ids=PAPERS)
def test_certificates(benchmark: BenchmarkFixture, results: Results, paper: Paper) -> None:
    took = timed(benchmark, partial(_proving, paper))
    results.add(CERTIFICATES, paper.key, str(len(certify(paper))), f"{1000 * took:,.1f}")


def _proving(paper: Paper) -> float:
    """Return the seconds of a program's first call: what is proved once is kept for later ones."""
    code = (
        "from time import perf_counter\n"
        "from repro.commands.catalogue import all_papers\n"
        "from repro.judge.certificates import certify\n"
        f"paper = all_papers()[{paper.key!r}]\n"
        "start = perf_counter()\n"
        "certify(paper)\n"
        "print(perf_counter() - start)\n"
    )
    told = subprocess.run((sys.executable, "-c", code), check=True, capture_output=True)
    return float(told.stdout)
