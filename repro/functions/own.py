"""A cost of one's own as a problem."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from repro.determinism.plain_costs import called, check_cost
from repro.errors import DeclarationError

Vector = NDArray[np.float64]
Box = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class BoxProblem:
    """Minimise a cost of one's own in a box.

    `cost` is a function f(x) or f(x, data) in plain Python, of a point of shape (n,), or one of
    (x, data) that is compiled by `repro.determinism.compiled.jit`; it returns one number, the same
    whenever it is asked for the same point. `box` holds (lower, upper) per coordinate, `numbers`
    what the cost gets as data, shape (k,): both may be given as lists or arrays and are kept as
    tuples. `minimum` is the least cost in the box, where it is known.
    """

    cost: Any
    box: Any
    numbers: Any = ()
    minimum: float | None = None

    def __post_init__(self) -> None:
        """Raise DeclarationError for a cost, box, numbers or minimum that cannot be."""
        check_cost(self.cost)
        object.__setattr__(self, "box", _box(self.box))
        object.__setattr__(self, "numbers", _numbers(self.numbers))
        if self.minimum is not None and not math.isfinite(self.minimum):
            message = f"minimum {self.minimum} must be a finite number, or None where it is unknown"
            raise DeclarationError(message)

    @property
    def bounds(self) -> Vector:
        """Lower and upper bound of each coordinate, shape (n, 2)."""
        return np.array(self.box)

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """The cost."""
        return self.cost

    @property
    def data(self) -> Vector:
        """What the cost gets besides the point, shape (k,); a new array each time."""
        return np.array(self.numbers, dtype=np.float64)

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code."""
        return (called(self.cost), self.box, self.numbers)


def _box(given: Any) -> Box:  # noqa: ANN401 (whatever the user wrote)
    pairs = _array(given)
    sound = pairs.ndim == 2 and pairs.shape[1] == 2 and len(pairs) > 0
    if not (sound and np.isfinite(pairs).all() and (pairs[:, 0] <= pairs[:, 1]).all()):
        message = f"box must be finite pairs lower <= upper, one a coordinate, not {_shown(given)}"
        raise DeclarationError(message)
    return tuple((low, high) for low, high in pairs.tolist())


def _numbers(given: Any) -> tuple[float, ...]:  # noqa: ANN401
    values = _array(given)
    if values.ndim != 1:
        message = f"numbers must be one row of numbers, not {_shown(given)}"
        raise DeclarationError(message)
    return tuple(values.tolist())


def _array(given: ArrayLike) -> Vector:
    try:
        return np.array(given, dtype=np.float64)
    except (TypeError, ValueError):
        return np.empty((0, 0, 0))


def _shown(given: object) -> str:
    return " ".join(f"{given!r:.80}".split())
