import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import rankdata

from repro.statistics.places import TIES, Ties, place


@pytest.mark.parametrize("ties", TIES)
@given(st.lists(st.integers(0, 3), min_size=1, max_size=7))
def test_places_are_the_ranks_that_scipy_gives(ties: Ties, values: list[int]) -> None:
    columns = [np.array([float(value), -float(value)]) for value in values]

    found = [place(columns, own, ties) for own in range(len(values))]

    assert np.array_equal(found, rankdata(np.array(columns), axis=0, method=ties))


def test_place_of_a_fixed_value_is_among_all_draws_of_another() -> None:
    assert place([np.array([2.0]), np.array([1.0, 2.0, 3.0])], 0).tolist() == [2.0, 1.0, 1.0]
