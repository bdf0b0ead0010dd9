"""Shifted copies of the benchmark problems: the same function in the same box, moved aside."""

import types
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.determinism.plain_costs import callable_cost, is_compiled
from repro.determinism.seeds import generator
from repro.determinism.source_digests import digest_of
from repro.errors import InputError
from repro.functions.function import BenchmarkProblem

Vector = NDArray[np.float64]
LEAST_STEP = 0.5  # of the share, in every coordinate: none is left near the centre


@dataclass(frozen=True, slots=True, kw_only=True)
class ShiftedProblem:
    """Minimise f(x - s) on the box of f.

    Coordinate j of s is between half of `share` and all of it, in half widths of the box, to
    either side, both drawn from the name of the function and the dimension: so all sizes of shift
    lie on one ray, which is no axis and no diagonal of the box. Near one edge of the box x - s
    lies outside it; there the value is what the formula of f gives.
    """

    problem: BenchmarkProblem
    share: float

    def __post_init__(self) -> None:
        """Raise InputError for a share that is no part of the half width."""
        if not 0 <= self.share < 1:
            message = f"share={self.share}: a shift is a share of the half width, 0 to below 1"
            raise InputError(message)

    def __call__(self, x: Vector) -> float:
        """Return the value at one point of shape (n,), without noise."""
        point = np.ascontiguousarray(x, dtype=np.float64)
        if point.shape != (self.problem.dimension,):
            message = f"a point of shape ({self.problem.dimension},) is needed, not {point.shape}"
            raise InputError(message)
        return callable_cost(self.kernel)(point, self.data)

    @property
    def bounds(self) -> Vector:
        """Lower and upper bound of each coordinate, shape (dimension, 2): those of f."""
        return self.problem.bounds

    @property
    def shift(self) -> Vector:
        """The shift s, shape (dimension,)."""
        n = self.problem.dimension
        rng = generator("shift", self.problem.function.name, n)
        sides = np.where(rng.random(n) < 0.5, -1.0, 1.0)
        steps = LEAST_STEP + (1.0 - LEAST_STEP) * rng.random(n)
        low, high = self.bounds.T
        return np.asarray(self.share * sides * steps * (high - low) / 2)

    @property
    def minimiser(self) -> Vector:
        """One point of shape (dimension,) that attains the minimum, off the centre of the box."""
        return self.problem.function.minimiser(self.problem.dimension) + self.shift

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """The cost: compiled where that of f is."""
        kernel = self.problem.kernel
        return _moved(kernel) if is_compiled(kernel) else MovedPlain(kernel=kernel)

    @property
    def data(self) -> Vector:
        """Room for f and for one point, then the shift; a new array each time."""
        return np.concatenate([np.zeros(self.scratch), self.shift])

    @property
    def scratch(self) -> int:
        """How many numbers at the start of the data the cost writes over."""
        return self.problem.scratch + self.problem.dimension

    @property
    def noise(self) -> float:
        """What every draw that f adds is below; 0 where it adds none."""
        return self.problem.noise

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return (*self.problem.identity, self.share)


@cache
def _moved(kernel: Any) -> Any:  # noqa: ANN401 (numba ships no types)
    """Return the compiled cost of f(x - s), where `kernel` is that of f.

    numba keeps no closure on disk from one process to the next, but it does keep a function whose
    global names are known beforehand. So the template gets f as one of its globals, and a name
    that holds a digest of the source of f, for the cached code to be that of no other function.
    """
    source = kernel.__module__
    name = f"moved_{source}_{kernel.__name__}_{digest_of(kernel)[:16]}".replace(".", "_")
    function = types.FunctionType(_at_shifted_point.__code__, {"f": kernel}, name)
    function.__qualname__ = name
    function.__module__ = source  # the module on whose source the values depend
    return jit(function)


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedPlain:
    """The cost f(x - s) where f, the `kernel`, is plain Python."""

    kernel: Any

    def __call__(self, x: Vector, data: Vector) -> float:
        """Return the cost of a point; the shift is the last n numbers of the data."""
        cost = callable_cost(self.kernel)
        return cost(x - data[len(data) - len(x) :], data)


def _at_shifted_point(x, data):
    n = len(x)
    # parts of the data, because a new array for every value would cost time
    moved, shift = data[len(data) - 2 * n : len(data) - n], data[len(data) - n :]
    for j in range(n):
        moved[j] = x[j] - shift[j]
    return f(moved, data)  # type: ignore[name-defined]  # noqa: F821 (each copy brings its f)
