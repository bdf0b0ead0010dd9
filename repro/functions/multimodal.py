"""Functions with many basins and a free dimension.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163. Alpine N.1 is not among its 23; M. Jamil,
X.-S. Yang, A literature survey of benchmark functions for global optimization problems,
arXiv:1308.4008 (2013), has it.
"""

import math
from fractions import Fraction

from repro.determinism.compiled import jit
from repro.determinism.sines import cosine_of_turns
from repro.functions.function import Function
from repro.functions.known import Known

_YAO = "Yao, Liu & Lin (1999)"


@jit
def _rastrigin(x, room):
    n = len(x)
    for j in range(n):
        room[j] = x[j] * x[j] - 10.0 * cosine_of_turns(x[j])
    total = 0.0
    for j in range(n):
        total += room[j]
    # 10n after the sum, as the programs of the whale and wolf papers have it: the smallest value
    # above zero is then 5.7e-14 at n = 30, against 1.8e-15 if 10 is added term by term
    return total + 10.0 * n


@jit
def _ackley(x, room):
    n = len(x)
    for j in range(n):
        room[j] = cosine_of_turns(x[j])
    squares = 0.0
    waves = 0.0
    for j in range(n):
        squares += x[j] * x[j]
        waves += room[j]
    return -20.0 * math.exp(-0.2 * math.sqrt(squares / n)) - math.exp(waves / n) + 20.0 + math.e


@jit
def _schwefel_2_26(x, room):
    n = len(x)
    for j in range(n):  # sin y is cos(y - pi / 2)
        room[j] = x[j] * cosine_of_turns(math.sqrt(abs(x[j])) / (2.0 * math.pi) - 0.25)
    total = 0.0
    for j in range(n):
        total -= room[j]
    return total


@jit
def _griewank(x, room):
    n = len(x)
    for j in range(n):
        room[j] = cosine_of_turns(x[j] / math.sqrt(j + 1.0) / (2.0 * math.pi))
    squares = 0.0
    product = 1.0
    for j in range(n):
        squares += x[j] * x[j]
        product *= room[j]
    return squares / 4000.0 - product + 1.0


@jit
def _alpine_1(x, data):  # noqa: ARG001 (every cost kernel has the same two arguments)
    total = 0.0
    for value in x:
        total += abs(value * math.sin(value) + 0.1 * value)
    return total


schwefel_2_26 = Function(
    name="schwefel_2_26",
    title="Schwefel 2.26",
    kernel=_schwefel_2_26,
    box=((-500.0, 500.0),),
    minimum=-418.982887272433706274786435,
    at=(420.968746359982027311844365,),
    source=f"{_YAO}, f8",
    needs_room=True,
    adds_up=True,
    known=Known(
        of=_schwefel_2_26,
        ceiling=lambda n: Fraction(500 * n),  # no sine is above 1
        ceiling_on=((-500.0, 500.0),),
    ),
)
rastrigin = Function(
    name="rastrigin",
    title="Rastrigin",
    kernel=_rastrigin,
    box=((-5.12, 5.12),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f9",
    needs_room=True,
    cancels=(0.0, 10.0),
    known=Known(
        of=_rastrigin,
        ceiling=lambda n: n * (Fraction(512, 100) ** 2 + 20),
        ceiling_on=((-5.12, 5.12),),
        least_of_all_space=True,
        step=2.0**-49,
        condition="x² is first added to 10 or to −10 cos(2πx), as the formula reads from left to "
        "right and with 10n added at the end: both terms of size 10 are multiples of this step",
    ),
)
ackley = Function(
    name="ackley",
    title="Ackley",
    kernel=_ackley,
    box=((-32.0, 32.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f10",
    needs_room=True,
    cancels=(20.0 + math.e, 0.0),
    known=Known(
        of=_ackley,
        ceiling=lambda _: Fraction(23),  # 20 + e and no less than 0 taken away
        ceiling_on=((-32.0, 32.0),),
        least_of_all_space=True,
        step=2.0**-51,
        condition="the four terms are computed as doubles and then added, in whatever order: "
        "near the minimum each of them, 20 and e included, is a multiple of this step",
        cancelled=46,
    ),
)
griewank = Function(
    name="griewank",
    title="Griewank",
    kernel=_griewank,
    box=((-600.0, 600.0),),
    minimum=0.0,
    at=(0.0,),
    source=f"{_YAO}, f11",
    needs_room=True,
    cancels=(1.0, 0.0),
    known=Known(
        of=_griewank,
        ceiling=lambda n: n * Fraction(600**2, 4000) + 2,
        ceiling_on=((-600.0, 600.0),),
        least_of_all_space=True,
    ),
)
alpine_1 = Function(
    name="alpine_1",
    title="Alpine N.1",
    kernel=_alpine_1,
    box=((-10.0, 10.0),),
    minimum=0.0,
    at=(0.0,),  # one of the 8 zeros of every coordinate: x = 0 and sin(x) = -0.1
    source="Jamil & Yang (2013), Alpine 1",
    known=Known(
        of=_alpine_1,
        ceiling=lambda n: Fraction(11 * n),
        ceiling_on=((-10.0, 10.0),),
        least_of_all_space=True,
    ),
)
