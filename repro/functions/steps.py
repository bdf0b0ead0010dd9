"""The step function, with steps and without.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163, rounds each coordinate to a whole number.
The programs of the whale and wolf papers leave that out, which makes it a sphere about -1/2.
"""

import math
from fractions import Fraction

from repro.determinism.compiled import jit
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"


@jit
def _step(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    total = 0.0
    for j in range(len(x)):
        total += (x[j] + 0.5) * (x[j] + 0.5)
    return total


@jit
def _step_floor(x, data):  # noqa: ARG001
    total = 0.0
    for j in range(len(x)):
        whole = math.floor(x[j] + 0.5)
        total += whole * whole
    return total


step = Function(
    name="step",
    title="Step, without rounding",
    kernel=_step,
    box=((-100.0, 100.0),),
    minimum=0.0,
    at=(-0.5,),
    source=f"{_YAO}, f6, as the programs of the wolf and whale papers have it",
    known=Known(
        of=_step,
        ceiling=lambda n: n * Fraction(1005, 10) ** 2,
        ceiling_on=((-100.0, 100.0),),
        least_of_all_space=True,
    ),
)
step_floor = Function(
    name="step_floor",
    title="Step",
    kernel=_step_floor,
    box=((-100.0, 100.0),),
    minimum=0.0,
    at=(0.0,),  # as good: all of [-1/2, 1/2) in every coordinate
    source=f"{_YAO}, f6",
    known=Known(
        of=_step_floor,
        ceiling=lambda n: Fraction(n * 100**2),
        ceiling_on=((-100.0, 100.0),),
        least_of_all_space=True,
    ),
)
