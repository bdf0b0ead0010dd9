"""Hartmann's functions: four wells with Gaussian walls in a unit box.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163. Minima and minimisers are rounded to
float64 from solutions of 50 digits.
"""

import math
from fractions import Fraction

import numpy as np

from repro.determinism.compiled import jit
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"

_C = np.array([1.0, 1.2, 3.0, 3.2])
_A_3 = np.array([[3.0, 10.0, 30.0], [0.1, 10.0, 35.0], [3.0, 10.0, 30.0], [0.1, 10.0, 35.0]])
_P_3 = np.array(
    [
        [0.3689, 0.1170, 0.2673],
        [0.4699, 0.4387, 0.7470],
        [0.1091, 0.8732, 0.5547],
        [0.03815, 0.5743, 0.8828],  # some libraries have 0.0381, which moves the 6th decimal
    ]
)
_A_6 = np.array(
    [
        [10.0, 3.0, 17.0, 3.5, 1.7, 8.0],
        [0.05, 10.0, 17.0, 0.1, 8.0, 14.0],
        [3.0, 3.5, 1.7, 10.0, 17.0, 8.0],
        [17.0, 8.0, 0.05, 10.0, 0.1, 14.0],
    ]
)
_P_6 = np.array(
    [
        [0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886],
        [0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991],
        [0.2348, 0.1415, 0.3522, 0.2883, 0.3047, 0.6650],  # elsewhere 0.1451: -3.32237 at least
        [0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381],
    ]
)


@jit
def _wells(x, A, P):
    total = 0.0
    for i in range(4):
        exponent = 0.0
        for j in range(len(x)):
            distance = x[j] - P[i, j]
            exponent += A[i, j] * distance * distance
        total += _C[i] * math.exp(-exponent)
    return -total


@jit
def _hartmann_3(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    return _wells(x, _A_3, _P_3)


@jit
def _hartmann_6(x, data):  # noqa: ARG001
    return _wells(x, _A_6, _P_6)


hartmann_3 = Function(
    name="hartmann_3",
    title="Hartmann, 3 dimensions",
    kernel=_hartmann_3,
    box=((0.0, 1.0), (0.0, 1.0), (0.0, 1.0)),
    minimum=-3.86278214782075525544197545,
    at=(0.114614338589671976, 0.555648849971856935, 0.852546953520865785),
    source=f"{_YAO}, f19",
    fixed_dimension=3,
    known=Known(
        of=_hartmann_3,
        ceiling=lambda _: Fraction(0),
        ceiling_on=((0.0, 1.0), (0.0, 1.0), (0.0, 1.0)),
        # the point of the box next to one outside is nearer to every well, in every coordinate
        least_of_all_space=True,
        cancelled=16,
    ),
)
hartmann_6 = Function(
    name="hartmann_6",
    title="Hartmann, 6 dimensions",
    kernel=_hartmann_6,
    box=((0.0, 1.0),) * 6,
    minimum=-3.32199517158424209865343052,
    at=(
        0.201707617885154795,
        0.146780945653272771,
        0.476744851232218684,
        0.275342390962127165,
        0.311651875299511721,
        0.657275164221049566,
    ),
    source=f"{_YAO}, f20, with p_32 = 0.1415 as the programs of the wolf and whale papers have it",
    fixed_dimension=6,
    known=Known(
        of=_hartmann_6,
        ceiling=lambda _: Fraction(0),
        ceiling_on=((0.0, 1.0),) * 6,
        # the point of the box next to one outside is nearer to every well, in every coordinate
        least_of_all_space=True,
        cancelled=16,
    ),
)
