"""Functions of two, three or four dimensions.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163. Minima and minimisers are rounded to
float64 from solutions of 50 digits.
"""

import math

import numpy as np

from repro.determinism.compiled import jit
from repro.functions.function import Function

_YAO = "Yao, Liu & Lin (1999)"

_FOXHOLES = np.array([-32.0, -16.0, 0.0, 16.0, 32.0])

_HARTMANN_A = np.array([[3.0, 10.0, 30.0], [0.1, 10.0, 35.0], [3.0, 10.0, 30.0], [0.1, 10.0, 35.0]])
_HARTMANN_C = np.array([1.0, 1.2, 3.0, 3.2])
_HARTMANN_P = np.array(
    [
        [0.3689, 0.1170, 0.2673],
        [0.4699, 0.4387, 0.7470],
        [0.1091, 0.8732, 0.5547],
        [0.03815, 0.5743, 0.8828],  # some libraries have 0.0381, which moves the 6th decimal
    ]
)

_SHEKEL_A = np.array(
    [
        [4.0, 4.0, 4.0, 4.0],
        [1.0, 1.0, 1.0, 1.0],
        [8.0, 8.0, 8.0, 8.0],
        [6.0, 6.0, 6.0, 6.0],
        [3.0, 7.0, 3.0, 7.0],
    ]
)
_SHEKEL_C = np.array([0.1, 0.2, 0.2, 0.4, 0.4])


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
def _branin(x, data):  # noqa: ARG001
    u, v = x[0], x[1]
    bowl = v - 5.1 * u * u / (4.0 * math.pi * math.pi) + 5.0 * u / math.pi - 6.0
    return bowl * bowl + 10.0 * (1.0 - 1.0 / (8.0 * math.pi)) * math.cos(u) + 10.0


@jit
def _goldstein_price(x, data):  # noqa: ARG001
    u, v = x[0], x[1]
    near = (u + v + 1.0) * (u + v + 1.0)
    far = (2.0 * u - 3.0 * v) * (2.0 * u - 3.0 * v)
    first = 19.0 - 14.0 * u + 3.0 * u * u - 14.0 * v + 6.0 * u * v + 3.0 * v * v
    second = 18.0 - 32.0 * u + 12.0 * u * u + 48.0 * v - 36.0 * u * v + 27.0 * v * v
    return (1.0 + near * first) * (30.0 + far * second)


@jit
def _hartmann_3(x, data):  # noqa: ARG001
    total = 0.0
    for i in range(4):
        exponent = 0.0
        for j in range(3):
            distance = x[j] - _HARTMANN_P[i, j]
            exponent += _HARTMANN_A[i, j] * distance * distance
        total += _HARTMANN_C[i] * math.exp(-exponent)
    return -total


@jit
def _shekel_5(x, data):  # noqa: ARG001
    total = 0.0
    for i in range(5):
        squares = 0.0
        for j in range(4):
            squares += (x[j] - _SHEKEL_A[i, j]) * (x[j] - _SHEKEL_A[i, j])
        total += 1.0 / (squares + _SHEKEL_C[i])
    return -total


foxholes = Function(
    name="foxholes",
    title="Shekel's Foxholes",
    kernel=_foxholes,
    box=((-65.536, 65.536), (-65.536, 65.536)),
    minimum=0.99800383779445025902590515,
    at=(-31.97833483565696, -31.97833483730080),
    source=f"{_YAO}, f14",
    fixed_dimension=2,
)
branin = Function(
    name="branin",
    title="Branin",
    kernel=_branin,
    box=((-5.0, 10.0), (0.0, 15.0)),
    minimum=5.0 / (4.0 * math.pi),
    at=(math.pi, 2.275),  # as good: (-pi, 12.275) and (3 pi, 2.475)
    source=f"{_YAO}, f17",
    fixed_dimension=2,
)
goldstein_price = Function(
    name="goldstein_price",
    title="Goldstein-Price",
    kernel=_goldstein_price,
    box=((-2.0, 2.0), (-2.0, 2.0)),
    minimum=3.0,
    at=(0.0, -1.0),
    source=f"{_YAO}, f18",
    fixed_dimension=2,
)
hartmann_3 = Function(
    name="hartmann_3",
    title="Hartmann, 3 dimensions",
    kernel=_hartmann_3,
    box=((0.0, 1.0), (0.0, 1.0), (0.0, 1.0)),
    minimum=-3.86278214782075525544197545,
    at=(0.114614338589671976, 0.555648849971856935, 0.852546953520865785),
    source=f"{_YAO}, f19",
    fixed_dimension=3,
)
shekel_5 = Function(
    name="shekel_5",
    title="Shekel, 5 wells",
    kernel=_shekel_5,
    box=((0.0, 10.0), (0.0, 10.0), (0.0, 10.0), (0.0, 10.0)),
    minimum=-10.1531996790582274573625,
    at=(4.00003715281967623, 4.00013327659156009, 4.00003715281967623, 4.00013327659156009),
    source=f"{_YAO}, f21",
    fixed_dimension=4,
)
