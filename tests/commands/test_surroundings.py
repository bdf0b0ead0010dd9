"""Variables and folders that break other programs are put right, or named in one line."""

import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.small_papers import PAPER, let_be_known

PAPERS = """
from repro.__main__ import main
from repro.commands.surroundings import prepare
prepare()  # as main does before anything is loaded
from tests.small_papers import PAPER, let_be_known
import pytest, sys
with pytest.MonkeyPatch.context() as patch:
    let_be_known(patch, PAPER)
    sys.exit(main(sys.argv[1:]))
"""
ROOT = Path(__file__).parents[2]


def called(
    *arguments: str,
    cwd: Path,
    before: Callable[[], None] | None = None,
    odd: Mapping[str, str] | None = None,
    **more: str,
) -> subprocess.CompletedProcess[str]:
    """Return what a process of its own says that knows the small paper alone."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **more, **(odd or {})}
    call = (sys.executable, "-c", PAPERS, *arguments)
    return subprocess.run(
        call,
        cwd=cwd,
        env=environment,
        check=False,
        capture_output=True,
        text=True,
        preexec_fn=before,
    )


def test_a_backend_that_is_none_stops_nothing(tmp_path: Path) -> None:
    done = called(
        *("reproduce", "--repeats", "1", "--protocol-only"), cwd=tmp_path, MPLBACKEND="Nonsense"
    )

    assert done.returncode == 0, done.stderr
    assert (tmp_path / "reports" / "index.html").exists()


def test_a_run_that_is_not_to_be_compiled_is_refused_in_one_line(tmp_path: Path) -> None:
    call = (sys.executable, "-m", "repro", "reproduce", "--repeats", "1")
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(ROOT)}

    done = subprocess.run(
        call, cwd=tmp_path, env=environment, check=False, capture_output=True, text=True
    )

    assert done.returncode == 2
    assert done.stderr.startswith("repro: NUMBA_DISABLE_JIT is set")
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_locale_without_letters_stops_nothing(tmp_path: Path) -> None:
    done = called(
        "reproduce",
        "--repeats",
        "1",
        "--protocol-only",
        cwd=tmp_path,
        LC_ALL="C",
        PYTHONCOERCECLOCALE="0",
        PYTHONUTF8="0",
    )

    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr


def test_odd_variables_all_at_once_stop_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder can be made below it")
    nowhere = str(tmp_path / "file" / "x")
    folders = ("HOME", "TMPDIR", "XDG_CACHE_HOME", "MPLCONFIGDIR", "NUMBA_CACHE_DIR")
    odd = {
        **dict.fromkeys((*folders, "SQLITE_TMPDIR", "MATPLOTLIBRC"), nowhere),
        **dict.fromkeys(("LANG", "LC_ALL", "TZ", "TERM", "COLUMNS"), "nonsense"),
        **dict.fromkeys(("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "LINES"), "0"),
        "NO_COLOR": "1",
        "PYTHONOPTIMIZE": "2",
        "SOURCE_DATE_EPOCH": "nonsense",
        "PYTHONHASHSEED": "7",
    }

    done = called("reproduce", "--repeats", "1", "--protocol-only", cwd=tmp_path, odd=odd)

    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert (tmp_path / "reports" / "index.html").exists()
    assert (tmp_path / "file").is_file()


def test_code_that_cannot_be_kept_is_said_before_any_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    let_be_known(monkeypatch, PAPER)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("repro.determinism.compiled.KEPT", None)

    assert main(["reproduce", "--repeats", "1", "--protocol-only"]) == 0

    assert capsys.readouterr().err.startswith("repro: compiled code cannot be kept")
