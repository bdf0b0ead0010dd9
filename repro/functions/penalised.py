"""Levy-type functions with a penalty outside a box.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163.
"""

import math
from fractions import Fraction

from repro.determinism.compiled import jit
from repro.determinism.sines import squared_sine
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"


@jit
def _outside(x, a, k, m):
    """Return the penalty u(x, a, k, m) of one coordinate."""
    if x > a:
        return k * (x - a) ** m
    if x < -a:
        return k * (-x - a) ** m
    return 0.0


@jit
def _penalized_1(x, room):
    n = len(x)
    for i in range(n):
        room[i] = squared_sine(math.pi * _raised(x[i]))
    total = 10.0 * room[0]
    penalty = _outside(x[0], 10.0, 100.0, 4)
    for i in range(1, n):
        before = _raised(x[i - 1]) - 1.0
        total += before * before * (1.0 + 10.0 * room[i])
        penalty += _outside(x[i], 10.0, 100.0, 4)
    last = _raised(x[n - 1]) - 1.0
    total += last * last
    return math.pi / n * total + penalty


@jit
def _raised(value):
    return 1.0 + (value + 1.0) / 4.0


@jit
def _penalized_2(x, room):
    n = len(x)
    for i in range(n):
        room[i] = squared_sine(3.0 * math.pi * x[i])
    total = room[0]
    penalty = _outside(x[0], 5.0, 100.0, 4)
    for i in range(1, n):
        before = x[i - 1] - 1.0
        total += before * before * (1.0 + room[i])
        penalty += _outside(x[i], 5.0, 100.0, 4)
    last = x[n - 1] - 1.0
    total += last * last * (1.0 + squared_sine(2.0 * math.pi * x[n - 1]))
    return 0.1 * total + penalty


def _most_of_penalized_1(n: int) -> Fraction:
    """Return 355/113 > π over n times the greatest terms, and the penalty at 50."""
    step = Fraction(51, 4) ** 2  # (y - 1)² at x = 50
    return Fraction(355, 113) / n * (10 + step + 11 * (n - 1) * step) + n * 100 * 40**4


penalized_1 = Function(
    name="penalized_1",
    title="Generalized penalized function 1",
    kernel=_penalized_1,
    box=((-50.0, 50.0),),
    minimum=0.0,
    at=(-1.0,),
    source=f"{_YAO}, f12",
    needs_room=True,
    known=Known(
        of=_penalized_1,
        ceiling=_most_of_penalized_1,
        ceiling_on=((-50.0, 50.0),),
        least_of_all_space=True,
    ),
)
penalized_2 = Function(
    name="penalized_2",
    title="Generalized penalized function 2",
    kernel=_penalized_2,
    box=((-50.0, 50.0),),
    minimum=0.0,
    at=(1.0,),
    source=f"{_YAO}, f13",
    needs_room=True,
    known=Known(
        of=_penalized_2,
        ceiling=lambda n: n * 100 * 45**4 + Fraction(1 + 2 * n * 51**2, 10),
        ceiling_on=((-50.0, 50.0),),
        least_of_all_space=True,
    ),
)
