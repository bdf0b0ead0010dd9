"""The function with noise: its value at a point is another one at every evaluation.

X. Yao, Y. Liu, G. Lin, Evolutionary programming made faster, IEEE Transactions on Evolutionary
Computation 3(2) (1999) 82-102, doi:10.1109/4235.771163.
"""

from fractions import Fraction

from repro.determinism.compiled import jit
from repro.determinism.noise import ROOM, noise
from repro.functions.function import Function
from repro.functions.known import Known


@jit
def _quartic_noise(x, data):
    total = 0.0
    for i in range(len(x)):
        square = x[i] * x[i]
        total += (i + 1.0) * (square * square)
    return total + noise(data)


quartic_noise = Function(
    name="quartic_noise",
    title="Quartic with noise",
    kernel=_quartic_noise,
    box=((-1.28, 1.28),),
    minimum=0.0,
    at=(0.0,),
    source="Yao, Liu & Lin (1999), f7",
    noise=1.0,
    noise_room=ROOM,
    known=Known(
        of=_quartic_noise,
        # the sum of i up to n, and noise below 1
        ceiling=lambda n: Fraction(n * (n + 1), 2) * Fraction(128, 100) ** 4 + 1,
        ceiling_on=((-1.28, 1.28),),
        least_of_all_space=True,
    ),
)
