import importlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from repro.determinism import compiled
from tests.determinism.edited_packages import forget

ROOT = Path(__file__).parents[2]
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


READING = """
from pathlib import Path
from repro.determinism.compiled import jit
import constants

FACTOR = float(Path(__file__).with_name("factor.txt").read_text())

@jit
def scaled(value):
    return FACTOR * value + constants.SHIFT

@jit
def cost(x, data):
    return scaled(x[0])
"""
ASKING = """
import sys
import numpy as np
from repro.determinism.compiled import COST, ready
import constants, kernel_that_reads
if len(sys.argv) > 1:
    constants.SHIFT = float(sys.argv[1])
print(ready(kernel_that_reads.cost, COST)(np.ones(1), np.zeros(1)))
"""


def test_code_is_compiled_again_for_constants_that_are_read_or_set(tmp_path: Path) -> None:
    (tmp_path / "kernel_that_reads.py").write_text(READING)
    (tmp_path / "constants.py").write_text("SHIFT = 0.0\n")
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "kept")}
    environment["PYTHONPATH"] = f"{tmp_path}:{ROOT}"

    def cost(factor: str, *shift: str) -> float:
        (tmp_path / "factor.txt").write_text(factor)
        call = (sys.executable, "-c", ASKING, *shift)
        return float(subprocess.check_output(call, env=environment))

    assert [cost("2"), cost("3"), cost("3", "0.5"), cost("3", "0.25"), cost("2")] == [
        2.0, 3.0, 3.5, 3.25, 2.0
    ]  # fmt: skip


def test_code_without_a_source_is_not_kept() -> None:
    names = {"jit": compiled.jit, "__name__": "typed_by_hand"}
    exec("@jit\ndef cost(x, data):\n    return x[0]", names)  # noqa: S102 (as a prompt would)

    assert names["cost"](np.ones(1), np.zeros(1)) == 1.0  # type: ignore[operator]
