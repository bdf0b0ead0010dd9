"""Plain costs under compiled searches: as Python gives them, and refused in one line."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.determinism.plain_costs import PlainCost, callable_cost, check_cost
from repro.errors import DeclarationError, InputError
from repro.functions import BoxProblem
from repro.optimisers import WOA

Vector = NDArray[np.float64]
BOX = [(-1.0, 2.0)] * 3


def bowl(x: Vector) -> float:
    return float(((x - 0.25) ** 2).sum())


def _bowl(x: Vector, data: Vector) -> float:
    total = 0.0
    for value in x:
        total += (value - data[0]) ** 2
    return total


def _text(x: Vector, data: Vector) -> str:  # noqa: ARG001
    return str(x)


def _first(x: Vector) -> float:
    return float(x[0])


compiled_bowl, no_kernel, lonely = jit(_bowl), jit(_text), jit(_first)


def found(cost: Any, **fields: Any) -> Any:  # noqa: ANN401
    """Return what a compiled search finds."""
    problem = BoxProblem(cost=cost, box=BOX, **fields)
    return WOA().minimise(problem, population=5, iterations=20, rng=np.random.default_rng(1))


def test_plain_and_compiled_cost_of_one_formula_give_the_same_search() -> None:
    def in_python(x: Vector, data: Vector) -> float:
        return float(sum((value - data[0]) ** 2 for value in x.tolist()))

    plain, compiled = found(in_python, numbers=[0.25]), found(compiled_bowl, numbers=[0.25])

    assert plain.x.tobytes() == compiled.x.tobytes()
    assert plain.history.tobytes() == compiled.history.tobytes()


def test_what_a_plain_cost_raises_ends_the_search_at_once() -> None:
    asked = []

    def breaking(x: Vector) -> float:
        asked.append(x)
        if len(asked) == 7:
            message = "the model broke down"
            raise ArithmeticError(message)
        return 1.0

    with pytest.raises(ArithmeticError, match="the model broke down"):
        found(breaking)

    assert len(asked) == 7


@pytest.mark.parametrize("value", [None, "low", np.zeros(1), [1.0], 1j])
def test_cost_that_is_not_one_number_is_told_with_its_point(value: object) -> None:
    with pytest.raises(InputError, match=r"the cost .* returned .*, not one number, at x = \["):
        found(lambda _x: value)


@pytest.mark.parametrize("value", [1, True, np.float32(1.0), np.int64(1), np.array(1.0)])
def test_every_number_is_a_cost(value: object) -> None:
    assert found(lambda _x: value).cost == 1.0


def test_cost_may_keep_or_change_the_point_that_it_gets() -> None:
    def spoiling(x: Vector) -> float:
        value = bowl(x)
        x[:] = 99.0
        return value

    assert found(spoiling).x.tobytes() == found(bowl).x.tobytes()


def test_search_within_a_cost_asks_its_own_cost() -> None:
    def nested(x: Vector) -> float:
        return bowl(x) + 0.0 * float(found(lambda y: float(y.sum())).cost)

    assert found(nested).x.tobytes() == found(bowl).x.tobytes()


@pytest.mark.parametrize(
    ("cost", "fault"),
    [
        (3.0, "the cost float is no function: it must be f"),
        (lambda: 1.0, r"cannot be called as f\(x\) or f\(x, data\)"),
        (lambda _x, _y, _z: 1.0, r"cannot be called as f\(x\) or f\(x, data\)"),
        (lonely, r"the compiled cost _first\(x.* cannot be called as f\(x, data\)"),
    ],
)
def test_what_is_no_cost_is_refused_where_it_is_declared(cost: object, fault: str) -> None:
    with pytest.raises(DeclarationError, match=fault):
        check_cost(cost)


def test_kernel_that_does_not_compile_is_told_in_one_line() -> None:
    with pytest.raises(InputError, match=r"_text \(test_plain_costs.py, line \d+\) cann") as raised:
        found(no_kernel)

    assert "\n" not in str(raised.value)


def test_second_argument_with_a_default_is_left_to_it() -> None:
    assert not PlainCost.of(lambda x, scale=2.0: scale * x[0]).takes_data
    assert callable_cost(lambda x, data: x[0] + data[0])(np.ones(1), np.ones(1)) == 2.0
