"""The point in what other people's searches return, in whatever form it comes."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

NAMES = (
    *("x", "X", "solution", "xbest", "x_best", "best_x", "best_solution", "best_params"),
    *("best_position", "bestIndividual", "best_individual", "best", "gbest", "g_best", "position"),
    *("point", "params", "parameters", "value"),
)
"""What objects and mappings call the point, or what holds it; the first that fits is taken."""
_DEEP = 3  # objects that hold each other, as a model holds its best agent


def point_in(returned: Any, size: int) -> Any:  # noqa: ANN401 (whatever a search returns)
    """Return the point of `size` coordinates in what was returned; that itself where there is none.

    It may stand as numbers of shape (n,), (n, 1) or (1, n), in an object or mapping under one of
    the NAMES, in a mapping whose keys count the coordinates, as x0, x1 do, or among the parts of a
    tuple or list.
    """
    if size == 1 and isinstance(returned, int | float) and not isinstance(returned, bool):
        return np.array([returned], dtype=np.float64)
    found = _found(returned, size, _DEEP)
    return returned if found is None else found


def _found(value: Any, size: int, deep: int) -> NDArray[np.float64] | None:  # noqa: ANN401
    numbers = _numbers(value)
    if numbers is not None and numbers.shape in ((size,), (size, 1), (1, size)):
        return numbers.reshape(size)
    parts = _parts(value, rectangular=numbers is not None) if deep else iter(())
    return next((f for part in parts if (f := _found(part, size, deep - 1)) is not None), None)


def _numbers(value: Any) -> NDArray[np.float64] | None:  # noqa: ANN401
    """Return what is said in numbers alone, as an array."""
    if not (isinstance(value, list | tuple) or hasattr(value, "__array__")):
        return None
    try:
        return np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        return None


def _parts(value: Any, *, rectangular: bool) -> Iterator[Any]:  # noqa: ANN401
    """Yield what may be the point, or hold it; of a list of points none is the one meant."""
    if isinstance(value, Mapping):
        yield from (value[name] for name in NAMES if name in value)
        if all(str(key)[-1:].isdigit() for key in value):
            yield list(value.values())
    elif not isinstance(value, list | np.ndarray | str | bytes | type(None)):
        yield from (held for name in NAMES if (held := _held(value, name)) is not None)
    if isinstance(value, tuple) or (isinstance(value, list) and not rectangular):
        yield from (part for part in value if not np.isscalar(part))


def _held(value: object, name: str) -> Any:  # noqa: ANN401
    try:
        return getattr(value, name, None)
    except Exception:  # noqa: BLE001 (a property of somebody else's may raise anything)
        return None
