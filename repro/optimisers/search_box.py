"""The box of a problem in every form that a search may want it in: array, scipy's Bounds, pairs."""

import inspect
import re
from collections.abc import Callable
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import Bounds

Vector = NDArray[np.float64]
_LOWER_AND_UPPER = re.compile(
    r"(typing\.)?[tT]uple\[(?P<part>[\w.]*(array|Array|Vector|[lL]ist|Sequence)\b.*), ?(?P=part)\]$"
)


class Box(np.ndarray, Bounds):  # type: ignore[misc]  # (both have an __init__)
    """Bounds of shape (n, 2) that scipy takes for its own `Bounds`; any part is a plain array."""

    def __new__(cls, bounds: Vector) -> Self:
        """Return a copy of the bounds."""
        made: Any = np.array(bounds, dtype=np.float64).view(cls)
        return made  # type: ignore[no-any-return]

    def __init__(self, bounds: Vector) -> None:
        """Take what `__new__` made: scipy's own initialiser has other arguments."""
        del bounds

    @property
    def lb(self) -> Vector:
        """Lower bounds, shape (n,), as scipy calls them."""
        return np.array(self.view(np.ndarray)[..., 0])

    @property
    def ub(self) -> Vector:
        """Upper bounds, shape (n,), as scipy calls them."""
        return np.array(self.view(np.ndarray)[..., 1])

    @property
    def keep_feasible(self) -> NDArray[np.bool_]:
        """Whether scipy keeps every point inside: it does."""
        return np.ones(len(self), dtype=bool)

    @property
    def pairs(self) -> list[tuple[float, float]]:
        """A (lower, upper) for each coordinate."""
        return pairs(self)

    @property
    def T(self) -> Any:  # noqa: ANN401, N802 (as NumPy calls it)
        """Lower, then upper bounds, shape (2, n)."""
        return np.asarray(self.view(np.ndarray)).T

    def __getitem__(self, index: Any) -> Any:  # noqa: ANN401 (whatever NumPy takes)
        """Return a part as a plain array."""
        return self.view(np.ndarray)[index]

    def __array_wrap__(self, array: Any, *_: Any) -> Any:  # noqa: ANN401 (as NumPy calls it)
        """Return what is computed from it as a plain array."""
        return np.asarray(array)[()]

    def __repr__(self) -> str:
        """Show the array."""
        return repr(self.view(np.ndarray))


def pairs(bounds: Vector) -> list[tuple[float, float]]:
    """Return a (lower, upper) for each coordinate."""
    return [(float(low), float(high)) for low, high in np.asarray(bounds)]


def as_wanted(bounds: Vector, parameter: inspect.Parameter | None) -> Any:  # noqa: ANN401
    """Return bounds as the annotation of a parameter asks for them, as a `Box` where it asks none.

    `list`, `tuple` and `Sequence` get pairs, a tuple of two arrays gets lower and upper bounds,
    scipy's `Bounds` gets that, `ndarray` a plain array.
    """
    wanted = "" if parameter is None else annotated(parameter)
    if wanted.endswith("Bounds"):
        return Bounds(*np.array(bounds).T)
    if _LOWER_AND_UPPER.match(wanted):
        return tuple(np.array(bounds).T.copy())
    if wanted.startswith(("list", "List", "tuple", "Tuple", "Sequence", "typing.", "collections.")):
        as_tuple = wanted.removeprefix("typing.").lower().startswith("tuple")
        return tuple(pairs(bounds)) if as_tuple else pairs(bounds)
    return np.array(bounds) if wanted.endswith("ndarray") else Box(bounds)


def annotated(parameter: inspect.Parameter) -> str:
    """Return the annotation of a parameter as text, "" where it has none."""
    given = parameter.annotation
    if given is inspect.Parameter.empty:
        return ""
    if isinstance(given, str):
        return given
    return (
        given.__name__ if isinstance(given, type) and not hasattr(given, "__args__") else str(given)
    )


def parameters(function: Callable[..., Any]) -> list[inspect.Parameter]:
    """Return the parameters of a callable; none where it does not say them."""
    try:
        return list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        return []


def says_parameters(function: Callable[..., Any]) -> bool:
    """Return whether a callable says how it is called: what is compiled may not."""
    try:
        inspect.signature(function)
    except (TypeError, ValueError):
        return False
    return True
