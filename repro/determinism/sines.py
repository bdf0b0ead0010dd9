"""Cosine and squared sine in plain arithmetic, which a compiler can do for several numbers at once.

A C library's sine takes one number at a time, and its last bits are the library's own. Here are
only sums, products, comparisons and rounding to whole numbers, which IEEE 754 fixes to the last
bit: every vector width and every machine gives the same values. They lie within 4e-16 (the squared
sine) and 8e-16 (the cosine) of the true ones.
"""

import math

import numpy as np

from repro.determinism.compiled import jit

LARGEST = 2.0**20 * math.pi
"""Angle beyond which `squared_sine` stands still; boxes of benchmark functions end at 480."""

_TO_HALF_TURNS = 1.0 / math.pi
# pi in three parts; the first two have 33 bits, so that up to 2^20 times them is exact
_PI_1, _PI_2 = float.fromhex("0x1.921fb544p+1"), float.fromhex("0x1.0b4611a6p-33")
_PI_3 = float.fromhex("0x1.3198a2e037073p-68")
# Taylor: sin(d) / d in powers of d²; what is left out is below 6e-17 up to d = pi / 4
_1, _2, _3, _4, _5, _6, _7 = ((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 8))


@jit
def _sine(d):
    """Return sin(d) for d from 0 to pi / 4."""
    z = d * d
    zz = z * z
    low = (1.0 + _1 * z) + (_2 + _3 * z) * zz
    high = (_4 + _5 * z) + (_6 + _7 * z) * zz
    return d * (low + high * (zz * zz))


@jit
def cosine_of_turns(turns):
    """Return cos(2 pi times `turns`): 1 - 2 sin² of half the angle."""
    part = abs(turns - np.rint(turns))  # exact, 0 to 1/2
    steep = part > 0.25
    sine = _sine(math.pi * (0.5 - part if steep else part))
    return 2.0 * sine * sine - 1.0 if steep else 1.0 - 2.0 * sine * sine


@jit
def squared_sine(angle):
    """Return sin² of an angle in radians; that of ±LARGEST for any angle beyond it."""
    angle = min(max(angle, -LARGEST), LARGEST)
    turns = np.rint(angle * _TO_HALF_TURNS)
    rest = abs(((angle - turns * _PI_1) - turns * _PI_2) - turns * _PI_3)  # 0 to pi / 2
    steep = rest > math.pi / 4.0
    sine = _sine(math.pi / 2.0 - rest if steep else rest)
    return 1.0 - sine * sine if steep else sine * sine
