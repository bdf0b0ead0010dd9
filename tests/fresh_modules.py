"""Modules of a folder forgotten, as a program that starts anew has not seen them."""

import sys
from pathlib import Path

from tests.determinism import edited_packages


def drop(folder: Path) -> None:
    """Forget the modules of a folder."""
    for name, module in list(sys.modules.items()):
        if Path(getattr(module, "__file__", None) or "/").is_relative_to(folder):
            del sys.modules[name]


def forget(folder: Path) -> None:
    """Forget the modules of a folder, and what was read of any module's source."""
    drop(folder)
    edited_packages.forget()
