"""Polynomials that move a joint from rest to rest.

The one of degree 2k + 1 has its first k derivatives zero at both ends; in normalised time and
distance it is s(τ) with s(0) = 0 and s(1) = 1 (L. Biagiotti, C. Melchiorri, Trajectory Planning
for Automatic Machines and Robots, Springer 2008, section 2.1).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from numbers import Integral
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from repro.errors import InputError
from repro.robotics.motion_checks import shown

HIGHEST = 99  # degree: exact arithmetic takes seconds there
IN_DOUBLES = (
    13  # degree: beyond it the peaks of the polynomial in doubles are off by 1e-11 and more
)


@dataclass(frozen=True)
class RestToRestLaw:
    """The rest-to-rest polynomial of an odd degree."""

    degree: int

    def __post_init__(self) -> None:
        """Raise InputError unless the degree is odd and from 3 to IN_DOUBLES."""
        check_degree(self.degree)
        if self.degree > IN_DOUBLES:
            message = (
                f"degree {self.degree}: doubles carry a law of degree {IN_DOUBLES} at most; a "
                f"PolynomialMotion may have any odd degree up to {HIGHEST}"
            )
            raise InputError(message)

    @cached_property
    def polynomial(self) -> Polynomial:
        """s(τ): the integral of τ^k (1-τ)^k, scaled to end at 1."""
        k = (self.degree - 1) // 2
        bump = (Polynomial([0, 1]) * Polynomial([1, -1])) ** k
        area = bump.integ()
        return area / area(1.0)

    def peak_factor(self, derivative: int) -> float:
        """Return max abs(s^(m)(τ)) on [0, 1]: a move D in time T peaks at factor · abs(D) / T^m."""
        curve = self.polynomial.deriv(derivative)
        turns = curve.deriv().roots() if curve.degree() > 0 else np.zeros(0)
        real = turns.real[abs(turns.imag) < 1e-9]
        inside = real[(real > 0.0) & (real < 1.0)]
        return float(np.max(np.abs(curve(np.concatenate([[0.0, 1.0], inside])))))

    def squared(self, derivative: int) -> float:
        """Return ∫ s^(m)(τ)² dτ: a move D in time T has factor · D² / T^(2m-1)."""
        curve = self.polynomial.deriv(derivative)
        return float((curve**2).integ()(1.0))

    def sample(self, share: NDArray[np.float64], derivative: int = 0) -> NDArray[np.float64]:
        """Return s^(m) at normalised times `share`, same shape."""
        curve = self.polynomial.deriv(derivative) if derivative else self.polynomial
        return np.asarray(curve(share))


def check_degree(degree: Any) -> None:  # noqa: ANN401 (checked here)
    """Raise InputError unless a degree is an odd whole number from 3 to HIGHEST."""
    whole = isinstance(degree, Integral) and not isinstance(degree, bool)
    if not whole or not 3 <= degree <= HIGHEST or degree % 2 == 0:
        message = (
            f"degree {shown(degree)}: a rest-to-rest polynomial has degree 3, 5, 7, …, {HIGHEST}"
        )
        raise InputError(message)


def bernstein(p: Sequence[Fraction]) -> list[Fraction]:
    """Return the Bernstein coefficients on [0, 1] of the polynomial p[0] + p[1]·τ + …."""
    n = len(p) - 1
    return [
        sum((Fraction(math.comb(i, k), math.comb(n, k)) * p[k] for k in range(i + 1)), Fraction(0))
        for i in range(n + 1)
    ]


cubic = RestToRestLaw(3)
quintic = RestToRestLaw(5)
septic = RestToRestLaw(7)
