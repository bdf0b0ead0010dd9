"""Compiled code is fresh wherever it is kept, and is kept wherever it can be."""

import json
import os
import shutil
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest
from numba.core.caching import FunctionCache

import repro
from repro.determinism import kept_code
from repro.determinism.source_digests import told
from repro.functions import FUNCTIONS
from repro.optimisers.random_search import RandomSearch

PACKAGE = Path(repro.__file__).parent


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a package with a room that compiles and one that does not."""
    texts = {
        "kernels/cost.py": "from repro.determinism.compiled import jit",
        "kernels/choices.py": "LIMIT = 3",
        "pages/page.py": "WIDTH = 80",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setattr(kept_code, "_PACKAGE", tmp_path)
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "counts"),
    [("kernels/cost.py", True), ("kernels/choices.py", True), ("pages/page.py", False)],
)
def test_compiled_code_is_kept_under_all_sources_of_the_rooms_that_compile(
    package: Path, name: str, *, counts: bool
) -> None:
    before = kept_code.kept_in()

    (package / name).write_text((package / name).read_text() + "\nMORE = 1")

    assert (kept_code.kept_in() != before) is counts


def test_code_moved_from_one_module_to_another_is_kept_elsewhere(package: Path) -> None:
    before = kept_code.kept_in()

    (package / "kernels/choices.py").rename(package / "kernels/other.py")

    assert kept_code.kept_in() != before


def test_rooms_that_compile_are_found() -> None:
    marker = kept_code._MARKER.decode()
    rooms = {p.parent.name for p in PACKAGE.rglob("*.py") if marker in p.read_text("utf-8")}

    assert rooms == {"determinism", "functions", "optimisers", "robotics"}


def test_a_folder_of_numbas_is_used_under_the_same_digest(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    beside = kept_code.kept_in()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "theirs"))

    found = kept_code.kept_in()

    assert beside is not None
    assert beside.parent == package / "__pycache__"
    assert found == tmp_path / "theirs" / beside.name


def test_a_setting_by_which_numba_compiles_is_part_of_the_digest(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert package.is_dir()
    before = kept_code.kept_in()
    monkeypatch.setenv("NUMBA_NUM_THREADS", "1")
    assert kept_code.kept_in() == before

    monkeypatch.setenv("NUMBA_OPT", "0")

    assert kept_code.kept_in() != before


def test_what_cannot_be_written_beside_the_package_is_kept_for_the_user(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    beside = kept_code.kept_in()
    shutil.rmtree(package / "__pycache__")
    (package / "__pycache__").write_text("in the way")
    monkeypatch.setenv("NUMBA_CACHE_DIR", "/proc/nowhere")
    of_user = tmp_path / "cache" / "repro"
    monkeypatch.setattr(kept_code, "user_cache_path", lambda *_, **__: of_user)

    found = kept_code.kept_in()

    assert beside is not None
    assert found == of_user / beside.name


def test_where_nothing_can_be_written_nothing_is_kept(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (package / "__pycache__").write_text("in the way")
    monkeypatch.setattr(kept_code, "user_cache_path", lambda *_, **__: Path("/proc/nowhere"))

    assert kept_code.kept_in() is None


def test_a_user_without_a_home_gets_no_folder_called_tilde(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (package / "__pycache__").write_text("in the way")
    monkeypatch.chdir(package)
    monkeypatch.delenv("HOME", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr("pwd.getpwuid", {}.__getitem__)

    assert kept_code.kept_in() is None
    assert not (package / "~").exists()


EDITS = {
    "determinism/draws.py": ("_UNIT = 2.0**-53", "_UNIT = 2.0**-54"),
    "optimisers/random_search.py": ("+ width *", "+ 0.5 * width *"),
    "optimisers/population.py": ("target[j] = source[j]", "target[j] = 0.5 * source[j]"),
    "functions/unimodal.py": ("total += x[j] * x[j]", "total -= x[j] * x[j]"),
}


def test_every_file_with_kept_code_that_the_edited_run_reaches_is_among_the_edited() -> None:
    parts = told(algorithm=RandomSearch(), problem=FUNCTIONS["sphere"].problem(2)).parts
    kept = set()
    for name, _, module in (part.rpartition(" of ") for part in parts):
        found = getattr(sys.modules.get(module), name, None)
        if isinstance(getattr(found, "_cache", None), FunctionCache):
            kept.add(sys.modules[module].__file__)

    assert kept == {str(PACKAGE / name) for name in EDITS}


RUN = """
import importlib, json, sys
import numpy as np

def run():
    for name in [name for name in sys.modules if name.partition(".")[0] == "repro"]:
        del sys.modules[name]
    importlib.invalidate_caches()
    from repro.functions import FUNCTIONS
    from repro.optimisers.random_search import RandomSearch
    from repro.runs.plan import sources_of_run
    problem = FUNCTIONS["sphere"].problem(2)
    search = RandomSearch()
    found = search.minimise(
        problem, population=2, iterations=2, rng=np.random.default_rng(1)
    )
    return sources_of_run(search, problem), found.x.tolist()

told = [run()]
for path, before, after in json.loads(sys.argv[1]):
    with open(path) as file:
        text = file.read()
    assert before in text, path
    with open(path, "w") as file:
        file.write(text.replace(before, after))
    told.append(run())
print(json.dumps(told))
"""


@pytest.mark.parametrize("variable", [False, True], ids=["beside the package", "NUMBA_CACHE_DIR"])
def test_a_changed_key_comes_with_freshly_compiled_code(tmp_path: Path, *, variable: bool) -> None:
    copy = tmp_path / "repro"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", "templates"))
    chosen = list(EDITS.items())[: None if variable else 1]  # a bypass would show in one, too
    edits = json.dumps([(str(copy / name), *edit) for name, edit in chosen])
    environment = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"}
    environment |= {"PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}
    if variable:
        environment["NUMBA_CACHE_DIR"] = str(tmp_path / "kept")

    call = (sys.executable, "-c", RUN, edits)
    done = subprocess.run(
        call, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False
    )

    assert done.returncode == 0, done.stderr
    states = json.loads(done.stdout)
    for (key, found), (new_key, new_found) in pairwise(states):
        assert key != new_key
        assert found != new_found
    folder = tmp_path / "kept" if variable else copy / "__pycache__"
    assert len(list(folder.glob("numba-*"))) == len(states)
