from collections.abc import Callable
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.small_papers import PAPER, let_be_known

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Return what runs a command in an empty folder and returns exit code, output and errors."""
    let_be_known(monkeypatch, PAPER)
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: (main(arguments), *capsys.readouterr())


def test_report_says_how_many_runs_are_missing_and_what_makes_them(run: Run) -> None:
    run("reproduce", "--repeats", "1")

    code, _, err = run("report", "--repeats", "2")

    command = "`repro reproduce small2020 --repeats 2`"
    assert (code, err.splitlines()[-1]) == (
        0,
        f"repro: 6 runs of 12 are not in .repro: {command} makes them",
    )
    assert run("reproduce", "--repeats", "2")[0] == 0
    assert "makes them" not in run("report", "--repeats", "2")[2]
