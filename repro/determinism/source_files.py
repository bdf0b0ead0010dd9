"""Where the source of a module stands, and whether it is of the engine, of a user, or a library."""

import ast
import importlib.metadata
import sys
import sysconfig
from functools import cache
from importlib.machinery import PathFinder
from pathlib import Path

_OURS = ("repro", "papers")
_STANDARD = Path(sysconfig.get_paths()["stdlib"])
_INSTALLED = ("site-packages", "dist-packages")


@cache
def path_of(module: str) -> Path | None:
    """Return the file of a module; None for what is no module written in Python.

    Nothing is imported for it.
    """
    loaded = sys.modules.get(module)
    origin = getattr(loaded, "__file__", None) if loaded else _found(module)
    path = Path(origin) if origin and origin.endswith(".py") else None
    return path if path and path.is_file() else None


def _found(module: str) -> str | None:
    package, _, _ = module.rpartition(".")
    if not package:
        folders = None
    elif (parent := sys.modules.get(package)) is not None:
        folders = list(getattr(parent, "__path__", []))
    else:
        above = path_of(package)
        folders = [str(above.parent)] if above and above.name == "__init__.py" else []
    spec = PathFinder.find_spec(module, folders)
    return spec.origin if spec else None


@cache
def text_of(module: str) -> str:
    """Return the source of a module, empty where there is none."""
    path = path_of(module)
    return path.read_text(encoding="utf-8", errors="replace") if path else ""


@cache
def tree_of(module: str) -> ast.Module:
    """Return the parsed source of a module, empty where there is none or it is not Python."""
    try:
        return ast.parse(text_of(module))
    except (SyntaxError, ValueError):  # a file that changed since it was imported
        return ast.parse("")


@cache
def is_own(module: str) -> bool:
    """Return whether a module is the engine's or a user's: no library and not Python's own.

    What is installed is a library, unless it declares papers. A library's version is recorded in
    the provenance of every run.
    """
    path = path_of(module)
    if path is None:
        return False
    if package_of(module) in _OURS or package_of(module) in _declaring():
        return True
    parts = path.resolve().parts
    return not any(name in parts for name in _INSTALLED) and _STANDARD not in path.parents


@cache
def is_library(module: str) -> bool:
    """Return whether a module is Python's own or installed, written in Python or not."""
    package = package_of(module)
    if package in sys.stdlib_module_names:
        return True
    file = getattr(sys.modules.get(package), "__file__", None)
    return package != "__main__" and file is not None and not is_own(module) and not is_own(package)


def is_of_engine(module: str) -> bool:
    """Return whether a module is the engine's."""
    return package_of(module) == "repro"


def package_of(module: str) -> str:
    """Return the outermost package of a module."""
    return module.partition(".")[0]


@cache
def _declaring() -> frozenset[str]:
    points = importlib.metadata.entry_points(group="repro.papers")
    return frozenset(package_of(point.module) for point in points)


def is_package(module: str) -> bool:
    """Return whether a module is the `__init__` of a package."""
    path = path_of(module)
    return path is not None and path.name == "__init__.py"
