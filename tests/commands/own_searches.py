"""A folder with a module of searches of one's own, and one paper that is known."""

import json
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from repro.model.paper import Paper
from tests.determinism.edited_packages import forget
from tests.small_papers import let_be_known

Run = Callable[..., tuple[int, str, str]]


@contextmanager
def standing_in(
    folder: Path, monkeypatch: pytest.MonkeyPatch, *, module: str, paper: Paper
) -> Iterator[None]:
    """Stand in a folder with `mine.py`; the module is forgotten afterwards."""
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "path", [*sys.path])
    let_be_known(monkeypatch, paper)
    (folder / "mine.py").write_text(module)
    forget()
    yield
    sys.modules.pop("mine", None)


def let_be_trusted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no run be made again to see whether it comes out, in three processes for a search.

    For what is no matter of that; `test_compare_cases` holds what is.
    """
    monkeypatch.setattr("repro.commands.comparing.probed", lambda *_: [])


def results(name: str) -> dict[str, Any]:
    """Return what a comparison wrote for programs."""
    found: dict[str, Any] = json.loads(Path(f"reports-private/{name}.json").read_text())
    return found
