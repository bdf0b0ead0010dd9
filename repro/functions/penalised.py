"""Levy-type functions with a penalty outside a box.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163.
"""

import math

from repro.compiled import jit
from repro.functions.function import Function

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
def _squared_sine(angle):
    sine = math.sin(angle)
    return sine * sine


@jit
def _penalized_1(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    n = len(x)
    y = 1.0 + (x[0] + 1.0) / 4.0
    total = 10.0 * _squared_sine(math.pi * y)
    penalty = _outside(x[0], 10.0, 100.0, 4)
    for i in range(1, n):
        y_next = 1.0 + (x[i] + 1.0) / 4.0
        total += (y - 1.0) * (y - 1.0) * (1.0 + 10.0 * _squared_sine(math.pi * y_next))
        penalty += _outside(x[i], 10.0, 100.0, 4)
        y = y_next
    total += (y - 1.0) * (y - 1.0)
    return math.pi / n * total + penalty


@jit
def _penalized_2(x, data):  # noqa: ARG001
    n = len(x)
    total = _squared_sine(3.0 * math.pi * x[0])
    penalty = _outside(x[0], 5.0, 100.0, 4)
    for i in range(1, n):
        before = x[i - 1] - 1.0
        total += before * before * (1.0 + _squared_sine(3.0 * math.pi * x[i]))
        penalty += _outside(x[i], 5.0, 100.0, 4)
    last = x[n - 1] - 1.0
    total += last * last * (1.0 + _squared_sine(2.0 * math.pi * x[n - 1]))
    return 0.1 * total + penalty


penalized_1 = Function(
    name="penalized_1",
    title="Generalized penalized function 1",
    kernel=_penalized_1,
    box=((-50.0, 50.0),),
    minimum=0.0,
    at=(-1.0,),
    source=f"{_YAO}, f12",
)
penalized_2 = Function(
    name="penalized_2",
    title="Generalized penalized function 2",
    kernel=_penalized_2,
    box=((-50.0, 50.0),),
    minimum=0.0,
    at=(1.0,),
    source=f"{_YAO}, f13",
)
