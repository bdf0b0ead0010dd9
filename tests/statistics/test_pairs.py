import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import wilcoxon

from repro.statistics.pairs import paired_p


@given(st.lists(st.integers(-6, 6), min_size=1, max_size=30).filter(any))
def test_p_value_of_pairs_is_that_of_scipy(differences: list[int]) -> None:
    d = np.array(differences, dtype=float)

    p, _ = paired_p(d)

    expected = wilcoxon(d[d != 0.0], method="asymptotic", correction=True).pvalue
    assert p == pytest.approx(expected, rel=1e-9)


def test_pairs_without_a_difference_are_not_different() -> None:
    assert paired_p(np.zeros(8)) == (1.0, False)


@given(st.lists(st.integers(-6, 6), min_size=1, max_size=12))
def test_test_is_the_same_from_either_side_but_for_who_is_lower(differences: list[int]) -> None:
    d = np.array(differences, dtype=float)

    (p, lower), (q, higher) = paired_p(d), paired_p(-d)

    assert p == q
    assert not (lower and higher)


def test_lower_sample_is_named() -> None:
    assert paired_p(np.array([-3.0, -2.0, 1.0]))[1]
