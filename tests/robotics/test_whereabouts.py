import numpy as np
import pytest

from repro.robotics.kinematics import Convention
from repro.robotics.skeleton import skeleton
from repro.robotics.whereabouts import below, corners_along


@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("entries", [3, 4])
def test_corners_of_many_postures_are_those_of_each(convention: Convention, entries: int) -> None:
    rng = np.random.default_rng(3)
    dh, angles = rng.normal(size=(5, entries)), rng.normal(size=(4, 5))

    found = corners_along(dh, angles, convention)

    for corners, q in zip(found, angles, strict=True):
        assert corners == pytest.approx(skeleton(dh, q, convention).corners)


def test_time_below_a_level_ends_where_the_curve_crosses_it() -> None:
    found = below(np.array([0.0, 1.0, 2.0, 4.0]), np.array([1.0, -1.0, -1.0, 3.0]))

    assert found.lasting == pytest.approx(0.5 + 1.0 + 0.5)
    assert (found.least, found.at) == (-1.0, 1.0)


def test_time_below_a_level_of_a_sine_is_half_of_its_period() -> None:
    times = np.linspace(0, 2 * np.pi, 1000)

    assert below(times, np.sin(times)).lasting == pytest.approx(np.pi, rel=1e-3)
