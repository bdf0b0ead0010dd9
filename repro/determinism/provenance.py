"""On what and with what the runs were made; taken when they are made."""

import datetime as dt
import importlib.metadata
import os
import platform
import subprocess
from pathlib import Path

from repro.determinism.seeds import RULE

DECISIVE = ("packages", "libc", "vector_instructions", "system", "seed_rule")
"""What decides the last bits of a run, by its name in the provenance."""
PACKAGES = ("numpy", "numba", "llvmlite", "scipy", "matplotlib", "jinja2")


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
        "cores": os.cpu_count(),
        "seed_rule": RULE,
    }


def _commit() -> str:
    command = ("git", "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*")
    try:
        found = subprocess.run(  # noqa: S603 (a fixed command)
            command, cwd=Path(__file__).parent, capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        return "unknown (no git checkout)"
    return found.stdout.strip()


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    if information.exists():
        for line in information.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown"


def _vector_instructions() -> str:
    """Return what decides the last bit of compiled arithmetic besides the libraries."""
    import llvmlite.binding as llvm  # noqa: PLC0415 (slow to load and needed for runs only)

    features = llvm.get_host_cpu_features()
    wanted = ("fma", "avx2", "avx512f", "sve", "neon")
    return " ".join(name for name in wanted if features.get(name)) or "none of note"
