"""On what and with what the runs were made; taken when they are made."""

import datetime as dt
import hashlib
import importlib.metadata
import os
import platform
import subprocess
from functools import cache
from pathlib import Path

from repro.determinism.seeds import RULE
from repro.determinism.settings import settings

DECISIVE = (
    *("packages", "libc", "vector_instructions", "array_instructions", "linear_algebra"),
    *("settings", "system", "seed_rule"),
)
"""What decides the last bits of a run, by its name in the provenance."""
PACKAGES = ("numpy", "numba", "llvmlite", "scipy", "matplotlib", "jinja2")
_PACKAGE = Path(__file__).parent.parent
_DISTRIBUTION = "repro-whales"
_OWN = ("..", "../../papers")  # folders with files of ours, from here


def provenance() -> dict[str, object]:
    """Return versions, processor, commit, date and seed rule of this process."""
    return {
        "date": dt.datetime.now(tz=dt.UTC).date().isoformat(),
        "commit": _commit(),
        "python": platform.python_version(),
        "packages": {name: importlib.metadata.version(name) for name in PACKAGES},
        "system": f"{platform.system()} {platform.machine()}",
        "libc": " ".join(platform.libc_ver()),
        "processor": _processor(),
        "vector_instructions": _vector_instructions(),
        "array_instructions": _array_instructions(),
        "linear_algebra": _linear_algebra(),
        "settings": settings(),
        "cores": os.cpu_count(),
        "seed_rule": RULE,
    }


def _commit() -> str:
    """Return the commit of the package's own files; elsewhere its version and a digest of them.

    A repository around the package says nothing of it unless it tracks it. "-dirty" stands after
    the commit where files of the package differ from it: pages that are written meanwhile do not.
    """
    module = Path(__file__).name
    if _git("ls-files", "--error-unmatch", "--", module) is not None:
        found = _git("describe", "--always", "--abbrev=12", "--exclude=*")
        if found:
            changed = any(_git("status", "--porcelain", "-uno", "--", folder) for folder in _OWN)
            return f"{found}-dirty" if changed else found
    return f"{_version()}, sources {_sources()} (no git checkout)"


def _git(*command: str) -> str | None:
    """Return what git says of the folder of this file, whatever GIT_* names; None of an error."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("GIT_")}
    try:
        found = subprocess.run(  # noqa: S603 (fixed commands)
            ("git", *command),  # noqa: S607 (whichever git there is)
            cwd=Path(__file__).parent,
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return found.stdout.strip()


def _version() -> str:
    try:
        return f"version {importlib.metadata.version(_DISTRIBUTION)}"
    except importlib.metadata.PackageNotFoundError:
        return "no version"


@cache
def _sources() -> str:
    found = hashlib.sha256()
    for path in sorted(_PACKAGE.rglob("*.py")):
        found.update(f"\0{path.relative_to(_PACKAGE).as_posix()}\0".encode())
        found.update(path.read_bytes())
    return found.hexdigest()[:12]


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    if information.exists():
        for line in information.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown"


def _vector_instructions() -> str:
    """Return for which instructions numba compiles: settings may make them fewer."""
    from numba.core.registry import cpu_target  # noqa: PLC0415 (slow, and needed for runs only)

    _, _, features = cpu_target.target_context.codegen().magic_tuple()
    wanted = ("fma", "avx2", "avx512f", "sve", "neon")
    used = set(features.split(","))
    return " ".join(name for name in wanted if f"+{name}" in used) or "none of note"


def _array_instructions() -> str:
    """Return the instructions for which NumPy chose its loops when it was loaded."""
    import numpy as np  # noqa: PLC0415 (as above)

    chosen = np.show_config(mode="dicts").get("SIMD Extensions", {})
    return " ".join((*chosen.get("baseline", ()), *chosen.get("found", ()))) or "none of note"


def _linear_algebra() -> list[str]:
    """Return the libraries that multiply and factor matrices, with the kernels that they chose."""
    import scipy.linalg  # noqa: F401, PLC0415 (it loads the second of them)
    from threadpoolctl import threadpool_info  # noqa: PLC0415

    return sorted(
        f"{one['internal_api']} {one['version']} {one.get('architecture', '')}".strip()
        for one in threadpool_info()
        if one["user_api"] == "blas"
    )
