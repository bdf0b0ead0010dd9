"""Folders that may be read and not written, or neither: a line, or the work done elsewhere."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import repro
from tests.commands.forked import bound_call, called
from tests.small_stores import with_pages

PACKAGE = Path(repro.__file__).parent
RUN = """
import json, sys
import numpy as np
from repro.determinism.compiled import KEPT
from repro.functions import FUNCTIONS
from repro.optimisers.random_search import RandomSearch
RandomSearch().minimise(
    FUNCTIONS["sphere"].problem(2), population=2, iterations=2, rng=np.random.default_rng(1)
)
print(json.dumps({str(path): path.stat().st_mtime_ns for path in KEPT.rglob("*.nb?")}))
"""
SMALL = ("small2020", "--repeats", "1", "--protocol-only")


def locked(folder: Path, mode: int) -> None:
    """Give a folder and all that is in it these permissions, files without those to search."""
    for path in sorted(folder.rglob("*"), reverse=True):
        path.chmod(mode if path.is_dir() else mode & 0o666)
    folder.chmod(mode)


@pytest.fixture
def made(tmp_path: Path) -> Path:
    """Return a folder with a store and its pages."""
    return with_pages(tmp_path / "made")


def test_a_read_only_package_compiles_once_for_a_user(tmp_path: Path) -> None:
    copy = tmp_path / "site" / "repro"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", "templates"))
    locked(copy, 0o555)
    environment = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"}
    environment |= {"PYTHONPATH": str(tmp_path / "site"), "XDG_CACHE_HOME": str(tmp_path / "cache")}
    environment |= {"HOME": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}

    first, second = (
        json.loads(
            subprocess.run(
                (*bound_call(), sys.executable, "-c", RUN),
                cwd=tmp_path, env=environment, check=True, capture_output=True, text=True,
            ).stdout
        )
        for _ in range(2)
    )  # fmt: skip
    locked(copy, 0o755)

    assert first
    assert first == second
    assert not list(copy.rglob("__pycache__"))
    assert all(Path(name).is_relative_to(tmp_path) for name in first)


def test_a_store_that_may_only_be_read_is_read_and_not_written(made: Path) -> None:
    locked(made / "store", 0o555)
    places = ("--store", "store", "--reports", "elsewhere")

    listed, reported, again, run = called(
        made,
        ("list", "small2020", "--store", "store"),
        ("report", "small2020", "--repeats", "1", *places),
        ("verify", "--paper", "small2020", "--store", "store"),
        ("reproduce", *SMALL, *places),
        bound=True,
    )
    locked(made / "store", 0o755)

    assert (listed.code, again.code) == (0, 0), again.err
    assert reported.code == 0, reported.err
    assert (made / "elsewhere" / "small2020.html").exists()
    assert (run.code, run.err.count("\n")) == (2, 1), run.err
    assert "the store folder store cannot be used: Permission denied" in run.err


def test_a_private_store_is_one_line(made: Path) -> None:
    locked(made / "store", 0)

    told = called(
        made,
        ("list", "small2020", "--store", "store"),
        ("report", "small2020", "--store", "store"),
        ("reproduce", *SMALL, "--store", "store"),
        ("verify", "--paper", "small2020", "--store", "store"),
        ("export", "small2020", "--format", "csv", "--store", "store"),
        bound=True,
    )
    locked(made / "store", 0o755)

    for said in told:
        assert (said.code, said.err.count("\n")) == (2, 1), said
        assert said.err.startswith("repro: ")
        assert "store" in said.err
        assert "Permission denied" in said.err


@pytest.mark.parametrize("mode", [0, 0o555])
def test_reports_of_others_are_one_line_before_any_run(made: Path, mode: int) -> None:
    locked(made / "reports", mode)

    told = called(
        made,
        ("reproduce", *SMALL, "--store", "new"),
        ("report", "small2020", "--repeats", "1", "--store", "store"),
        bound=True,
    )
    locked(made / "reports", 0o755)

    for said in told:
        assert (said.code, said.err.count("\n")) == (2, 1), said
        assert said.err.startswith(("repro: the reports folder reports cannot", "repro: reports/"))
    assert not (made / "new").exists()


def test_results_that_may_not_be_read_are_named_and_kept(made: Path) -> None:
    results = made / "reports" / "results.json"
    results.chmod(0)

    flips, again = called(
        made,
        ("flips", "reports/results.json", "reports/results.json"),
        ("reproduce", *SMALL, "--store", "store"),
        bound=True,
    )

    assert (flips.code, flips.err.count("\n")) == (2, 1), flips
    assert "results.json: it cannot be read: Permission denied" in flips.err
    assert again.code == 0
    assert "results.json cannot be read (Permission denied); it is set aside as " in again.err
