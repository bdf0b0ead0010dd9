"""Linear programmes of the durations, and the bounds that follow from them exactly.

The programmes are solved in doubles, and no bound rests on that: for any weights y >= 0, c·h is at
least y·g + min over the box of (c - yG)·h where Gh >= g, and both terms are worked out in rational
numbers (A. Neumaier, O. Shcherbina, Mathematical Programming 99 (2004) 283-296).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from repro.errors import NotProvedError
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.limit_rows import Box, Rationals, Row, smallest

Vector = NDArray[np.float64]
COST_OF_BREACH = 1e4  # in the linear programmes, which so have an optimum in any box
SMALL = 1e-9  # weights below are left out of a bound; rows are as large as the total time
TOLERANCES = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}


@dataclass(frozen=True, slots=True, kw_only=True)
class Optimum:
    """Optimum of a linear programme, and the weights of the limits and of the extra row."""

    x: Vector
    weights: Vector
    extra: float


def solved(
    limits: Limits,
    objective: Vector,
    around: Vector,
    allowed: Vector,
    *,
    total: float | None = None,
) -> Optimum:
    """Return the least objective among durations `allowed`, with rows as they are `around`."""
    from scipy.optimize import linprog  # noqa: PLC0415 (slow to load)

    weights, least, _ = limits.rows(around)
    if total is not None:
        weights = np.vstack([weights, -np.ones(len(objective))])
        least = np.append(least, -total)
    # a row of small numbers would be kept less well than one of large numbers
    size = abs(weights) @ around.mean(axis=1)
    size[size == 0.0] = 1.0
    found = linprog(
        np.append(objective, COST_OF_BREACH),
        A_ub=-np.column_stack([weights / size[:, None], np.ones(len(least))]),
        b_ub=-least / size,
        bounds=[*allowed.tolist(), (0.0, None)],
        method="highs",
        options=TOLERANCES,
    )
    if found.status:
        message = f"a linear programme of the durations has no optimum: {found.message}"
        raise NotProvedError(message)
    y = np.maximum(-found.ineqlin.marginals, 0.0)
    y = np.where(y > SMALL, y / size, 0.0)
    extra = 0.0 if total is None else float(y[-1])
    return Optimum(x=found.x[:-1], weights=y[: len(limits.known)], extra=extra)


def proved(
    limits: Limits, objective: Vector, box: Box, found: Optimum, *, total: Fraction = Fraction(0)
) -> Fraction:
    """Return a bound on the objective in a box, exactly, from weights that need not be exact."""
    used = np.flatnonzero(found.weights).tolist()
    rows = [limits.known[i].row(box) for i in used]
    rows.append(((Fraction(-1),) * len(box), -total))
    weights = [Fraction(found.weights[i]) for i in used] + [Fraction(found.extra)]
    return weighed(tuple(map(Fraction, objective)), rows, weights, box)


def weighed(
    objective: Rationals, rows: Sequence[Row], weights: Sequence[Fraction], box: Box
) -> Fraction:
    """Return a bound on the objective in a box, for any weights >= 0 of rows that hold there."""
    rest = list(objective)
    bound = Fraction(0)
    for (row, least), weight in zip(rows, weights, strict=True):
        rest = [own - weight * entry for own, entry in zip(rest, row, strict=True)]
        bound += weight * least
    return bound + smallest(rest, box)
