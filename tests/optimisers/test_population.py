from collections import Counter
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.draws import state_from
from repro.optimisers.population import ANEW, CLIP, REFLECT, hold, some_of

BOX = np.array([[-1.0, 2.0], [0.0, 0.0], [5.0, 9.0]])
points = st.tuples(st.floats(-30, 30), st.floats(-3, 3), st.floats(-30, 30))


def held(point: tuple[float, ...], rule: float) -> NDArray[Any]:
    x = np.array(point)
    hold(x, BOX, rule, state_from(np.random.default_rng(1)))
    return x


@pytest.mark.parametrize("rule", [CLIP, ANEW, REFLECT])
@given(points)
def test_every_rule_brings_a_point_into_the_box_and_leaves_what_is_inside(
    rule: float, point: tuple[float, ...]
) -> None:
    found = held(point, rule)

    assert ((found >= BOX[:, 0]) & (found <= BOX[:, 1])).all()
    inside = (point >= BOX[:, 0]) & (point <= BOX[:, 1])
    assert found[inside].tolist() == np.array(point)[inside].tolist()


def test_a_mirror_image_is_as_far_inside_as_the_point_was_outside() -> None:
    assert held((-1.5, 0.0, 9.25), REFLECT).tolist() == [-0.5, 0.0, 8.75]


def test_a_mirror_image_beyond_the_other_bound_is_put_on_it() -> None:
    assert held((-4.5, 0.0, 14.0), REFLECT).tolist() == [2.0, 0.0, 5.0]


@pytest.mark.parametrize("count", [0, 1, 3, 7])
def test_some_are_different_and_each_is_as_likely(count: int) -> None:
    state = state_from(np.random.default_rng(5))
    draws = [some_of(7, count, state).tolist() for _ in range(7000)]

    assert all(len(set(draw)) == count for draw in draws)
    found = Counter(k for draw in draws for k in draw)
    # five standard deviations of a binomial count
    share = count / 7
    assert all(
        abs(found[k] - 7000 * share) <= 5 * (7000 * share * (1 - share)) ** 0.5 for k in range(7)
    )
