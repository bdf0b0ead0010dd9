"""Random numbers inside compiled loops: xoshiro256** on a state of four 64-bit words.

D. Blackman, S. Vigna, Scrambled linear pseudorandom number generators, ACM Transactions on
Mathematical Software 47(4) (2021) 36, doi:10.1145/3460772.
"""

import math

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit

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
def _stepped(words):
    a, b, c, d = words
    shifted = b << _17
    c ^= a
    d ^= b
    b ^= c
    a ^= d
    return a, b, c ^ shifted, (d << _45) | (d >> _19)


@jit
def held(state):
    """Return the four words of `state`, which a loop of many draws keeps in registers."""
    return state[0], state[1], state[2], state[3]


@jit
def put_back(words, state):
    """Write words that were `held` into `state`."""
    state[0], state[1], state[2], state[3] = words


@jit
def drawn(words):
    """Return a draw from U[0, 1), as `uniform` does, and the words after it."""
    return (_scrambled(words[1]) >> _11) * _UNIT, _stepped(words)


@jit
def drawn_below(n, words):
    """Return an integer from 0..n-1, as `below` does, and the words after it.

    It is unsigned: an array that it indexes need not look whether it counts from the end.
    """
    u, words = drawn(words)
    return np.uint64(np.int64(n * u)), words


@jit
def next_word(state):
    """Return the next 64 random bits and advance `state`."""
    word = _scrambled(state[1])
    put_back(_stepped(held(state)), state)
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
    present = held(state)
    for k in range(len(draws)):
        words[k] = present[1]
        present = _stepped(present)
    put_back(present, state)
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
