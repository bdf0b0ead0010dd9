"""Polynomials with rational coefficients, and the proof that one is positive on [0, 1].

A polynomial is given by its coefficients of 1, u, u², …. Its Bernstein coefficients bound it (R. T.
Farouki, Computer Aided Geometric Design 29 (2012) 379-419, doi:10.1016/j.cagd.2012.03.001): where
all are positive, so is the polynomial.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from repro.robotics.polynomials import bernstein
from repro.robotics.proofs.watch import ENDLESS, Watch

Polynomial = Sequence[Fraction]
HALVINGS = 40  # of an interval whose Bernstein coefficients do not decide


def derivative(p: Polynomial) -> list[Fraction]:
    """Return the coefficients of p'."""
    return [k * entry for k, entry in enumerate(p)][1:]


def product(p: Polynomial, q: Polynomial) -> list[Fraction]:
    """Return the coefficients of p·q."""
    total = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            total[i + j] += a * b
    return total


def difference(p: Polynomial, q: Polynomial) -> list[Fraction]:
    """Return the coefficients of p - q."""
    size = max(len(p), len(q))
    padded = ([*r, *[Fraction(0)] * (size - len(r))] for r in (p, q))
    return [a - b for a, b in zip(*padded, strict=True)]


def positive(p: Polynomial) -> bool:
    """Return whether p is proved positive on [0, 1]; one that touches 0 is not."""
    return _positive(bernstein(p), HALVINGS)


def not_negative(p: Polynomial, watch: Watch = ENDLESS) -> bool:
    """Return whether p is proved to be 0 or more on [0, 1] until the watch is over.

    It may be 0 at the ends.
    """
    return none_negative(bernstein(p), watch)


def none_negative(rest: list[Fraction], watch: Watch = ENDLESS) -> bool:
    """Return the same of a polynomial given by its Bernstein coefficients."""
    # a root at an end is divided out, as often as it is one
    while len(rest) > 1 and rest[0] == 0:
        n = len(rest) - 1
        rest = [rest[i + 1] * Fraction(n, i + 1) for i in range(n)]
    while len(rest) > 1 and rest[-1] == 0:
        n = len(rest) - 1
        rest = [rest[i] * Fraction(n, n - i) for i in range(n)]
    return min(rest) >= 0 or _positive(rest, HALVINGS, watch)


def _positive(bernstein: list[Fraction], halvings: int, watch: Watch = ENDLESS) -> bool:
    if min(bernstein) > 0:
        return True
    if halvings == 0 or watch.over or bernstein[0] <= 0 or bernstein[-1] <= 0:
        return False
    left, right = [bernstein[0]], [bernstein[-1]]
    while len(bernstein) > 1:  # de Casteljau's scheme at 1/2
        bernstein = [(a + b) / 2 for a, b in pairwise(bernstein)]
        left.append(bernstein[0])
        right.append(bernstein[-1])
    return all(_positive(half, halvings - 1, watch) for half in (left, right[::-1]))
