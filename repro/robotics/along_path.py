"""What a motion along a path in pieces of constant path acceleration reaches at most.

Between two points of a grid the square of the path's speed is linear in the path's parameter, and
the path a cubic of it. So the square of a joint's velocity is a polynomial of degree 5 there, and
its acceleration one of degree 2: neither exceeds its greatest Bernstein coefficient.
"""

import math

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
DEGREE = 5
INSIDE = np.linspace(0.0, 1.0, DEGREE + 1)
_BASIS = np.array(
    [[math.comb(DEGREE, i) * u**i * (1 - u) ** (DEGREE - i) for i in range(DEGREE + 1)]
     for u in INSIDE]
)  # fmt: skip
TO_BERNSTEIN = np.linalg.inv(_BASIS)


def slowing(
    grid: Vector,
    speeds: Vector,
    slope: Vector,
    bend: Vector,
    *,
    velocity: Vector,
    acceleration: Vector,
) -> float:
    """Return by which factor, 1 or more, the motion must be slowed as a whole so that it obeys.

    `grid` (n,) are the path's parameters, knots of the path among them; `speeds` (n,) are those of
    the path there, `slope` and `bend` (n, joints) its derivatives. Limits have a number per joint.
    """
    squares, steps = speeds**2, np.diff(grid)[:, None]
    gained = np.diff(squares)[:, None] / steps / 2.0
    share = INSIDE[:, None, None]
    square = squares[:-1, None] + share * np.diff(squares)[:, None]
    bent = bend[:-1] + share * np.diff(bend, axis=0)
    leaning = slope[:-1] + share * steps * (bend[:-1] + bent) / 2.0
    fast = _most(square * leaning**2) / velocity**2
    hard = _most(bent * square + leaning * gained) / acceleration
    return math.sqrt(max(1.0, float(fast.max()), float(hard.max())))


def _most(values: Vector) -> Vector:
    """Return a bound on polynomials (6, …) given by their values INSIDE, without sign."""
    return np.asarray(np.abs(np.tensordot(TO_BERNSTEIN, values, axes=1)).max(axis=0))
