"""Compilation: one signature per kind of kernel, its code kept on disk and never stale.

The engine's compiled code stands in the folder that `kept_code` finds. A function of a user's own
has a folder in that one, named after a digest of the user's modules that its own one imports,
directly or not, and of the values that it holds as constants.
"""

import hashlib
import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import FunctionCache
from numba.types import FunctionType, Tuple, float64, int64, uint64

from repro.determinism.definitions import import_closure
from repro.determinism.frozen_values import compiled_functions, frozen_values
from repro.determinism.kept_code import kept_in
from repro.determinism.source_files import is_of_engine, path_of, text_of
from repro.errors import InputError

if numba.config.DISABLE_JIT:
    # an interpreter rounds otherwise than compiled loops, and takes days for their minutes
    message = "NUMBA_DISABLE_JIT is set: runs are of compiled code, so unset it"
    raise InputError(message)

_LOCK = threading.Lock()
_PLACES = ("CACHE_DIR", "CACHE_LOCATOR_CLASSES")  # by which numba finds the folder
_SHOWN = 200  # characters of what numba says that a message shows
KEPT = kept_in()
"""The folder of the engine's compiled code; None where none can be written."""
if KEPT:  # for code of a user's own too, which may call the engine's
    numba.config.CACHE_DIR = str(KEPT)


def jit(function: Any) -> Any:  # noqa: ANN401 (numba ships no types)
    """Return a function compiled: no Python objects, no GIL, cached on disk.

    A division by zero gives what IEEE 754 says, not an exception. Code whose source cannot be found
    is compiled anew in every process.
    """
    with _LOCK, _keeping(_made_of(function)) as kept:
        return numba.njit(nogil=True, cache=kept, error_model="numpy")(function)


@contextmanager
def _keeping(own: str | None) -> Iterator[bool]:
    """Let numba keep what is compiled in its folder and nowhere else; yield whether it keeps it."""
    before = {name: getattr(numba.config, name, None) for name in _PLACES}
    if KEPT:
        numba.config.CACHE_DIR = str(KEPT / f"own-{own}" if own else KEPT)
        numba.config.CACHE_LOCATOR_CLASSES = ""
    try:
        yield KEPT is not None and own is not None
    finally:
        for name, value in before.items():
            setattr(numba.config, name, value)


def _made_of(function: Any) -> str | None:  # noqa: ANN401
    """Return a digest of all that a user's function is compiled from, as it is now.

    It is "" for the engine's, which has its own, and None where the source cannot be found.
    """
    if is_of_engine(function.__module__):
        return ""
    sources = _sources_of(function.__module__)
    if sources is None:
        return None
    return hashlib.sha256(f"{sources} {frozen_values(function)}".encode()).hexdigest()[:16]


def _keep_as_now(kernel: Any) -> None:  # noqa: ANN401
    """Let what a kernel calls be kept under the constants of now: some are set after `jit`."""
    for one in compiled_functions(kernel):
        made = _made_of(one.py_func)
        if made and KEPT and isinstance(one._cache, FunctionCache):  # noqa: SLF001
            with _keeping(made):
                one.enable_caching()


def _sources_of(module: str) -> str | None:
    """Return a digest of all own modules that a module imports, itself first; None without any."""
    if path_of(module) is None:
        return None
    texts = {name: text_of(name) for name in {module, *import_closure(module)}}
    text = "\0".join(f"{name}\0{texts[name]}" for name in sorted(texts))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


VECTOR = float64[::1]
COST = float64(VECTOR, VECTOR)
"""Cost kernel: (point, data of the problem) to cost."""

SEARCH = Tuple((VECTOR, float64, VECTOR, int64))(
    FunctionType(COST), VECTOR, float64[:, ::1], int64, int64, VECTOR, uint64[::1]
)
"""Search kernel: (cost, data, bounds, population, iterations, parameters, random state) to
(best point, best cost, history, evaluations)."""


def ready(kernel: Any, signature: Any) -> Any:  # noqa: ANN401 (numba ships no types)
    """Return `kernel` compiled for `signature`, so that it passes as an argument.

    Raises InputError, in one line, for one that cannot be compiled so.
    """
    with _LOCK:
        if signature.args not in kernel.overloads:
            _keep_as_now(kernel)
            try:
                kernel.compile(signature)
            except (numba.core.errors.NumbaError, TypeError, RuntimeError) as error:
                message = f"{_place(kernel)} cannot be compiled: {_one_line(error)}"
                raise InputError(message) from None
            kernel.disable_compile()
    return kernel


def _place(kernel: Any) -> str:  # noqa: ANN401
    code = kernel.py_func.__code__
    return f"{kernel.__name__} ({Path(code.co_filename).name}, line {code.co_firstlineno})"


def _one_line(error: Exception) -> str:
    """Return what numba says, without the steps that led there and without its terminal colours."""
    lines = (line.strip() for line in re.sub(r"\x1b\[[0-9;]*m", "", str(error)).splitlines())
    said = " ".join(line for line in lines if line and not line.startswith("Failed in "))
    return said if len(said) <= _SHOWN else f"{said[:_SHOWN]}…"
