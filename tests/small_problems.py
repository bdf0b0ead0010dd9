"""Problems that a search meets in the tests of the optimisers: small, lopsided, countable."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import COST, jit, ready
from repro.functions import FUNCTIONS

Vector = NDArray[np.float64]

OFF_CENTRE = ((-3.0, 7.0), (-50.0, 1.0), (2.0, 4.0))
"""A box with another centre and width in every dimension, without the origin."""


def _note(x: Vector, data: Vector) -> None:
    """Count the call in data[0] and write the point behind data[1], while there is room."""
    n = len(x)
    start = 2 + int(data[0]) * n
    if start + n <= len(data):
        for j in range(n):
            data[start + j] = x[j]
    data[0] += 1.0


_noted = jit(_note)
_valley = FUNCTIONS["rosenbrock"].kernel


def _rosenbrock(x: Vector, data: Vector) -> float:
    _noted(x, data)
    value: float = _valley(x, data)
    return value


def _steps(x: Vector, data: Vector) -> float:
    _noted(x, data)
    total = 0.0
    for value in x:
        total += math.floor(abs(value - 0.3))
    return total


def _slope(x: Vector, data: Vector) -> float:
    _noted(x, data)
    total = 0.0
    for value in x:
        total += value
    return total


def _cliff(x: Vector, data: Vector) -> float:
    _noted(x, data)
    return data[1] if x[0] > 0.0 else 0.0


KERNELS = {
    "rosenbrock": jit(_rosenbrock),
    "steps": jit(_steps),  # many points cost the same
    "slope": jit(_slope),  # every search is pulled out of the box
    "cliff": jit(_cliff),  # two costs only, `gap` apart
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Small:
    """A problem whose compiled cost counts its calls and keeps the points it was asked for."""

    kernel: Any
    data: Vector
    box: tuple[tuple[float, float], ...]
    name: str
    scratch: int = 0

    @property
    def bounds(self) -> Vector:
        """The box as an array, shape (n, 2)."""
        return np.array(self.box)

    @property
    def identity(self) -> tuple[object, ...]:
        """The name alone."""
        return (self.name,)

    @property
    def calls(self) -> int:
        """How often the cost was called."""
        return int(self.data[0])

    @property
    def points(self) -> list[list[float]]:
        """Every point that the cost was called with, in order."""
        end = 2 + self.calls * len(self.box)
        if end > len(self.data):
            message = f"{self.calls} calls do not fit: give small() more room"
            raise IndexError(message)
        points: list[list[float]] = self.data[2:end].reshape(self.calls, -1).tolist()
        return points

    def cost(self, x: list[float]) -> float:
        """Return the compiled cost of a point given as a list."""
        return float(ready(self.kernel, COST)(np.array(x), self.data))


def small(
    name: str,
    *,
    box: tuple[tuple[float, float], ...] = OFF_CENTRE,
    gap: float = 0.0,
    room: int = 0,
) -> Small:
    """Return a fresh problem of that name, with room for so many points."""
    data = np.zeros(2 + room * len(box))
    data[1] = gap
    return Small(name=name, kernel=KERNELS[name], data=data, box=box)
