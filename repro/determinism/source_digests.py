"""Digests of source code: which modules a run depends on, and whether they still say the same."""

import ast
import hashlib
import importlib.util
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any


@cache
def source_digest(*modules: str) -> str:
    """Return a digest of the named modules and all modules of the engine that they import.

    Comments, layout and docstrings do not count; anything that runs does. The named modules count
    wherever they come from: a paper or a user may bring an algorithm or a problem along.
    """
    digest = hashlib.sha256()
    for name in sorted(_closure(modules)):
        digest.update(f"{name}\0{_meaning(name)}\0".encode())
    return digest.hexdigest()


def sources_of_run(optimiser: object, subject: Any) -> str:  # noqa: ANN401 (any problem)
    """Return a digest of all source code that decides what a run of a search gives."""
    modules = {type(optimiser).__module__, type(subject).__module__, subject.kernel.__module__}
    return source_digest("repro.determinism.seeds", *sorted(modules))


def _closure(modules: tuple[str, ...]) -> set[str]:
    found: set[str] = set()
    waiting = list(modules)
    while waiting:
        name = waiting.pop()
        if name not in found and (name in modules or name.startswith("repro.")):
            found.add(name)
            waiting.extend(_imports(name))
    return found


@cache
def _path(name: str) -> Path | None:
    """Return the file of a module; None for what is no module written in Python."""
    try:
        spec = importlib.util.find_spec(name)
        origin = spec.origin if spec else None
    except ModuleNotFoundError:  # its parent is a module and no package
        origin = None
    except ValueError:  # a script that was started as such
        origin = getattr(sys.modules[name], "__file__", None)
    return Path(origin) if origin and origin.endswith(".py") else None


@cache
def _tree(name: str) -> ast.Module:
    path = _path(name)
    return ast.parse(path.read_text(encoding="utf-8") if path else "")


@cache
def _imports(name: str) -> tuple[str, ...]:
    return tuple(
        found
        for found in _names_imported(_tree(name))
        if found.startswith("repro.") and _path(found)
    )


def _names_imported(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            # a name that is imported from a package may be a module of it
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


@cache
def _meaning(name: str) -> str:
    tree = _tree(name)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            body[:] = [statement for statement in body if not _is_idle(statement)]
    return ast.dump(tree)


def _is_idle(node: ast.stmt) -> bool:
    if isinstance(node, ast.Pass):
        return True
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )
