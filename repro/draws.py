"""Random numbers inside compiled loops: xoshiro256** on a state of four 64-bit words.

D. Blackman, S. Vigna, Scrambled linear pseudorandom number generators, ACM Transactions on
Mathematical Software 47(4) (2021) 36, doi:10.1145/3460772.
"""

import math

import numpy as np
from numpy.typing import NDArray

from repro.compiled import jit

_5, _7, _9, _11, _17, _19, _45, _57 = (np.uint64(n) for n in (5, 7, 9, 11, 17, 19, 45, 57))
_UNIT = 2.0**-53


def state_from(rng: np.random.Generator) -> NDArray[np.uint64]:
    """Return a fresh state of shape (4,), drawn from `rng` (which moves on by four draws)."""
    return rng.integers(0, 2**64, size=4, dtype=np.uint64)


@jit
def _scrambled(word):
    word = word * _5
    return ((word << _7) | (word >> _57)) * _9


@jit
def _stepped(a, b, c, d):
    shifted = b << _17
    c ^= a
    d ^= b
    b ^= c
    a ^= d
    return a, b, c ^ shifted, (d << _45) | (d >> _19)


@jit
def next_word(state):
    """Return the next 64 random bits and advance `state`."""
    word = _scrambled(state[1])
    state[0], state[1], state[2], state[3] = _stepped(state[0], state[1], state[2], state[3])
    return word


@jit
def uniform(state):
    """Return a draw from U[0, 1) with 53 random bits."""
    return (next_word(state) >> _11) * _UNIT


@jit
def fill(draws, words, state):
    """Fill `draws` with what as many calls of `uniform` return; `words` is room for as many words.

    Faster than the calls: the state stays in registers, and the second loop vectorises.
    """
    a, b, c, d = state[0], state[1], state[2], state[3]
    for k in range(len(draws)):
        words[k] = b
        a, b, c, d = _stepped(a, b, c, d)
    state[0], state[1], state[2], state[3] = a, b, c, d
    for k in range(len(draws)):
        draws[k] = (_scrambled(words[k]) >> _11) * _UNIT


@jit
def below(n, state):
    """Return an integer drawn from 0..n-1, as floor(n·U): MATLAB's `randi` less one."""
    return np.int64(n * uniform(state))


@jit
def normal(state):
    """Return a draw from N(0, 1) made of two uniform draws (Box and Muller's cosine branch)."""
    radius = math.sqrt(-2.0 * math.log(1.0 - uniform(state)))
    return radius * math.cos(2.0 * math.pi * uniform(state))
