"""What compiled code holds of values: numba takes names at the top level of modules as constants.

Such a value may come from a file or be set from elsewhere, so that the same source compiles to
other code.
"""

import hashlib
import types
from collections.abc import Iterator
from typing import Any

import numpy as np
from numba.core.dispatcher import Dispatcher

from repro.determinism.source_files import is_of_engine, is_own

_PLAIN = int | float | complex | str | bytes | tuple | np.generic  # type: ignore[type-arg]


def frozen_values(function: Any) -> str:  # noqa: ANN401 (compiled or not)
    """Return a digest of all constants that the code of a user's function is compiled with."""
    found = hashlib.sha256()
    for one in _reached(function):
        for name, value in _named(_plain(one)):
            if isinstance(value, np.ndarray):
                found.update(f"\0{name} {value.dtype} {value.shape} ".encode())
                found.update(value.tobytes())
            elif isinstance(value, _PLAIN):
                found.update(f"\0{name} {type(value)} {value!r}".encode())
    return found.hexdigest()


def compiled_functions(function: Any) -> Iterator[Any]:  # noqa: ANN401 (numba ships no types)
    """Yield each compiled function among a user's function and all that it calls by name."""
    yield from (one for one in _reached(function) if isinstance(one, Dispatcher))


def _reached(function: Any) -> Iterator[Any]:  # noqa: ANN401
    """Yield a function and all that it calls by name, but for the engine's and libraries'."""
    seen: set[int] = set()
    waiting = [function]
    while waiting:
        one = waiting.pop()
        if id(one) not in seen and _is_own_function(one):
            seen.add(id(one))
            yield one
            waiting += [value for _, value in _named(_plain(one))]


def _is_own_function(value: Any) -> bool:  # noqa: ANN401
    made = _plain(value)
    return isinstance(made, types.FunctionType) and not is_of_engine(made.__module__ or "")


def _plain(value: Any) -> Any:  # noqa: ANN401
    return value.py_func if isinstance(value, Dispatcher) else value


def _named(function: types.FunctionType) -> Iterator[tuple[str, Any]]:
    """Yield what the names in a function stand for now, those in a module of a user's too."""
    names = dict.fromkeys(_names(function.__code__))
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=False)
    known = function.__globals__ | {n: c.cell_contents for n, c in cells if _is_filled(c)}
    for name in (*names, *function.__code__.co_freevars):
        value = known.get(name)
        if isinstance(value, types.ModuleType) and is_own(value.__name__):
            held = vars(value)
            yield from ((f"{name}.{each}", held[each]) for each in names if each in held)
        else:
            yield name, value


def _is_filled(cell: types.CellType) -> bool:
    try:
        return cell.cell_contents is not cell
    except ValueError:  # bound later than the function
        return False


def _names(code: types.CodeType) -> Iterator[str]:
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, types.CodeType):
            yield from _names(inner)
