"""Shekel's functions: narrow wells in a plain, the foxholes among them.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163. Minima and minimisers are rounded to
float64 from solutions of 50 digits.
"""

from fractions import Fraction

import numpy as np

from repro.determinism.compiled import jit
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"

_FOXHOLES = np.array([-32.0, -16.0, 0.0, 16.0, 32.0])

_A = np.array(
    [
        [4.0, 4.0, 4.0, 4.0],
        [1.0, 1.0, 1.0, 1.0],
        [8.0, 8.0, 8.0, 8.0],
        [6.0, 6.0, 6.0, 6.0],
        [3.0, 7.0, 3.0, 7.0],
        [2.0, 9.0, 2.0, 9.0],
        [5.0, 5.0, 3.0, 3.0],
        [8.0, 1.0, 8.0, 1.0],
        [6.0, 2.0, 6.0, 2.0],
        [7.0, 3.6, 7.0, 3.6],
    ]
)
_C = np.array([0.1, 0.2, 0.2, 0.4, 0.4, 0.6, 0.3, 0.7, 0.5, 0.5])


@jit
def _sixth_power(value):
    square = value * value
    return square * square * square


@jit
def _foxholes(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    total = 1.0 / 500.0
    for j in range(25):
        across = _sixth_power(x[0] - _FOXHOLES[j % 5])
        total += 1.0 / (j + 1.0 + across + _sixth_power(x[1] - _FOXHOLES[j // 5]))
    return 1.0 / total


@jit
def _wells(x, count):
    total = 0.0
    for i in range(count):
        squares = 0.0
        for j in range(4):
            squares += (x[j] - _A[i, j]) * (x[j] - _A[i, j])
        total += 1.0 / (squares + _C[i])
    return -total


@jit
def _shekel_5(x, data):  # noqa: ARG001
    return _wells(x, 5)


@jit
def _shekel_7(x, data):  # noqa: ARG001
    return _wells(x, 7)


@jit
def _shekel_10(x, data):  # noqa: ARG001
    return _wells(x, 10)


foxholes = Function(
    name="foxholes",
    title="Shekel's Foxholes",
    kernel=_foxholes,
    box=((-65.536, 65.536), (-65.536, 65.536)),
    minimum=0.99800383779445025902590515,
    at=(-31.97833483565696, -31.97833483730080),
    source=f"{_YAO}, f14",
    fixed_dimension=2,
    known=Known(
        of=_foxholes,
        ceiling=lambda _: Fraction(500),
        ceiling_on=((-65.536, 65.536), (-65.536, 65.536)),
        least_of_all_space=True,
        cancelled=4,
    ),
)
shekel_5 = Function(
    name="shekel_5",
    title="Shekel, 5 wells",
    kernel=_shekel_5,
    box=((0.0, 10.0),) * 4,
    minimum=-10.1531996790582274573625,
    at=(4.00003715281967623, 4.00013327659156009, 4.00003715281967623, 4.00013327659156009),
    source=f"{_YAO}, f21",
    fixed_dimension=4,
    known=Known(
        of=_shekel_5,
        ceiling=lambda _: Fraction(0),
        ceiling_on=((0.0, 10.0),) * 4,
        # the point of the box next to one outside is nearer to every well, in every coordinate
        least_of_all_space=True,
        cancelled=16,
    ),
)
shekel_7 = Function(
    name="shekel_7",
    title="Shekel, 7 wells",
    kernel=_shekel_7,
    box=((0.0, 10.0),) * 4,
    minimum=-10.4029405668186612618131681,
    at=(4.00057291618582335, 4.00068936618530425, 3.99948970885915061, 3.99960615885863151),
    source=f"{_YAO}, f22",
    fixed_dimension=4,
    known=Known(
        of=_shekel_7,
        ceiling=lambda _: Fraction(0),
        ceiling_on=((0.0, 10.0),) * 4,
        # the point of the box next to one outside is nearer to every well, in every coordinate
        least_of_all_space=True,
        cancelled=16,
    ),
)
shekel_10 = Function(
    name="shekel_10",
    title="Shekel, 10 wells",
    kernel=_shekel_10,
    box=((0.0, 10.0),) * 4,
    minimum=-10.5364098166920431139694556,
    at=(4.00074653159204672, 4.00059293413853200, 3.99966339804032230, 3.99950980058680758),
    source=f"{_YAO}, f23",
    fixed_dimension=4,
    known=Known(
        of=_shekel_10,
        ceiling=lambda _: Fraction(0),
        ceiling_on=((0.0, 10.0),) * 4,
        # the point of the box next to one outside is nearer to every well, in every coordinate
        least_of_all_space=True,
        cancelled=16,
    ),
)
