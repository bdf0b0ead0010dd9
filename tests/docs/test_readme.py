"""The command that the README begins with prints what the README shows."""

from pathlib import Path

import pytest

from repro.__main__ import main

ROOT = Path(__file__).parents[2]
TABLE = "docs/examples/table.md"


def test_the_readme_shows_what_its_first_command_prints(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)

    code = main(["audit", TABLE])

    paragraph, *_ = capsys.readouterr().out.splitlines()
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    assert code == 1
    assert f"`repro audit {TABLE}`" in readme
    assert paragraph in readme
