"""Formulas by which a number follows from others: read as text, worked out in any arithmetic."""

import ast
import math
import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeVar

from repro.errors import DeclarationError
from repro.tables.true_numbers import exact

T = TypeVar("T")
MOST = 200  # characters of a formula
ALLOWED = "+, -, *, /, brackets, sqrt(), numbers and names"
ROOT = "sqrt"
_SIGNS = str.maketrans({"−": "-", "×": "*", "·": "*", "÷": "/", "√": ROOT})
_MARKS = re.compile(r"[A-Za-z0-9_.+\-*/()\s]+")


def formula_names(text: str) -> tuple[str, ...]:
    """Return the names in a formula, each once; DeclarationError where the text is none."""
    names = (node.id for node in ast.walk(_tree(text)) if isinstance(node, ast.Name))
    return tuple(name for name in dict.fromkeys(names) if name != ROOT)


def check_formula(text: str, known: Iterable[str]) -> None:
    """Raise DeclarationError unless the text is a formula with exactly the known names."""
    given, names = tuple(known), formula_names(text)
    if set(names) != set(given):
        message = (
            f"formula {text!r} has the names {', '.join(names) or 'none'}; given are "
            f"{', '.join(given) or 'none'}"
        )
        raise DeclarationError(message)


def worked_out(
    text: str,
    values: Mapping[str, T],
    *,
    number: Callable[[Fraction], T],
    root: Callable[[T], T],
) -> T:
    """Return the value in the arithmetic of `values`; `number` makes one of a constant.

    Only + - * / ( ) sqrt, numbers and names are ever run.
    """
    found: T = _value(_tree(text), values, number, root)
    return found


@lru_cache(maxsize=256)
def _tree(text: str) -> ast.expr:
    plain = text.translate(_SIGNS).strip()
    if len(text) > MOST or not _MARKS.fullmatch(plain):
        raise DeclarationError(_refused(text, "it"))
    try:
        tree = ast.parse(plain, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise DeclarationError(_refused(text, "it")) from None
    _check(text, tree)
    return tree


def _refused(text: str, part: str) -> str:
    return f"formula {text[:MOST]!r}: {part} is not made of {ALLOWED}"


def _check(text: str, node: ast.expr) -> None:
    """Raise DeclarationError for any node that is not on the list."""
    match node:
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div(), right=right):
            _check(text, left)
            _check(text, right)
        case ast.UnaryOp(op=ast.UAdd() | ast.USub(), operand=operand):
            _check(text, operand)
        case ast.Call(func=ast.Name(id="sqrt"), args=[argument], keywords=[]):
            _check(text, argument)
        case ast.Name(id=name) if name != ROOT:
            return
        case ast.Constant(value=int() | float() as value) if _is_number(value):
            return
        case _:
            raise DeclarationError(_refused(text, repr(ast.unparse(node))))


def _is_number(value: float) -> bool:
    try:
        return not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:
        return False


def _value(
    node: ast.expr,
    values: Mapping[str, Any],
    number: Callable[[Fraction], Any],
    root: Callable[[Any], Any],
) -> Any:  # noqa: ANN401 (numbers, arrays or spans: what the values are)
    match node:
        case ast.BinOp(left=left, op=operator, right=right):
            one, other = (_value(part, values, number, root) for part in (left, right))
            return _joined(operator, one, other)
        case ast.UnaryOp(op=sign, operand=operand):
            inner = _value(operand, values, number, root)
            return number(Fraction(0)) - inner if isinstance(sign, ast.USub) else inner
        case ast.Call(args=[argument]):
            return root(_value(argument, values, number, root))
        case ast.Name(id=name):
            return values[name]
        case ast.Constant(value=int() | float() as value):
            return number(Fraction(value) if isinstance(value, int) else exact(value))
    raise DeclarationError(_refused(ast.unparse(node), "it"))  # excluded when it was read


def _joined(operator: ast.operator, one: Any, other: Any) -> Any:  # noqa: ANN401 (as above)
    match operator:
        case ast.Add():
            return one + other
        case ast.Sub():
            return one - other
        case ast.Mult():
            return one * other
    return one / other
