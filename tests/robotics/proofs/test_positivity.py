from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.robotics.proofs.positivity import derivative, difference, positive, product

Rationals = list[Fraction]
RATIONALS = st.lists(st.fractions(-5, 5, max_denominator=20), min_size=1, max_size=6)


def value(p: Rationals, u: Fraction) -> Fraction:
    return sum((entry * u**k for k, entry in enumerate(p)), Fraction(0))


@given(RATIONALS, RATIONALS, st.fractions(0, 1))
def test_products_and_differences_are_those_of_the_values(
    p: Rationals, q: Rationals, u: Fraction
) -> None:
    assert value(product(p, q), u) == value(p, u) * value(q, u)
    assert value(difference(p, q), u) == value(p, u) - value(q, u)


@given(RATIONALS)
def test_derivative_of_a_square_is_twice_the_product(p: Rationals) -> None:
    twice = [2 * entry for entry in product(p, derivative(p) or [Fraction(0)])]

    assert not any(difference(derivative(product(p, p)), twice))


@given(RATIONALS, st.fractions(0, 1))
def test_what_is_proved_positive_is_positive_everywhere(p: Rationals, u: Fraction) -> None:
    if positive(p):
        assert value(p, u) > 0


@given(RATIONALS)
def test_square_lifted_above_zero_is_proved_positive(p: Rationals) -> None:
    square = product(p, p)

    assert positive([square[0] + Fraction(1, 1000), *square[1:]])


@pytest.mark.parametrize(
    "p", [(1, -4, 4), (1, -3, 2), (-1,), (0, 1), (1, -1), (Fraction(1, 4), -1, Fraction(99, 100))]
)
def test_polynomial_that_reaches_zero_is_not_proved_positive(p: tuple[Fraction, ...]) -> None:
    assert not positive([Fraction(entry) for entry in p])


@pytest.mark.parametrize("gap", [1e-3, 1e-6, 1e-9])
def test_polynomial_just_above_zero_is_proved_positive(gap: float) -> None:
    third = Fraction(1, 3)
    square = [third**2 + Fraction(gap), -2 * third, Fraction(1)]

    assert positive(square)
    assert min(np.polyval([1, -2 / 3, 1 / 9 + gap], np.linspace(0, 1, 1001))) > 0
