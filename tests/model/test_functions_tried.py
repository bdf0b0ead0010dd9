from dataclasses import replace
from fractions import Fraction

import pytest

from repro.functions import FUNCTIONS, Function, Known
from repro.model.functions_tried import bound_faults, function_faults
from tests.small_papers import EXPERIMENT, PAPER

SPHERE = FUNCTIONS["sphere"]


@pytest.mark.parametrize(
    ("function", "says"),
    [
        (replace(SPHERE, minimum=1.0), "sphere is 0 at its minimiser, its minimum is 1"),
        (replace(SPHERE, minimum=1e6, at=(1000.0,)), "below 1e+06"),
        (
            replace(SPHERE, known=replace(SPHERE.known, ceiling=lambda _: Fraction(2))),
            "sphere is 30000 at [-100., -100., -100.], above its ceiling 2",
        ),
    ],
)
def test_a_bound_that_a_point_breaks_is_a_fault(function: Function, says: str) -> None:
    faults = list(function_faults(function.problem(3)))

    assert any(says in fault for fault in faults)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_what_is_said_of_our_functions_holds(name: str) -> None:
    function = FUNCTIONS[name]

    assert list(function_faults(function.problem(function.fixed_dimension or 30))) == []


def test_a_ceiling_of_another_kernel_or_box_claims_nothing() -> None:
    low = Known(of=SPHERE.kernel, ceiling=lambda _: Fraction(2), ceiling_on=((-1.0, 1.0),))
    wide = replace(low, ceiling_on=SPHERE.box)

    assert list(function_faults(replace(SPHERE, known=low).problem(3))) == []
    assert list(function_faults(replace(SPHERE, known=replace(wide, of=None)).problem(3))) == []
    assert list(function_faults(replace(SPHERE, known=wide).problem(3))) != []


def test_a_fault_is_named_once_with_its_place() -> None:
    broken = replace(SPHERE, minimum=1.0).problem(3)
    twice = replace(EXPERIMENT, problems={"F": broken, "G": broken})
    paper = replace(PAPER)
    object.__setattr__(paper, "experiments", (twice,))

    (fault,) = bound_faults(paper)
    assert fault.startswith(f"experiment {EXPERIMENT.name!r}, problem 'F': sphere is 0 at")
