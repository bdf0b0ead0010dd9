import math
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.determinism.draws import (
    below,
    drawn,
    drawn_below,
    fill,
    held,
    next_word,
    normal,
    put_back,
    state_from,
    uniform,
)
from repro.optimisers.tent_map import tent

WORD = 2**64
State = NDArray[np.uint64]
tented: Callable[[float], float] = tent.py_func


def rotated(x: int, k: int) -> int:
    return (x << k | x >> (64 - k)) % WORD


def words(state: list[int], count: int) -> list[int]:
    """Return the next words of xoshiro256**, with Python's unbounded integers."""
    a, b, c, d = state
    found = []
    for _ in range(count):
        found.append(rotated(b * 5 % WORD, 7) * 9 % WORD)
        c, d, old = c ^ a, d ^ b, b
        a, b = a ^ d, b ^ c
        c, d = c ^ (old << 17) % WORD, rotated(d, 45)
    return found


def array(state: list[int]) -> State:
    return np.array(state, dtype=np.uint64)


@jit
def held_pair(n: int, state: State) -> tuple[float, int]:
    """Return one number and one integer below n, drawn from a held state."""
    words = held(state)
    u, words = drawn(words)
    k, words = drawn_below(n, words)
    put_back(words, state)
    return u, k


def test_words_are_the_published_ones() -> None:
    state = array([1, 2, 3, 4])

    found = [int(next_word(state)) for _ in range(4)]

    # xoshiro256starstar.c by the generator's authors, prng.di.unimi.it
    assert found == [11520, 0, 1509978240, 1215971899390074240]


@given(st.lists(st.integers(0, WORD - 1), min_size=4, max_size=4))
def test_words_are_those_of_plain_integers(start: list[int]) -> None:
    state = array(start)

    assert [int(next_word(state)) for _ in range(50)] == words(start, 50)


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4, 7, 8, 29, 60, 180])
def test_filling_draws_the_same_numbers_as_one_call_after_the_other(count: int) -> None:
    at_once, one_by_one = array([1, 2, 3, 4]), array([1, 2, 3, 4])
    draws = np.empty(count)

    fill(draws, np.empty(count, dtype=np.uint64), at_once)

    assert draws.tolist() == [uniform(one_by_one) for _ in range(count)]
    assert at_once.tolist() == one_by_one.tolist()


@given(st.lists(st.integers(0, WORD - 1), min_size=4, max_size=4), st.integers(1, 1000))
def test_a_state_held_in_registers_draws_the_same_numbers(start: list[int], n: int) -> None:
    state, same = array(start), array(start)

    assert held_pair(n, state) == (float(uniform(same)), int(below(n, same)))
    assert state.tolist() == same.tolist()


def test_state_is_four_words_of_the_generator_and_moves_it_on() -> None:
    rng, same = np.random.default_rng(3), np.random.default_rng(3)

    first, second = state_from(rng), state_from(rng)

    assert first.shape == (4,)
    assert first.tolist() == state_from(same).tolist()
    assert first.tolist() != second.tolist()


@given(st.lists(st.integers(0, WORD - 1), min_size=4, max_size=4))
def test_uniform_is_the_upper_53_bits_of_a_word(start: list[int]) -> None:
    drawn = float(uniform(array(start)))

    assert drawn == (words(start, 1)[0] >> 11) / 2**53
    assert 0.0 <= drawn < 1.0


def test_uniform_of_the_largest_word_is_below_one() -> None:
    rotated_back = rotated((WORD - 1) * pow(9, -1, WORD) % WORD, 57)
    state = array([1, rotated_back * pow(5, -1, WORD) % WORD, 3, 4])

    assert float(uniform(state)) == 1.0 - 2.0**-53


@pytest.mark.parametrize("n", [1, 2, 7, 30])
def test_integers_below_n_are_the_floor_of_n_times_a_uniform_draw(n: int) -> None:
    state, same = array([1, 2, 3, 4]), array([1, 2, 3, 4])

    drawn = [int(below(n, state)) for _ in range(500)]

    assert drawn == [math.floor(n * float(uniform(same))) for _ in range(500)]
    assert set(drawn) == set(range(n))


def test_normal_draws_have_the_moments_of_the_normal_distribution() -> None:
    n = 20_000
    state = state_from(np.random.default_rng(11))

    x = np.array([float(normal(state)) for _ in range(n)])

    # Standard errors of the four moments of n draws. Each bound is 5 of them, so that another
    # seed fails with chance 4 * 5.7e-7 = 2.3e-6 (Bonferroni, normal approximation).
    errors = np.array([1.0, math.sqrt(2.0), math.sqrt(15.0), math.sqrt(96.0)]) / math.sqrt(n)
    moments = np.array([x.mean(), (x**2).mean(), (x**3).mean(), (x**4).mean()])
    assert (np.abs(moments - [0.0, 1.0, 0.0, 3.0]) < 5.0 * errors).all()


def test_normal_is_the_cosine_branch_of_box_and_muller() -> None:
    state, same = array([1, 2, 3, 4]), array([1, 2, 3, 4])

    drawn = float(normal(state))

    u, v = float(uniform(same)), float(uniform(same))
    assert drawn == math.sqrt(-2.0 * math.log(1.0 - u)) * math.cos(2.0 * math.pi * v)
    assert state.tolist() == same.tolist()


@given(st.fractions(0, 1, max_denominator=10**6).map(float))
def test_tent_map_rises_to_one_and_falls_again(z: float) -> None:
    exact = 1 - 2 * abs(Fraction(z) - Fraction(1, 2))

    assert tented(z) == pytest.approx(float(exact), abs=1e-16)


@given(st.integers(0, 2**53 - 1))
@example(1)
@example(2**53 - 1)
def test_tent_orbit_of_any_uniform_draw_reaches_zero_in_54_steps(k: int) -> None:
    # Doubling drops a bit, and a draw has 53: a Tent sequence is no source of chaos in float64.
    z = k * 2.0**-53

    for _ in range(54):
        z = tented(z)

    assert z == 0.0


def test_tent_orbit_of_the_smallest_draw_needs_all_54_steps() -> None:
    z = 2.0**-53

    for _ in range(53):
        z = tented(z)

    assert z == 1.0
