"""Compilation: one signature per kind of kernel, cached beside the package and never stale.

numba decides from one file's time stamp whether its cached machine code is current; it does not
see a change in a function that the file calls. So the cache lives in a folder named after a
digest of every compiled source, and a change anywhere starts a fresh one. Compiled sources are all
modules of the folders in which one imports this module. A function of a user's own has a folder in
that one, named after a digest of the user's modules that its own one imports, directly or not.
"""

import hashlib
import os
import re
import threading
from pathlib import Path
from typing import Any

import numba
from numba.types import FunctionType, Tuple, float64, int64, uint64

from repro.determinism.definitions import import_closure
from repro.determinism.source_files import is_of_engine, path_of, text_of
from repro.errors import InputError

_PACKAGE = Path(__file__).parent.parent
_LOCK = threading.Lock()
_SHOWN = 200  # characters of what numba says that a message shows


def _digest() -> str:
    texts = {path: path.read_bytes() for path in sorted(_PACKAGE.rglob("*.py"))}
    marker = f"from {__name__} import".encode()
    rooms = {path.parent for path, text in texts.items() if marker in text}
    text = b"".join(text for path, text in texts.items() if path.parent in rooms)
    return hashlib.sha256(text).hexdigest()[:16]


_CACHE = _PACKAGE / "__pycache__" / f"numba-{_digest()}"
_CACHED = bool(numba.config.CACHE_DIR) or os.access(_PACKAGE, os.W_OK)
if not numba.config.CACHE_DIR:
    numba.config.CACHE_DIR = str(_CACHE)


def jit(function: Any) -> Any:  # noqa: ANN401 (numba ships no types)
    """Return a function compiled: no Python objects, no GIL, cached on disk.

    A division by zero gives what IEEE 754 says, not an exception. Code whose source cannot be found
    is compiled anew in every process.
    """
    own = "" if is_of_engine(function.__module__) else _sources_of(function.__module__)
    cached = _CACHED and own is not None
    with _LOCK:
        before = numba.config.CACHE_DIR
        if own:
            numba.config.CACHE_DIR = str(Path(before) / f"own-{own}")
        try:
            return numba.njit(nogil=True, cache=cached, error_model="numpy")(function)
        finally:
            numba.config.CACHE_DIR = before


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
