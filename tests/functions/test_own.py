from typing import Any

import numpy as np
import pytest

from repro.errors import DeclarationError
from repro.functions import BoxProblem, Function


def slope(x: Any) -> float:  # noqa: ANN401
    return float(x.sum())


@pytest.mark.parametrize("box", [((-1, 2), (0, 0)), [[-1, 2], [0, 0]], np.array([[-1, 2], [0, 0]])])
def test_box_may_be_tuples_lists_or_an_array_of_any_numbers(box: Any) -> None:  # noqa: ANN401
    problem = BoxProblem(cost=slope, box=box)

    assert problem.box == ((-1.0, 2.0), (0.0, 0.0))
    assert problem.bounds.dtype == np.float64


@pytest.mark.parametrize(
    "box",
    [(), (-1, 2), ((1, -1),), ((-1, np.inf),), ((np.nan, 1),), (("a", 1),), None, [[1], [2, 3]]],
)
def test_box_that_cannot_be_is_refused(box: Any) -> None:  # noqa: ANN401
    with pytest.raises(DeclarationError, match="box must be finite pairs lower <= upper") as raised:
        BoxProblem(cost=slope, box=box)

    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("numbers", ["one", [[1.0]], 3.0])
def test_numbers_that_are_no_row_are_refused(numbers: Any) -> None:  # noqa: ANN401
    with pytest.raises(DeclarationError, match="numbers must be one row of numbers"):
        BoxProblem(cost=slope, box=[(0, 1)], numbers=numbers)


def test_function_takes_a_plain_kernel() -> None:
    function = Function(
        name="slope",
        title="Slope",
        kernel=slope,
        box=((0.0, 1.0),),
        minimum=0.0,
        at=(0.0,),
        source="made up",
    )

    assert function(np.array([1.0, 2.0])) == 3.0
