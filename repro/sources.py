"""Digests of source code: which modules a run depends on, and whether they still say the same."""

import ast
import hashlib
import importlib.util
from functools import cache
from pathlib import Path


@cache
def source_digest(*modules: str) -> str:
    """Return a digest of the named modules and all modules of the engine that they import.

    Comments, layout and docstrings do not count; anything that runs does.
    """
    digest = hashlib.sha256()
    for name in sorted(_closure(modules)):
        digest.update(f"{name}\0{_meaning(name)}\0".encode())
    return digest.hexdigest()


def _closure(modules: tuple[str, ...]) -> set[str]:
    found: set[str] = set()
    waiting = list(modules)
    while waiting:
        name = waiting.pop()
        if name not in found and name.startswith("repro."):
            found.add(name)
            waiting.extend(_imports(name))
    return found


@cache
def _tree(name: str) -> ast.Module:
    spec = importlib.util.find_spec(name)
    path = spec.origin if spec else None
    return ast.parse(Path(path).read_text(encoding="utf-8") if path else "")


@cache
def _imports(name: str) -> tuple[str, ...]:
    nodes = [node for node in ast.walk(_tree(name)) if isinstance(node, ast.ImportFrom)]
    return tuple(node.module for node in nodes if node.module)


@cache
def _meaning(name: str) -> str:
    tree = _tree(name)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and _is_docstring(body[0]):
            body[:1] = [ast.Pass()]
    return ast.dump(tree)


def _is_docstring(node: ast.stmt) -> bool:
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )
