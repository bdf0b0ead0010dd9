"""Fitting a polynomial in time to a desired path of one joint, coefficient by coefficient.

The desired path is a rest-to-rest law between two angles, the fitted curve any polynomial whose
coefficients a search may choose; the cost is the Euclidean norm of their difference at equally
spaced instants. The problem is a linear least-squares one, so its minimum is known.

With V the matrix of powers of the instants and c the coefficients of least cost, V = QR with
orthonormal columns of Q gives |V a - desired|² = |R (a - c)|² + |V c - desired|²: the cost needs
the triangle R and not every instant (G. Golub, C. Van Loan, Matrix Computations, section 5.3).
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.errors import DeclarationError
from repro.robotics.polynomial_curves import QUANTITIES, values
from repro.robotics.polynomials import RestToRestLaw

Vector = NDArray[np.float64]
ERRORS: Mapping[str, Callable[[Vector], Vector]] = MappingProxyType(
    {
        "rms error": lambda apart: np.asarray(np.sqrt(np.mean(apart**2, axis=-1))),
        "start error": lambda apart: np.asarray(apart[..., 0]),
        "end error": lambda apart: np.asarray(apart[..., -1]),
    }
)
"""Errors in rad by name: |difference| at the instants (…, k) to values of shape (…)."""


@jit
def _cost(x, data):
    n = len(x)
    squares = data[0]
    k = 1 + n
    for i in range(n):
        row = 0.0
        for j in range(i, n):
            row += data[k] * (x[j] - data[1 + j])
            k += 1
        squares += row * row
    return math.sqrt(squares)


@cache
def _orthogonal(intervals: int, n: int) -> tuple[Vector, Vector]:
    """Return Q (intervals + 1, n) and R (n, n) of the powers 0 to n - 1 of k / intervals.

    Gram and Schmidt's way, each column twice; sums are exact before they are rounded, so that the
    bits do not depend on the machine.
    """
    share = np.arange(intervals + 1) / intervals
    Q, R = np.zeros((intervals + 1, n)), np.zeros((n, n))
    column = np.ones(intervals + 1)
    for j in range(n):
        rest = column
        for i in [*range(j), *range(j)]:
            part = math.fsum(Q[:, i] * rest)
            R[i, j] += part
            rest = rest - part * Q[:, i]
        R[j, j] = math.sqrt(math.fsum(rest * rest))
        Q[:, j] = rest / R[j, j]
        column = column * share
    return Q, R


@dataclass(frozen=True, slots=True, kw_only=True)
class PathFitting:
    """Choose coefficients a_0, a_1, … of Σ a_j t^j so that it follows a desired path.

    The desired path goes from `start` to `end` in rad by `law` in `duration` s; both are compared
    at `intervals` + 1 equally spaced instants, the ends among them. `box` holds (lower, upper) of
    a_j · duration^j in rad, a pair per coefficient: written so, the problem is one and the same
    whatever the duration.
    """

    start: float
    end: float
    law: RestToRestLaw
    duration: float
    intervals: int
    box: tuple[tuple[float, float], ...]

    def __post_init__(self) -> None:
        """Raise DeclarationError for a duration, a number of intervals or a box that cannot be."""
        if self.duration <= 0 or self.intervals < len(self.box):
            message = (
                f"duration {self.duration} s and {self.intervals} intervals: the first must be "
                f"above 0, the second at least the {len(self.box)} coefficients"
            )
            raise DeclarationError(message)
        if not self.box or any(lower > upper for lower, upper in self.box):
            message = f"box {self.box} must hold one pair lower <= upper per coefficient"
            raise DeclarationError(message)

    @property
    def times(self) -> Vector:
        """Instants at which the paths are compared, shape (intervals + 1,), in s."""
        return np.linspace(0.0, self.duration, self.intervals + 1)

    @property
    def desired(self) -> Vector:
        """Desired angle at each instant, shape (intervals + 1,), in rad."""
        share = self.law.sample(self.times / self.duration)
        return np.asarray(self.start + (self.end - self.start) * share)

    @property
    def coefficients(self) -> Vector:
        """Coefficients of the desired path, in rad/s^j, at least as many as the box has."""
        exact = np.multiply(self.end - self.start, self.law.polynomial.coef).astype(np.float64)
        exact[0] += self.start
        padded = np.zeros(max(len(exact), len(self.box)))
        padded[: len(exact)] = exact
        return np.asarray(padded / self._powers(len(padded)))

    @property
    def bounds(self) -> Vector:
        """Lower and upper bound of each coefficient, shape (n, 2), in rad/s^j."""
        return np.array(self.box) / self._powers(len(self.box))[:, None]

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """Compiled norm of the difference, in rad."""
        return _cost

    @property
    def data(self) -> Vector:
        """Everything that the compiled cost needs, in one vector."""
        n = len(self.box)
        triangle = _orthogonal(self.intervals, n)[1] * self._powers(n)
        least = [self.least_cost() ** 2]
        return np.concatenate([least, self.nearest(), triangle[np.triu_indices(n)]])

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return tuple(getattr(self, name) for name in self.__slots__)

    def nearest(self) -> Vector:
        """Return the coefficients of least cost, shape (n,), whether or not they are in bounds."""
        n = len(self.box)
        if self.law.degree < n:
            return self.coefficients[:n]
        Q, R = _orthogonal(self.intervals, n)
        found = np.zeros(n)
        for i in reversed(range(n)):
            known = math.fsum(R[i, i + 1 :] * found[i + 1 :])
            found[i] = (math.fsum(Q[:, i] * self.desired) - known) / R[i, i]
        return np.asarray(found / self._powers(n))

    def least_cost(self) -> float:
        """Return the least cost of any coefficients, in rad: the norm at `nearest`.

        It is exactly 0 where the desired path is itself a polynomial of the fitted degree.
        """
        if self.law.degree < len(self.box):
            return 0.0
        return math.hypot(*(values(self.nearest(), self.times) - self.desired))

    def allows(self, coefficients: Vector) -> bool:
        """Whether the coefficients (n,) lie within the bounds."""
        lower, upper = self.bounds.T
        return bool((lower <= coefficients).all() and (coefficients <= upper).all())

    def quantity(self, name: str, points: Vector) -> Vector:
        """Return a quantity of fitted curves `points` (…, n), shape (…).

        It is "rms error", "start error" or "end error", in rad, or one of QUANTITIES; anything
        else is a DeclarationError.
        """
        if name in QUANTITIES:
            return QUANTITIES[name](points, self.duration)
        if name not in ERRORS:
            known = ", ".join(map(repr, (*ERRORS, *QUANTITIES)))
            message = f"a fitted curve has no quantity {name!r}; it has {known}"
            raise DeclarationError(message)
        return ERRORS[name](np.abs(values(points, self.times) - self.desired))

    def _powers(self, n: int) -> Vector:
        return np.asarray(self.duration ** np.arange(n))
