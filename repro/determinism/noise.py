"""Noise that a cost adds: drawn from a state that stands in the data of one run.

A cost gets a point and the data of its run, no generator. So the state of one stands at the start
of the data: four words of 64 bits, each as two numbers below 2^32, which doubles hold exactly,
where the bits of a word may be those of a number that is none. A state of zeros draws zeros.
"""

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.determinism.draws import drawn, state_from
from repro.determinism.seeds import generator

ROOM = 8
"""How many numbers at the start of the data hold the state."""

_32 = np.uint64(32)
_LOW = np.uint64(2**32 - 1)


def noise_of_run(stream: str) -> NDArray[np.float64]:
    """Return the state that draws the noise of the run with this name, shape (ROOM,)."""
    words = state_from(generator(stream, "noise"))  # what the search draws is not touched
    return np.column_stack([words >> _32, words & _LOW]).ravel().astype(np.float64)


@jit
def noise(data):
    """Return a draw from U[0, 1) by the state at the start of `data`, which moves on."""
    u, words = drawn((_word(data, 0), _word(data, 2), _word(data, 4), _word(data, 6)))
    for k in range(4):
        data[2 * k] = words[k] >> _32
        data[2 * k + 1] = words[k] & _LOW
    return u


@jit
def _word(data, k):
    return (np.uint64(data[k]) << _32) | np.uint64(data[k + 1])
