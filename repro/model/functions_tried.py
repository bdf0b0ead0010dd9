"""Whether functions keep the bounds that are said of them, at some points of their box."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.functions import BenchmarkProblem
from repro.model.paper import Paper

POINTS = 200
AT_A_CORNER = 0.2  # of coordinates: sums are greatest there
# a sum of rounded terms may be off by so much, of itself or of 1
ROUNDED = 1e-9


def bound_faults(paper: Paper) -> Iterator[str]:
    """Yield a line for each function whose minimum or ceiling a point of its box breaks."""
    seen: set[BenchmarkProblem] = set()
    for experiment in paper.experiments:
        for name, problem in experiment.problems.items():
            if isinstance(problem, BenchmarkProblem) and problem not in seen:
                seen.add(problem)
                place = f"experiment {experiment.name!r}, problem {name!r}"
                yield from (f"{place}: {fault}" for fault in function_faults(problem))


def function_faults(problem: BenchmarkProblem) -> Iterator[str]:
    """Yield what is said of the function of a problem and does not hold."""
    function = problem.function
    at = function(function.minimiser(problem.dimension))
    if abs(at - problem.minimum) > _slack(problem.minimum):
        yield f"{function.name} is {at:g} at its minimiser, its minimum is {problem.minimum:g}"
    most = function.bounds_known.most(function.box, problem.dimension)
    values = [(function(point), point) for point in _points(problem)]
    least, lowest = min(values, key=lambda pair: pair[0])
    greatest, highest = max(values, key=lambda pair: pair[0])
    if least < problem.minimum - _slack(problem.minimum):
        yield f"{function.name} is {least:g} at {_shown(lowest)}, below {problem.minimum:g}"
    if most is not None and greatest > float(most) + _slack(float(most)):
        yield f"{function.name} is {greatest:g} at {_shown(highest)}, above its ceiling {most}"


def _points(problem: BenchmarkProblem) -> NDArray[np.float64]:
    """Return points of the box, shape (POINTS, dimension), some coordinates at an edge."""
    rng = generator("bounds", problem.function.name, problem.dimension)
    low, high = problem.bounds.T
    shares = rng.random((POINTS, len(low)))
    shares = np.where(rng.random(shares.shape) < AT_A_CORNER, shares.round(), shares)
    shares[0], shares[1] = 0.0, 1.0
    points: NDArray[np.float64] = low + shares * (high - low)
    return points


def _slack(bound: float) -> float:
    return ROUNDED * max(1.0, abs(bound))


def _shown(point: NDArray[np.float64]) -> str:
    return np.array2string(point, precision=4, threshold=6, edgeitems=2, separator=", ")
