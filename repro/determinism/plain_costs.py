"""Costs in plain Python, called out of compiled searches as compiled costs are.

A compiled search takes a compiled function of (point, data). For a plain cost it gets one that goes
back into the interpreter and calls the cost there, untranslated: it gives the bits that it gives
when it is called by hand, and what it raises ends the search.
"""

import inspect
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from numbers import Real
from typing import Any, Self

import numba
import numpy as np
from numba.core.dispatcher import Dispatcher
from numpy.typing import NDArray

from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError, InputError

Vector = NDArray[np.float64]
_SHOWN = 4  # coordinates of a point that a message shows
_ASKED = threading.local()  # the plain cost that the search of this thread asks


@dataclass(frozen=True, slots=True, kw_only=True)
class PlainCost:
    """A plain function f(x) or f(x, data) as a cost of (point, data); see `of`."""

    function: Callable[..., Any]
    takes_data: bool

    @classmethod
    def of(cls, function: Any) -> Self:  # noqa: ANN401 (whatever the user wrote)
        """Return the cost; DeclarationError for what cannot be called with one point.

        A second argument that has a default is left to it.
        """
        if isinstance(function, cls):
            return function
        if not callable(function):
            message = f"the cost {called(function)} is no function: it must be f(x) or f(x, data)"
            raise DeclarationError(message)
        try:
            signature = inspect.signature(function)
        except (TypeError, ValueError):  # a built-in that does not say how it is called
            return cls(function=function, takes_data=False)
        for count in (1, 2):
            if _binds(signature, count):
                return cls(function=function, takes_data=count == 2)
        message = f"the cost {called(function)}{signature} cannot be called as f(x) or f(x, data)"
        raise DeclarationError(message)

    @property
    def __name__(self) -> str:
        """The name of the function."""
        return called(self.function)

    def __call__(self, x: Vector, data: Vector) -> float:
        """Return the cost of a point; InputError for what is not one real number.

        The function gets a copy of the point, which it may keep or change.
        """
        point = np.array(x)
        value = self.function(point, data) if self.takes_data else self.function(point)
        if isinstance(value, Real) or (isinstance(value, np.ndarray) and value.shape == ()):
            return float(value)
        where = ", ".join(map(str, x[:_SHOWN].tolist())) + (", …" if len(x) > _SHOWN else "")
        returned = " ".join(f"{value!r:.40}".split())
        message = f"the cost {self.__name__} returned {returned}, not one number, at x = [{where}]"
        raise InputError(message)


def called(function: Any) -> str:  # noqa: ANN401
    """Return the name of a function, of the class of what is called like one."""
    return str(getattr(function, "__qualname__", type(function).__qualname__))


def _binds(signature: inspect.Signature, count: int) -> bool:
    try:
        signature.bind(*range(count))
    except TypeError:
        return False
    return True


def is_compiled(kernel: Any) -> bool:  # noqa: ANN401 (numba ships no types)
    """Return whether a cost is compiled, so that calling it needs no interpreter."""
    return isinstance(kernel, Dispatcher)


def releases_interpreter(kernel: Any) -> bool:  # noqa: ANN401
    """Return whether a cost is compiled so that other threads run beside it."""
    return is_compiled(kernel) and bool(kernel.targetoptions.get("nogil"))


def check_cost(kernel: Any) -> None:  # noqa: ANN401
    """Raise DeclarationError for what is no cost, compiled or plain."""
    if not is_compiled(kernel):
        PlainCost.of(kernel)
    elif not _binds(inspect.signature(kernel.py_func), 2):
        signature = inspect.signature(kernel.py_func)
        message = f"the compiled cost {kernel.__name__}{signature} cannot be called as f(x, data)"
        raise DeclarationError(message)


def callable_cost(kernel: Any) -> Callable[[Vector, Vector], float]:  # noqa: ANN401
    """Return a cost, compiled or plain, as a function of (point, data) to call from Python.

    Raises DeclarationError for what is no cost, InputError for what cannot be compiled.
    """
    cost: Callable[[Vector, Vector], float]
    cost = ready(kernel, COST) if is_compiled(kernel) else PlainCost.of(kernel)
    return cost


@contextmanager
def passing(kernel: Any) -> Iterator[Any]:  # noqa: ANN401
    """Yield a cost as what a compiled search takes; raises as `callable_cost`.

    Within the block this thread's searches ask this cost and no other.
    """
    if is_compiled(kernel):
        yield ready(kernel, COST)
        return
    before = getattr(_ASKED, "cost", None)
    _ASKED.cost = PlainCost.of(kernel)
    try:
        yield _ready_in_python()
    finally:
        _ASKED.cost = before


def _ready_in_python() -> Any:  # noqa: ANN401
    with warnings.catch_warnings():  # that it holds the interpreter is known
        warnings.simplefilter("ignore", numba.NumbaWarning)
        return ready(_in_python, COST)


def _ask(x: Vector, data: Vector) -> float:
    cost: PlainCost = _ASKED.cost
    return cost(x, data)


@numba.njit(nogil=True)  # type: ignore[untyped-decorator]
def _in_python(x: Vector, data: Vector) -> float:
    with numba.objmode(value="float64"):
        value = _ask(x, data)
    return value  # noqa: RET504 (numba takes no return out of the block)
