"""Functions with one basin.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163.
"""

from fractions import Fraction

from repro.determinism.compiled import jit
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"


@jit
def _sphere(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    total = 0.0
    for j in range(len(x)):  # by index: `for value in x` looks its stride up at every step
        total += x[j] * x[j]
    return total


@jit
def _schwefel_2_22(x, data):  # noqa: ARG001
    total = 0.0
    product = 1.0
    for value in x:
        total += abs(value)
        product *= abs(value)
    return total + product


@jit
def _schwefel_1_2(x, data):  # noqa: ARG001
    total = 0.0
    partial = 0.0
    for value in x:
        partial += value
        total += partial * partial
    return total


@jit
def _schwefel_2_21(x, data):  # noqa: ARG001
    largest = 0.0
    for value in x:
        largest = max(largest, abs(value))
    return largest


@jit
def _rosenbrock(x, data):  # noqa: ARG001
    total = 0.0
    for i in range(len(x) - 1):
        valley = x[i + 1] - x[i] * x[i]
        total += 100.0 * valley * valley + (x[i] - 1.0) * (x[i] - 1.0)
    return total


sphere = Function(
    name="sphere",
    title="Sphere",
    kernel=_sphere,
    box=((-100.0, 100.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f1",
    known=Known(
        of=_sphere,
        ceiling=lambda n: Fraction(n * 100**2),
        ceiling_on=((-100.0, 100.0),),
        least_of_all_space=True,
    ),
)
schwefel_2_22 = Function(
    name="schwefel_2_22",
    title="Schwefel 2.22",
    kernel=_schwefel_2_22,
    box=((-10.0, 10.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f2",
    known=Known(
        of=_schwefel_2_22,
        ceiling=lambda n: Fraction(10 * n + 10**n),
        ceiling_on=((-10.0, 10.0),),
        least_of_all_space=True,
    ),
)
schwefel_1_2 = Function(
    name="schwefel_1_2",
    title="Schwefel 1.2",
    kernel=_schwefel_1_2,
    box=((-100.0, 100.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f3",
    known=Known(
        of=_schwefel_1_2,
        ceiling=lambda n: Fraction(100**2 * n * (n + 1) * (2 * n + 1), 6),
        ceiling_on=((-100.0, 100.0),),
        least_of_all_space=True,
    ),
)
schwefel_2_21 = Function(
    name="schwefel_2_21",
    title="Schwefel 2.21",
    kernel=_schwefel_2_21,
    box=((-100.0, 100.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f4",
    known=Known(
        of=_schwefel_2_21,
        ceiling=lambda _: Fraction(100),
        ceiling_on=((-100.0, 100.0),),
        least_of_all_space=True,
    ),
)
rosenbrock = Function(
    name="rosenbrock",
    title="Rosenbrock",
    kernel=_rosenbrock,
    box=((-30.0, 30.0),),
    minimum=0.0,
    at=(1.0,),
    source=f"{_YAO}, f5",
    known=Known(
        of=_rosenbrock,
        ceiling=lambda n: Fraction((n - 1) * (100 * (30 + 30**2) ** 2 + 31**2)),
        ceiling_on=((-30.0, 30.0),),
        least_of_all_space=True,
    ),
)
