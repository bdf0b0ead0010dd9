"""Environment variables that may decide a bit of a run: what libraries read when they load."""

import os

_PREFIXES = ("NUMBA_", "GLIBC_TUNABLES", "NPY_", "OPENBLAS_", "MKL_", "BLIS_", "LD_PRELOAD")
# how many threads, where files are kept and what is printed decide nothing
_IDLE = (
    *("NUMBA_CACHE_DIR", "NUMBA_NUM_THREADS", "NUMBA_THREADING_LAYER", "NUMBA_COLOR_SCHEME"),
    *("NUMBA_DISABLE_ERROR_MESSAGE_HIGHLIGHTING", "NUMBA_DISABLE_PERFORMANCE_WARNINGS"),
    *("NUMBA_FULL_TRACEBACKS", "NUMBA_DEVELOPER_MODE", "NUMBA_WARNINGS", "NUMBA_DEBUG_CACHE"),
    *("OPENBLAS_NUM_THREADS", "OPENBLAS_VERBOSE", "MKL_NUM_THREADS", "BLIS_NUM_THREADS"),
)


def settings(library: str = "") -> dict[str, str]:
    """Return the variables that are set and may decide a bit, of one library or of all."""
    return {
        name: value
        for name, value in sorted(os.environ.items())
        if value and name.startswith(_PREFIXES) and name not in _IDLE and name.startswith(library)
    }
