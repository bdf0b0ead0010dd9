"""Sources are read once: what is edited between two calls of one session is to be read anew."""

import importlib

from repro.determinism import definitions, held_values, source_digests, source_files, statements

_READERS = (definitions, held_values, source_digests, source_files, statements)


def read_anew() -> None:
    """Let all sources be read anew, as another process would."""
    for module in _READERS:
        for value in vars(module).values():
            forget = getattr(value, "cache_clear", None)  # of what `functools.cache` makes
            if forget is not None:
                forget()
    importlib.invalidate_caches()
