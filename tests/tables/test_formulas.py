import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.errors import DeclarationError
from repro.tables.formulas import check_formula, formula_names, worked_out

LEAVES = st.sampled_from(["a", "b", "2", "0.5", "1e3"])
FORMULAS = st.recursive(
    LEAVES,
    lambda parts: (
        st.builds("({} {} {})".format, parts, st.sampled_from("+-*/"), parts)
        | st.builds("-{}".format, parts)
        | st.builds("sqrt({})".format, parts)
    ),
    max_leaves=8,
)


def in_floats(text: str, **values: float) -> float:
    return worked_out(text, values, number=float, root=math.sqrt)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("100 * (a - b) / a", 25.0),
        ("100 × (a − b) ÷ a", 25.0),
        ("√(a + b + 2)", 3.0),
        ("-a + +b", -1.0),
        ("a - b - 1", 0.0),
        ("2 * -b", -6.0),
    ],
)
def test_formula_is_worked_out_as_it_is_written(text: str, value: float) -> None:
    assert in_floats(text, a=4.0, b=3.0) == value


@given(FORMULAS)
def test_formula_has_the_value_that_python_gives_it(text: str) -> None:
    names = {"a": 3.0, "b": 7.0, "sqrt": math.sqrt}
    try:
        expected = eval(text, {}, names)  # noqa: S307 (made of the signs above alone)
    except (ValueError, ZeroDivisionError):
        return

    assert in_floats(text, a=3.0, b=7.0) == pytest.approx(expected, rel=1e-12, abs=1e-12)


def test_constants_are_exact_decimals() -> None:
    found = worked_out("0.1 + a", {"a": Fraction(1, 5)}, number=Fraction, root=lambda each: each)

    assert found == Fraction(3, 10)


def test_formula_of_arrays_is_an_array() -> None:
    values = {"a": np.array([1.0, 3.0])}

    found = worked_out("a / 2", values, number=lambda each: np.array(float(each)), root=np.sqrt)

    assert found.tolist() == [0.5, 1.5]


@pytest.mark.parametrize(
    "text",
    ["", "a +", "a ** 2", "a.real", "a[0]", "__import__('os')", "exit()", "sqrt", "sqrt(a, b)",
     "sqrt(x=a)", "lambda: a", "a if b else a", "a < b", "a, b", "'a'", "1j", "True", "1e999",
     "a\n+ b; c", "(a := 1)", "f(a)", "a" * 201, "(" * 199, "a\0", "sqrt.a(b)", "[a]"],
)  # fmt: skip
def test_nothing_else_is_a_formula(text: str) -> None:
    with pytest.raises(DeclarationError, match="is not made of "):
        formula_names(text)


def test_names_are_exactly_those_that_are_given() -> None:
    check_formula("(a + b) / a", ("b", "a"))

    for known in (("a",), ("a", "b", "c"), ()):
        with pytest.raises(DeclarationError, match="has the names a, b; given are"):
            check_formula("a + b", known)
