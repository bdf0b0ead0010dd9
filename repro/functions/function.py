"""What a benchmark function is: a cost with its box and its true minimum."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.held_values import SAID
from repro.determinism.plain_costs import callable_cost, check_cost
from repro.errors import InputError
from repro.functions.known import NOTHING, Known

Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Function:
    """A benchmark function of any dimension, or of one fixed dimension.

    `box` holds (lower, upper) per coordinate, one pair for all coordinates where the dimension
    is free; `at` holds one minimiser in the same way. `minimum` is the true minimum in exact
    arithmetic. A kernel that `needs_room` writes n numbers of its own into its second argument, so
    that the loop with the sines is one that vectorises, and the sum keeps its order. `cancels` is
    the size of the terms that cancel at the minimum: a fixed part, and one per coordinate. Where
    the function `adds_up` it is a sum of one term a coordinate, and `minimum` is that of one term.

    The kernel is compiled, of (point, data), or plain Python, f(x) or f(x, data).

    A kernel whose `noise` is above 0 adds a draw from 0 to below that at every evaluation, from a
    state of `noise_room` numbers at the start of its second argument (see repro.determinism.noise).
    Where no run put one there it adds nothing, and `minimum` is that without noise.

    What is `known` of its values is what an audit holds printed ones against; with `title` and
    `source` it decides no run, and no key of one.
    """

    name: str
    title: str = field(metadata=SAID)
    kernel: Any
    box: tuple[tuple[float, float], ...]
    minimum: float
    at: tuple[float, ...]
    source: str = field(metadata=SAID)
    fixed_dimension: int | None = None
    needs_room: bool = False
    cancels: tuple[float, float] = (0.0, 0.0)
    adds_up: bool = False
    noise: float = 0.0
    noise_room: int = 0
    known: Known = field(default=NOTHING, compare=False, metadata=SAID)

    def __post_init__(self) -> None:
        """Raise DeclarationError for a kernel that is no cost."""
        check_cost(self.kernel)

    def __call__(self, x: Vector) -> float:
        """Return the value at one point of shape (n,), without noise."""
        point = np.ascontiguousarray(x, dtype=np.float64)
        if point.ndim != 1:
            message = f"{self.name} takes one point of shape (n,), not an array of {point.shape}"
            raise InputError(message)
        problem = self.problem(len(point))
        return callable_cost(self.kernel)(point, problem.data)

    @property
    def bounds_known(self) -> Known:
        """What is known of this kernel; nothing where that was said of another one."""
        return self.known if self.known.of is self.kernel else NOTHING

    def minimiser(self, dimension: int | None = None) -> Vector:
        """Return one point of shape (dimension,) that attains the minimum."""
        n = self._checked(dimension)
        return np.array(self.at if self.fixed_dimension else self.at * n)

    def problem(self, dimension: int | None = None) -> "BenchmarkProblem":
        """Return the problem of minimising this function on its box."""
        return BenchmarkProblem(function=self, dimension=self._checked(dimension))

    def _checked(self, dimension: int | None) -> int:
        n = self.fixed_dimension if dimension is None else dimension
        if n is None:
            message = f"{self.name} has no dimension of its own: give dimension=30, say"
            raise InputError(message)
        if n < 1 or (self.fixed_dimension and n != self.fixed_dimension):
            allowed = self.fixed_dimension or "1 or more"
            message = f"{self.name}: dimension {n} is impossible; it may be {allowed}"
            raise InputError(message)
        return n


@dataclass(frozen=True, slots=True, kw_only=True)
class BenchmarkProblem:
    """Minimise a benchmark function on its box."""

    function: Function
    dimension: int

    @property
    def bounds(self) -> Vector:
        """Lower and upper bound of each coordinate, shape (dimension, 2)."""
        return np.full((self.dimension, 2), self.function.box, dtype=np.float64)

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """The cost."""
        return self.function.kernel

    @property
    def data(self) -> Vector:
        """Room for the kernel, where it needs any, shape (scratch,); a new array each time."""
        return np.zeros(self.scratch)

    @property
    def scratch(self) -> int:
        """How many numbers at the start of the data the cost writes over."""
        own = self.dimension if self.function.needs_room else 0
        return own + self.function.noise_room

    @property
    def noise(self) -> float:
        """What every draw that the cost adds is below; 0 where it adds none."""
        return self.function.noise

    @property
    def minimum(self) -> float:
        """The least cost, without noise."""
        return self.function.minimum * (self.dimension if self.function.adds_up else 1)

    @property
    def step(self) -> float:
        """How far apart doubles stand where the cost adds up to its minimum; 0 about a bare 0."""
        fixed, each = self.function.cancels
        size = max(abs(self.minimum), fixed + each * self.dimension)
        return float(np.spacing(size)) if size else 0.0

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return (self.function.name, self.dimension, self.function.box)
