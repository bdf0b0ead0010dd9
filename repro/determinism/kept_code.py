"""Where compiled code is kept: in a folder that is named after all that is compiled into it.

numba decides from one file's time stamp whether its cached machine code is current; it does not
see a change in a function that the file calls, nor a setting by which it compiles. So the folder
has the name of a digest of both, wherever it stands: below NUMBA_CACHE_DIR where that is set,
beside the package, or, where neither can be written, among the user's cached files. Compiled
sources are all modules of the folders in which one imports `repro.determinism.compiled`.
"""

import hashlib
import os
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from platformdirs import user_cache_path

from repro.determinism.settings import settings

_PACKAGE = Path(__file__).parent.parent
_MARKER = b"from repro.determinism.compiled import"


def kept_in() -> Path | None:
    """Return the folder for compiled code, made where it has to be; None where none can be."""
    name = f"numba-{_digest()}"
    return next((place / name for place in _places() if _is_usable(place / name)), None)


def _digest() -> str:
    texts = {path: path.read_bytes() for path in sorted(_PACKAGE.rglob("*.py"))}
    rooms = {path.parent for path, text in texts.items() if _MARKER in text}
    found = hashlib.sha256(repr(sorted(settings("NUMBA").items())).encode())
    for path, text in texts.items():
        if path.parent in rooms:
            found.update(f"\0{path.relative_to(_PACKAGE).as_posix()}\0".encode())
            found.update(text)
    return found.hexdigest()[:16]


def _places() -> Iterator[Path]:
    if named := os.environ.get("NUMBA_CACHE_DIR"):
        yield Path(named).absolute()
    yield _PACKAGE / "__pycache__"
    with suppress(RuntimeError):  # no home is known; older versions name a folder called ~ then
        of_user = user_cache_path("repro", appauthor=False)
        if of_user.is_absolute():
            yield of_user


def _is_usable(folder: Path) -> bool:
    """Return whether a file can be made in a folder: permissions alone do not tell."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False
