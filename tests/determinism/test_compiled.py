import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

from repro.determinism import compiled
from tests.determinism.edited_packages import forget

KERNEL = """
from repro.determinism.compiled import jit
from factors import FACTOR

@jit
def cost(x, data):
    return FACTOR * x[0]
"""


def kept_in(folder: Path) -> str:
    """Return the folder where the compiled code of the kernel is kept, as a new process would."""
    forget()
    for name in ("kernel_of_mine", "factors"):
        sys.modules.pop(name, None)
    importlib.invalidate_caches()
    (folder / "kernel_of_mine.py").touch()
    return str(importlib.import_module("kernel_of_mine").cost._cache.cache_path)


def test_code_of_ones_own_is_kept_under_all_modules_that_it_imports(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    (tmp_path / "kernel_of_mine.py").write_text(KERNEL)
    (tmp_path / "factors.py").write_text("FACTOR = 1.0\n")
    (tmp_path / "other.py").write_text("FACTOR = 1.0\n")
    before = kept_in(tmp_path)
    (tmp_path / "other.py").write_text("FACTOR = 2.0\n")
    assert kept_in(tmp_path) == before

    (tmp_path / "factors.py").write_text("FACTOR = 2.0\n")

    assert kept_in(tmp_path) != before


def test_code_without_a_source_is_not_kept() -> None:
    names = {"jit": compiled.jit, "__name__": "typed_by_hand"}
    exec("@jit\ndef cost(x, data):\n    return x[0]", names)  # noqa: S102 (as a prompt would)

    assert names["cost"](np.ones(1), np.zeros(1)) == 1.0  # type: ignore[operator]
