"""A small package of a user's own that tests write, edit and load again in one process."""

import importlib
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from repro.determinism.read_anew import read_anew as forget

__all__ = ["Package", "forget"]


class Package:
    """Files of a package below a folder, and what is loaded of it."""

    def __init__(self, folder: Path, name: str) -> None:
        """Name the package; nothing is written before `load`."""
        self.folder, self.name = folder, name

    def load(self, texts: Mapping[str, str], module: str = "paper") -> Any:  # noqa: ANN401
        """Write the files, forget what was there, and return a module of the package."""
        for name in [n for n in sys.modules if n.partition(".")[0] == self.name]:
            del sys.modules[name]
        for name, text in {"__init__.py": "", **texts}.items():
            path = self.folder / self.name / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        forget()
        return importlib.import_module(f"{self.name}.{module}")


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Package]:
    """Yield a package that can be edited, its name its own."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("sys.dont_write_bytecode", True)
    made = Package(tmp_path, f"edited_{tmp_path.name}".replace("-", "_"))
    yield made
    for name in [n for n in sys.modules if n.partition(".")[0] == made.name]:
        del sys.modules[name]
    forget()
