"""Compilation: one signature per kind of kernel, cached beside the package and never stale.

numba decides from one file's time stamp whether its cached machine code is current; it does not
see a change in a function that the file calls. So the cache lives in a folder named after a
digest of every compiled source, and a change anywhere starts a fresh one. Compiled sources are all
modules of the folders in which one imports this module.
"""

import hashlib
import os
import threading
from pathlib import Path
from typing import Any

import numba
from numba.types import FunctionType, Tuple, float64, int64, uint64

_PACKAGE = Path(__file__).parent.parent
_LOCK = threading.Lock()


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

jit = numba.njit(nogil=True, cache=_CACHED, error_model="numpy")
"""Decorator of every compiled function: no Python objects, no GIL, cached on disk.

A division by zero gives what IEEE 754 says, not an exception."""

VECTOR = float64[::1]
COST = float64(VECTOR, VECTOR)
"""Cost kernel: (point, data of the problem) to cost."""

SEARCH = Tuple((VECTOR, float64, VECTOR, int64))(
    FunctionType(COST), VECTOR, float64[:, ::1], int64, int64, VECTOR, uint64[::1]
)
"""Search kernel: (cost, data, bounds, population, iterations, parameters, random state) to
(best point, best cost, history, evaluations)."""


def ready(kernel: Any, signature: Any) -> Any:  # noqa: ANN401 (numba ships no types)
    """Return `kernel` compiled for `signature` alone, so that it passes as an argument."""
    with _LOCK:
        if not kernel.overloads:
            kernel.compile(signature)
            kernel.disable_compile()
    return kernel
