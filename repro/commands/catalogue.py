"""The papers that there are, and the only importer of them."""

import importlib
import pkgutil
from collections.abc import Sequence
from pathlib import Path

import papers
from repro.errors import InputError
from repro.model.paper import Paper


def all_papers() -> dict[str, Paper]:
    """Return every paper that a module of `papers` declares, by key."""
    modules = (
        importlib.import_module(f"papers.{info.name}")
        for info in pkgutil.iter_modules(papers.__path__)
    )
    return {module.PAPER.key: module.PAPER for module in modules}


def chosen(keys: Sequence[str]) -> list[Paper]:
    """Return the papers of these keys, all if there is none; InputError for an unknown key."""
    known = all_papers()
    for key in keys:
        if key not in known:
            message = f"unknown paper {key!r}; known: {', '.join(known)}"
            raise InputError(message)
    return [paper for key, paper in known.items() if not keys or key in keys]


def expected_file(key: str) -> Path:
    """Return where the list of a paper's expected verdicts stands, if there is one."""
    return Path(papers.__path__[0]) / f"{key}.verdicts.csv"


def folders() -> tuple[str, ...]:
    """Return where papers are declared."""
    return tuple(papers.__path__)
