"""What must work wherever the package is installed: `nox -s built` runs it with nothing else."""

import importlib
import os
import pkgutil
import sys
import tempfile
from pathlib import Path

import papers
import repro
from repro.__main__ import main

EXTRAS = {"distributed", "pyarrow", "yourdfpy", "ruckig", "toppra", "cloudpickle"}
CALLS = (
    ("new", "trial2020"),
    ("reproduce", "./trial2020.py", "--repeats", "1", "--protocol-only"),
    ("list", "./trial2020.py"),
    ("report", "./trial2020.py"),
    ("audit", "./trial2020.py"),
    ("export", "./trial2020.py", "--format", "csv", "--to", "out"),
)


def import_all() -> int:
    """Import every module, but what needs an extra; return how many."""
    count = 0
    for package in (repro, papers):
        for found in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            if found.name.endswith("__main__"):
                continue
            try:
                importlib.import_module(found.name)
            except ModuleNotFoundError as error:
                if error.name not in EXTRAS:
                    raise
            count += 1
    return count


def try_all() -> None:
    """Go to an empty folder, and call what makes, reads and shows runs."""
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for call in CALLS:
            code = main(call)
            if code:
                sys.exit(f"repro {' '.join(call)} ended with {code}")
        for name in ("reports/index.html", ".repro/runs.sqlite", "out"):
            if not Path(name).exists():
                sys.exit(f"{name} was not made")
        os.chdir("/")


if __name__ == "__main__":
    sys.stdout.write(f"{import_all()} modules imported from {Path(repro.__file__).parent}\n")
    try_all()
