"""Functions of two or four dimensions that are polynomials or nearly so.

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

_KOWALIK_A = np.array(
    [0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246]
)
_KOWALIK_B = 1.0 / np.array([0.25, 0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0])


@jit
def _kowalik(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    total = 0.0
    for i in range(11):
        b = _KOWALIK_B[i]
        rate = x[0] * (b * b + b * x[1]) / (b * b + b * x[2] + x[3])
        total += (_KOWALIK_A[i] - rate) * (_KOWALIK_A[i] - rate)
    return total


@jit
def _six_hump_camel(x, data):  # noqa: ARG001
    u, v = x[0] * x[0], x[1] * x[1]
    ridge = 4.0 * u - 2.1 * (u * u) + u * u * u / 3.0
    return ridge + x[0] * x[1] - 4.0 * v + 4.0 * (v * v)


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


kowalik = Function(
    name="kowalik",
    title="Kowalik",
    kernel=_kowalik,
    box=((-5.0, 5.0),) * 4,
    minimum=0.000307485987805606081305700825,
    at=(0.192833452982508579, 0.190836238782629149, 0.123117296277857121, 0.135765989981537030),
    source=f"{_YAO}, f15",
    fixed_dimension=4,
    # no ceiling: its denominators vanish inside the box
)
six_hump_camel = Function(
    name="six_hump_camel",
    title="Six-hump camel-back",
    kernel=_six_hump_camel,
    box=((-5.0, 5.0), (-5.0, 5.0)),
    minimum=-1.03162845348987735041636543714,
    at=(0.0898420131003180624, -0.712656403020739634),  # as good: its negative
    source=f"{_YAO}, f16",
    fixed_dimension=2,
    cancels=(2.0, 0.0),  # 4 v² at the minimum
    known=Known(
        of=_six_hump_camel,
        # the cubic in u² has its inner peak, below 3, near u² = 1.46 and is greatest at u² = 25; so
        # is 4 v⁴ - 4 v², which is convex in v²
        ceiling=lambda _: 100 - Fraction(21, 10) * 625 + Fraction(5**6, 3) + 25 + 2400,
        ceiling_on=((-5.0, 5.0), (-5.0, 5.0)),
        # above 0 outside, even with -(u² + v²) / 2 in the place of uv
        least_of_all_space=True,
        cancelled=4,
    ),
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
    cancels=(10.0, 0.0),
    known=Known(
        of=_branin,
        # convex in v, so greatest at v = -5 or 15; there below 378 but for v = -5 and u <= -4,
        # where the bowl is at least -22.1875 and cos u at most cos 5
        ceiling=lambda _: Fraction(221875, 10000) ** 2 + Fraction(27244, 10000) + 10,
        ceiling_on=((-5.0, 10.0), (-5.0, 15.0)),
        least_of_all_space=True,
        cancelled=30,
    ),
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
    cancels=(432.0, 0.0),  # 48 v at the minimum, times the 9 of the square before it
    known=Known(
        of=_goldstein_price,
        # Bernstein coefficients of the polynomial on parts of the box are below
        ceiling=lambda _: Fraction(1015691),
        ceiling_on=((-2.0, 2.0), (-2.0, 2.0)),
        least_of_all_space=True,
        cancelled=1000,
    ),
)
