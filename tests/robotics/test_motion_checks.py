import pytest

from repro.errors import DeclarationError
from repro.robotics.motion_checks import check_motion


def test_motion_that_can_be_passes() -> None:
    check_motion(((0.0, 1.0), (1.0, 1.0)), [(1.0, 2.0)], (0.1, 0.1), called="points")


@pytest.mark.parametrize("limit", [0.0, -1.0, float("inf"), float("nan")])
def test_limit_that_cannot_be_is_refused(limit: float) -> None:
    with pytest.raises(DeclarationError, match="limits must be above 0 and finite"):
        check_motion(((0.0,), (1.0,)), [(1.0,), (limit,)], (0.1, 9.0), called="points")


@pytest.mark.parametrize("value", [float("inf"), float("nan")])
def test_points_are_named_as_the_problem_calls_them(value: float) -> None:
    with pytest.raises(DeclarationError, match="nodes must be finite angles"):
        check_motion(((0.0,), (value,)), [(1.0,)], (0.1, 9.0), called="nodes")
