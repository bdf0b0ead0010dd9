from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.errors import InputError
from repro.functions import BoxProblem
from repro.optimisers import Result
from repro.optimisers.own_search import OwnSearch, as_optimiser

Vector = NDArray[np.float64]
SLOPE = BoxProblem(cost=lambda x: float(x.sum()), box=[(0.001, 1.0)] * 2)


def sampling(
    cost: Callable[[Vector], float], bounds: Vector, budget: int, rng: np.random.Generator
) -> Vector:
    points = [rng.uniform(bounds[:, 0], bounds[:, 1]) for _ in range(budget)]
    best: Vector = min(points, key=cost)
    return best


def fleeing(
    cost: Callable[[Vector], float],
    bounds: Vector,
    budget: int,  # noqa: ARG001
    rng: np.random.Generator,  # noqa: ARG001
) -> Vector:
    cost(bounds[:, 0] - 5.0)
    return bounds[:, 0]


def found(search: Any, **budget: int) -> Result:  # noqa: ANN401
    """Return what a search finds on the slope."""
    return OwnSearch(search=search).minimise(
        SLOPE, population=4, rng=np.random.default_rng(3), **budget
    )


def test_function_is_an_optimiser_by_iterations_or_evaluations() -> None:
    by_iterations, by_evaluations = found(sampling, iterations=5), found(sampling, evaluations=20)

    assert by_iterations.x.tobytes() == by_evaluations.x.tobytes()
    assert (by_iterations.evaluations, by_iterations.history.shape) == (20, (5,))


def test_function_that_leaves_the_box_is_told_so() -> None:
    with pytest.raises(InputError, match=r"outside the box: x\[0\] is -4.999"):
        found(fleeing, iterations=5)


def test_function_that_declares_it_is_let_out_of_the_box() -> None:
    out = OwnSearch(search=fleeing, leaves_box=True)

    result = out.minimise(SLOPE, population=4, iterations=5, rng=np.random.default_rng(3))

    assert result.cost == pytest.approx(2 * (0.001 - 5.0))


def test_error_of_a_cost_that_a_search_swallows_is_told_all_the_same() -> None:
    def swallowing(cost: Any, bounds: Vector, *_: object) -> Vector:  # noqa: ANN401
        with suppress(ArithmeticError):
            cost(bounds[:, 0])
        return bounds[:, 1]

    def breaking(x: Vector) -> float:
        if x[0] < 0.5:
            message = "the model broke down"
            raise ArithmeticError(message)
        return 1.0

    problem = BoxProblem(cost=breaking, box=[(0.0, 1.0)])
    with pytest.raises(ArithmeticError, match="broke down"):
        OwnSearch(search=swallowing).minimise(
            problem, population=4, iterations=5, rng=np.random.default_rng(3)
        )


def test_neither_form_of_a_search_is_refused_with_its_place() -> None:
    with pytest.raises(ValueError, match=r"test, algorithm 'X': .* neither an object with"):
        as_optimiser(3, "test, algorithm 'X'")
    with pytest.raises(ValueError, match=r"cannot be called as f\(cost, bounds, budget, rng\)"):
        as_optimiser(lambda _cost: 1, "test, algorithm 'X'")
