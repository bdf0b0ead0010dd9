"""Problems that a search meets in the tests of the optimisers: small, lopsided, countable."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.compiled import COST, jit, ready
from repro.functions import FUNCTIONS

Vector = NDArray[np.float64]

OFF_CENTRE = ((-3.0, 7.0), (-50.0, 1.0), (2.0, 4.0))
"""A box with another centre and width in every dimension, without the origin."""


def _steps(x: Vector, data: Vector) -> float:
    data[0] += 1.0
    total = 0.0
    for value in x:
        total += math.floor(abs(value - 0.3))
    return total


def _slope(x: Vector, data: Vector) -> float:
    data[0] += 1.0
    total = 0.0
    for value in x:
        total += value
    return total


def _cliff(x: Vector, data: Vector) -> float:
    data[1] += 1.0
    return data[0] if x[0] > 0.0 else 0.0


KERNELS = {
    "steps": jit(_steps),  # many points cost the same
    "slope": jit(_slope),  # every search is pulled out of the box
    "cliff": jit(_cliff),  # two costs only, as far apart as the data say
    "rosenbrock": FUNCTIONS["rosenbrock"].kernel,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Small:
    """A problem whose cost counts its calls in `data`, unless it is a benchmark function."""

    kernel: Any
    data: Vector
    box: tuple[tuple[float, float], ...]
    name: str

    @property
    def bounds(self) -> Vector:
        """The box as an array, shape (n, 2)."""
        return np.array(self.box)

    @property
    def identity(self) -> tuple[object, ...]:
        """The name alone."""
        return (self.name,)

    def cost(self, x: list[float]) -> float:
        """Return the compiled cost of a point given as a list."""
        return float(ready(self.kernel, COST)(np.array(x), self.data))


def small(
    name: str,
    *,
    box: tuple[tuple[float, float], ...] = OFF_CENTRE,
    data: tuple[float, ...] = (0.0, 0.0),
) -> Small:
    """Return a fresh problem with the kernel of that name, no call counted yet."""
    return Small(name=name, kernel=KERNELS[name], data=np.array(data), box=box)
