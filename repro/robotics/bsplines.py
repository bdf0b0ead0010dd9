"""Uniform cubic B-splines through given nodes.

C. de Boor, A Practical Guide to Splines, Springer 2001, chapter X; L. Biagiotti, C. Melchiorri,
Trajectory Planning for Automatic Machines and Robots, Springer 2008, section 8.4. On each span
between two nodes the curve is a cubic polynomial in u from 0 to 1, made of four control points.
"""

from fractions import Fraction
from functools import cache
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.errors import DeclarationError

Vector = NDArray[np.float64]
Matrix = tuple[tuple[Fraction, ...], ...]
Ends = Literal["repeated", "natural", "still"]

# What the first three control points, and the last three from the end, add up to 0 with:
# V0 = V1; no second derivative in u; no first derivative in u.
_END_RULES = {"repeated": (1, -1, 0), "natural": (1, -2, 1), "still": (1, 0, -1)}
_NODE = (Fraction(1, 6), Fraction(4, 6), Fraction(1, 6))  # a node of the control points around it
# Power basis of one span: entry [k][m] multiplies u^k and the m-th of its four control points.
_BASIS = tuple(
    tuple(Fraction(entry, 6) for entry in row)
    for row in ((1, 4, 1, 0), (-3, 0, 3, 0), (3, -6, 3, 0), (-1, 3, -3, 1))
)


@cache
def control_weights(nodes: int, ends: Ends = "repeated") -> Matrix:
    """Return the exact matrix (nodes + 2, nodes) from nodes to control points.

    `ends` is the rule for the two points that the nodes leave open. Raises DeclarationError for
    fewer than two nodes or an unknown rule.
    """
    if nodes < 2 or ends not in _END_RULES:
        message = (
            f"a spline through {nodes} nodes with {ends!r} ends: it needs two nodes or more and "
            f"one of {', '.join(get_args(Ends))}"
        )
        raise DeclarationError(message)
    size = nodes + 2
    rule = [Fraction(entry) for entry in _END_RULES[ends]]
    blank = [Fraction(0)] * size
    rows = [rule + blank[3:]]
    rows += [blank[: i - 1] + list(_NODE) + blank[i + 2 :] for i in range(1, nodes + 1)]
    rows.append(blank[3:] + rule[::-1])
    given = [[Fraction(int(row == i + 1)) for i in range(nodes)] for row in range(size)]
    return tuple(map(tuple, solve(rows, given)))


def solve(matrix: list[list[Fraction]], given: list[list[Fraction]]) -> list[list[Fraction]]:
    """Return X of matrix · X = given, exactly; ZeroDivisionError where the matrix is singular."""
    n = len(matrix)
    rows = [[*left, *right] for left, right in zip(matrix, given, strict=True)]
    for column in range(n):
        pivot = next((i for i in range(column, n) if rows[i][column]), column)
        rows[column], rows[pivot] = rows[pivot], rows[column]
        scale = rows[column][column]
        rows[column] = [entry / scale for entry in rows[column]]
        for i in range(n):
            factor = rows[i][column]
            if i != column and factor:
                own = zip(rows[i], rows[column], strict=True)
                rows[i] = [entry - factor * other for entry, other in own]
    return [row[n:] for row in rows]


@cache
def span_weights(nodes: int, ends: Ends = "repeated") -> tuple[Matrix, ...]:
    """Return the exact matrix (4, nodes) of each span, from nodes to the coefficients of u^k."""
    control = control_weights(nodes, ends)
    return tuple(
        tuple(
            tuple(
                sum((row[m] * control[span + m][node] for m in range(4)), Fraction(0))
                for node in range(nodes)
            )
            for row in _BASIS
        )
        for span in range(nodes - 1)
    )


def spans(nodes: ArrayLike, ends: Ends = "repeated") -> Vector:
    """Return the polynomials of all spans through `nodes` (n, …), shape (n - 1, 4, …).

    Entry [i, k] multiplies u^k on the span from node i to node i + 1.
    """
    values = np.asarray(nodes, dtype=np.float64)
    weights = np.array(span_weights(len(values), ends), dtype=np.float64)
    return np.tensordot(weights, values, axes=1)


def sample(polynomials: Vector, u: Vector, derivative: int = 0) -> Vector:
    """Return the derivative in u of polynomials (spans, 4, …) at `u` (m,), (spans, m, …)."""
    powers = np.zeros((len(u), polynomials.shape[1]))
    for k in range(derivative, polynomials.shape[1]):
        factor = float(np.prod(np.arange(k - derivative + 1, k + 1)))
        powers[:, k] = factor * u ** (k - derivative)
    return np.moveaxis(np.tensordot(powers, polynomials, axes=(1, 1)), 0, 1)
